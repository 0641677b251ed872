// SPDX-License-Identifier: MIT
// Processors as their parts of the screen, which lies on the ground; above it the tree by which
// polygons come, the host on top; below it what takes their pixels.
import { addParts } from './parts.js';
import { createShapes } from './shapes.js';

const GAP = 0.05; // of a cell, left free around it

function placeCells(run) {
    const { width, height, cells } = run.drawing.screen;
    const unit = 2 / Math.max(width, height);
    return cells.map(([x, y, w, h]) => {
        const left = (x - width / 2) * unit;
        const bottom = (y - height / 2) * unit;
        return { left, bottom, wide: w * unit, high: h * unit, middle: [left + (w * unit) / 2, bottom + (h * unit) / 2, 0], area: w * h * unit * unit };
    });
}

function rectangle(left, bottom, right, top, z) {
    return [[left, bottom, z], [right, bottom, z], [right, top, z], [left, top, z]];
}

function addCells(shapes, cells) {
    cells.forEach(({ left, bottom, wide, high }, node) => {
        shapes.addGround(rectangle(left, bottom, left + wide, bottom + high, -0.004));
        shapes.addFace('node', node, rectangle(left + GAP * wide, bottom + GAP * high, left + (1 - GAP) * wide, bottom + (1 - GAP) * high, 0));
    });
}

export function drawScreen(run) {
    const shapes = createShapes();
    const cells = placeCells(run);
    addCells(shapes, cells);
    addParts(shapes, run, cells);
    return { shapes, radius: 1.45, target: [0, 0, 0.42], culls: false, view: { azimuth: -106, elevation: 24 } };
}
