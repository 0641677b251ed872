// SPDX-License-Identifier: MIT
// Processors on a sphere: each is the cell of its dual, the polygon of the middles of the triangles
// around it; links bridge the gaps between cells, a lane for each direction.
import { addRibbon, createShapes } from './shapes.js';
import { add, between, cross, dot, mean, scale, subtract, unit } from './vectors.js';

const CELL = 0.82; // of its full size, where links need room ...
const SMALL_CELL = 0.9; // ... and where it is so small that its colour is what counts
const MANY = 3000;
const WHOLE_CELL = 0.94;
const BRIDGE = [0.38, 0.62]; // the part of a link that is seen

// Middles of the triangles around each node, counter-clockwise seen from outside.
function dualCells(positions, triangles) {
    const around = positions.map(() => []);
    for (const triangle of triangles) {
        const middle = unit(mean(triangle.map((node) => positions[node])));
        triangle.forEach((node) => around[node].push(middle));
    }
    return around.map((corners, node) => sortAround(positions[node], corners));
}

function tangents(normal) {
    const east = unit(Math.abs(normal[2]) < 0.9 ? cross([0, 0, 1], normal) : cross([1, 0, 0], normal));
    return [east, cross(normal, east)];
}

function sortAround(centre, corners) {
    const [east, north] = tangents(centre);
    const angle = (corner) => Math.atan2(dot(corner, north), dot(corner, east));
    return [...corners].sort((a, b) => angle(a) - angle(b));
}

// Where nobody says what lies between nodes: patches as large as there is room for on average.
function patches(positions) {
    const radius = 0.9 * Math.sqrt(4 / positions.length);
    return positions.map((centre) => {
        const [east, north] = tangents(centre);
        return [0, 1, 2, 3, 4, 5].map((i) => {
            const angle = (i * Math.PI) / 3;
            return unit(add(centre, add(scale(east, radius * Math.cos(angle)), scale(north, radius * Math.sin(angle)))));
        });
    });
}

export function drawSphere(run) {
    const { positions, triangles } = run.drawing;
    const links = run.kind.link;
    const shapes = createShapes();
    const cells = triangles.length > 0 ? dualCells(positions, triangles) : patches(positions);
    cells.forEach((corners, node) => {
        const size = links ? (positions.length > MANY ? SMALL_CELL : CELL) : WHOLE_CELL;
        shapes.addGround(corners.map((corner) => scale(corner, 0.99)));
        shapes.addFace('node', node, corners.map((corner) => between(positions[node], corner, size)));
    });
    for (let link = 0; link < (links?.count ?? 0); ++link) {
        const from = positions[links.data.get(link, 'from')];
        const to = positions[links.data.get(link, 'to')];
        const path = BRIDGE.map((share) => scale(unit(between(from, to, share)), 1.003));
        const apart = Math.hypot(...subtract(to, from));
        addRibbon(shapes, link, path, path.map(unit), 0.09 * apart, 0.035 * apart);
    }
    return { shapes, radius: 1, target: [0, 0, 0], culls: true, view: { azimuth: 180, elevation: 14 } };
}
