// SPDX-License-Identifier: MIT
// A machine as coloured faces and lines in space, whoever draws them: flat convex polygons, each of
// a component or (item -1) of the ground below, and lines that carry no value.
import { mean } from './vectors.js';

export function createShapes() {
    const items = []; // { kind, index, faces: [face], anchor }
    const itemOf = new Map();
    const faces = []; // { item, points, layer }
    const lines = []; // [from, to]

    function itemFor(kind, index) {
        const key = `${kind}/${index}`;
        if (!itemOf.has(key)) {
            itemOf.set(key, items.length);
            items.push({ kind, index, faces: [], anchor: null });
        }
        return itemOf.get(key);
    }

    return {
        items,
        faces,
        lines,
        find: (kind, index) => itemOf.get(`${kind}/${index}`) ?? -1,
        addFace(kind, index, points, shade = 1) {
            const item = itemFor(kind, index);
            items[item].faces.push(faces.length);
            items[item].anchor ??= mean(points);
            faces.push({ item, points, shade, layer: kind === 'link' ? 2 : 1 });
        },
        addGround: (points, layer = 0) => faces.push({ item: -1, points, shade: 1, layer }),
        addLine: (from, to) => lines.push([from, to]),
    };
}

// Many lines must not hide what is behind them.
export function lineStrength(lines) {
    return Math.min(1, Math.max(0.45, 48 / lines.length));
}

// A ribbon along a path on a surface, to the right of its middle line, narrower towards its end so
// that one sees which way it leads.
export function addRibbon(shapes, index, path, normals, width, gap) {
    const quads = ribbonQuads(path, normals, width, gap);
    quads.forEach((quad) => shapes.addFace('link', index, quad));
    const item = shapes.items[shapes.find('link', index)];
    item.anchor = mean(quads[Math.floor(quads.length / 2)]);
}

function ribbonQuads(path, normals, width, gap) {
    const sides = path.map((point, i) => {
        const before = path[Math.max(i - 1, 0)];
        const after = path[Math.min(i + 1, path.length - 1)];
        const right = rightOf(before, after, normals[i]);
        const share = i / (path.length - 1);
        const inner = gap / 2;
        const outer = inner + width * (1 - 0.6 * share);
        return [inner, outer].map((away) => point.map((value, axis) => value + right[axis] * away));
    });
    return sides.slice(1).map(([inner, outer], i) => [sides[i][0], sides[i][1], outer, inner]);
}

function rightOf(from, to, normal) {
    const [x, y, z] = to.map((value, axis) => value - from[axis]);
    const right = [y * normal[2] - z * normal[1], z * normal[0] - x * normal[2], x * normal[1] - y * normal[0]];
    const size = Math.hypot(...right) || 1;
    return right.map((value) => value / size);
}

// The faces of a box whose sides are parallel to the axes; brighter above, darker at the sides.
export function addBox(shapes, kind, index, [x, y, z], [halfX, halfY, halfZ]) {
    const corner = (i, j, k) => [x + i * halfX, y + j * halfY, z + k * halfZ];
    const sides = [
        [1, [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]]],
        [0.7, [[-1, 1, -1], [1, 1, -1], [1, -1, -1], [-1, -1, -1]]],
        [0.88, [[-1, -1, -1], [1, -1, -1], [1, -1, 1], [-1, -1, 1]]],
        [0.88, [[1, 1, -1], [-1, 1, -1], [-1, 1, 1], [1, 1, 1]]],
        [0.78, [[1, -1, -1], [1, 1, -1], [1, 1, 1], [1, -1, 1]]],
        [0.78, [[-1, 1, -1], [-1, -1, -1], [-1, -1, 1], [-1, 1, 1]]],
    ];
    sides.forEach(([shade, corners]) => shapes.addFace(kind, index, corners.map((each) => corner(...each)), shade));
    shapes.items[shapes.find(kind, index)].anchor = [x, y, z];
}
