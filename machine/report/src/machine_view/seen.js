// SPDX-License-Identifier: MIT
// Where components appear: which one is at a point, which one is next to another.
import { projector } from './camera.js';
import { facesViewer } from './flat.js';

function inside(corners, x, y) {
    let within = false;
    for (let i = 0, before = corners.length - 1; i < corners.length; before = i++) {
        const [ax, ay] = corners[i];
        const [bx, by] = corners[before];
        if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) {
            within = !within;
        }
    }
    return within;
}

export function createSeen(model, camera) {
    const { shapes, culls } = model;
    let projected = null; // [face]: corners; null: turned away

    function faces() {
        projected ??= shapes.faces.map(({ points }) => {
            const corners = points.map(projector(camera));
            return culls && !facesViewer(corners) ? null : corners;
        });
        return projected;
    }

    const isSeen = (item) => shapes.items[item].faces.some((face) => faces()[face] !== null);
    const anchor = (item) => projector(camera)(shapes.items[item].anchor);

    return {
        changed: () => { projected = null; },
        isSeen,
        anchor,
        // Of a body the faces towards the viewer.
        outlines(item) {
            const all = shapes.items[item].faces.map((face) => faces()[face]).filter((corners) => corners !== null);
            const towards = all.filter(facesViewer);
            return towards.length > 0 ? towards : all;
        },
        at(x, y) {
            let best = { item: -1, away: Infinity, layer: -1 };
            faces().forEach((corners, face) => {
                const { item, layer } = shapes.faces[face];
                if (item >= 0 && corners !== null && inside(corners, x, y)) {
                    const away = corners.reduce((sum, corner) => sum + corner[2], 0) / corners.length;
                    if (culls ? layer >= best.layer : away < best.away) {
                        best = { item, away, layer };
                    }
                }
            });
            return best.item;
        },
        // The nearest of the same sort in a direction on the screen, within 60 degrees of it; without
        // `from` the one nearest to the middle.
        next(from, direction, kind) {
            const start = from < 0 ? [camera.width / 2, camera.height / 2] : anchor(from);
            let best = { item: from, cost: Infinity };
            shapes.items.forEach((each, item) => {
                if (item === from || each.kind !== kind || !isSeen(item)) {
                    return;
                }
                const [x, y] = anchor(item);
                const way = [x - start[0], y - start[1]];
                const whole = Math.hypot(...way);
                const along = from < 0 ? whole : way[0] * direction[0] + way[1] * direction[1];
                const cost = from < 0 ? whole : whole * (2 - along / whole);
                if ((from < 0 || along > 0.5 * whole) && cost < best.cost) {
                    best = { item, cost };
                }
            });
            return best.item;
        },
    };
}
