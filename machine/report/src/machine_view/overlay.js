// SPDX-License-Identifier: MIT
// What lies over the drawing: names, where there is room for them, and a frame around the selected
// component, light in dark so that it shows on any colour.
import { themeColour } from '../colour.js';

const MOST_NAMES = 48;

function stroke(context, corners, width, colour) {
    context.beginPath();
    corners.forEach(([x, y]) => context.lineTo(x, y));
    context.closePath();
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.lineJoin = 'round';
    context.stroke();
}

function write(context, text, x, y) {
    context.lineWidth = 3;
    context.strokeStyle = themeColour('panel');
    context.strokeText(text, x, y);
    context.fillStyle = themeColour('text');
    context.fillText(text, x, y);
}

function names(run, model) {
    const named = ['node', 'part'].filter((key) => run.kind[key] && run.kind[key].count <= MOST_NAMES);
    return model.shapes.items.flatMap(({ kind, index }, item) => (named.includes(kind) ? [{ item, text: run.kind[kind].names[index], kind }] : []));
}

export function createOverlay(canvas, run, model, seen) {
    const context = canvas.getContext('2d');
    const texts = names(run, model);
    return {
        draw(camera, selected, pointed) {
            canvas.width = camera.width * devicePixelRatio;
            canvas.height = camera.height * devicePixelRatio;
            context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
            context.font = '12px system-ui, sans-serif';
            context.textBaseline = 'middle';
            for (const { item, text, kind } of texts) {
                const [x, y] = seen.anchor(item);
                context.textAlign = kind === 'node' ? 'center' : 'left';
                write(context, text, kind === 'node' ? x : x + 12, y);
            }
            for (const [item, light] of [[pointed, 1.5], [selected, 2.5]]) {
                if (item >= 0) {
                    const outlines = seen.outlines(item);
                    outlines.forEach((corners) => stroke(context, corners, light + 3.5, '#000'));
                    outlines.forEach((corners) => stroke(context, corners, light, '#fff'));
                }
            }
        },
    };
}
