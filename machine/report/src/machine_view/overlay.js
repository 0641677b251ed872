// SPDX-License-Identifier: MIT
// What lies over the drawing: names, where there is room for them, and a frame around the selected
// component, light in dark so that it shows on any colour.
import { themeColour } from '../colour.js';

const MOST_NAMES = 48;
const SIDE = 26; // pixels beside a part's middle at most

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

function beside(outlines, x) {
    const right = Math.max(...outlines.flat().map((corner) => corner[0]));
    return Math.min(right + 4, x + SIDE);
}

// Those of what is selected or pointed at first; one that would run over another is left out.
function writeNames(context, texts, seen, first) {
    const taken = [];
    const inOrder = [...texts].sort((a, b) => first.includes(b.item) - first.includes(a.item));
    for (const { item, text, kind } of inOrder) {
        const [x, y] = seen.anchor(item);
        const width = context.measureText(text).width;
        const left = kind === 'node' ? x - width / 2 : beside(seen.outlines(item), x);
        const box = [left, y - 7, left + width, y + 7];
        if (taken.every((other) => box[0] > other[2] || box[2] < other[0] || box[1] > other[3] || box[3] < other[1])) {
            taken.push(box);
            write(context, text, left, y);
        }
    }
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
            writeNames(context, texts, seen, [selected, pointed]);
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
