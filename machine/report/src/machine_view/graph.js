// SPDX-License-Identifier: MIT
// Processors in a plane, as discs where the topology puts them; each direction of a link is a lane of
// its own, on the right. A link that would run over other processors bends around them.
import { addParts } from './parts.js';
import { addRibbon, createShapes } from './shapes.js';
import { add, between, length, scale, subtract } from './vectors.js';

const CORNERS = 28;
const LARGEST = 0.13;
const UP = [0, 0, 1];
const MOST_CHECKS = 2e7;

function spacing(positions, links) {
    const apart = [];
    for (let link = 0; link < (links?.count ?? 0); ++link) {
        apart.push(length(subtract(positions[links.data.get(link, 'from')], positions[links.data.get(link, 'to')])));
    }
    apart.sort((a, b) => a - b);
    return apart[Math.floor(apart.length / 4)] || Math.sqrt(4 / positions.length);
}

function disc(centre, radius) {
    return Array.from({ length: CORNERS }, (_, i) => {
        const angle = (2 * Math.PI * i) / CORNERS;
        return add(centre, [radius * Math.cos(angle), radius * Math.sin(angle), 0]);
    });
}

function runsOver(positions, from, to, radius) {
    const way = subtract(positions[to], positions[from]);
    const whole = length(way);
    return positions.some((at, node) => {
        if (node === from || node === to) {
            return false;
        }
        const share = ((at[0] - positions[from][0]) * way[0] + (at[1] - positions[from][1]) * way[1]) / whole ** 2;
        return share > 0 && share < 1 && length(subtract(between(positions[from], positions[to], share), at)) < 1.4 * radius;
    });
}

// From rim to rim; bent ones rise above the plane, too.
function linkPath(from, to, radius, bend) {
    const way = subtract(to, from);
    const whole = length(way);
    const right = [way[1] / whole, -way[0] / whole, 0];
    const steps = bend > 0 ? 16 : 1;
    return Array.from({ length: steps + 1 }, (_, i) => {
        const share = radius / whole + (i / steps) * (1 - (2 * radius) / whole);
        const away = 4 * share * (1 - share);
        return add(add(between(from, to, share), scale(right, bend * away)), [0, 0, 0.5 * bend * away + 0.002]);
    });
}

export function drawGraph(run) {
    const { positions } = run.drawing;
    const links = run.kind.link;
    const shapes = createShapes();
    const apart = spacing(positions, links);
    const radius = Math.min(0.34 * apart, LARGEST);
    positions.forEach((at, node) => {
        shapes.addGround(disc(add(at, [0, 0, -0.002]), 1.12 * radius));
        shapes.addFace('node', node, disc(at, radius));
    });
    let bent = false;
    const checks = positions.length * (links?.count ?? 0) < MOST_CHECKS;
    for (let link = 0; link < (links?.count ?? 0); ++link) {
        const from = links.data.get(link, 'from');
        const to = links.data.get(link, 'to');
        const bends = checks && runsOver(positions, from, to, radius);
        bent ||= bends;
        const path = linkPath(positions[from], positions[to], 1.1 * radius, bends ? 0.5 * apart : 0);
        addRibbon(shapes, link, path, path.map(() => UP), (bends ? 0.16 : 0.3) * radius, 0.12 * radius);
    }
    const { parts } = run.drawing;
    addParts(shapes, run, positions.map((at) => ({ middle: at, area: (2 * radius) ** 2, bottom: at[1] - radius })));
    return {
        shapes,
        radius: parts.length > 0 ? 1.45 : Math.max(...positions.map(length)) + 1.5 * radius,
        target: [0, 0, parts.length > 0 ? 0.42 : 0],
        culls: false,
        view: { azimuth: -90, elevation: parts.length > 0 ? 30 : bent ? 62 : 88 },
    };
}
