// SPDX-License-Identifier: MIT
// The picture of each frame as the machine drew it, and on it the pixels of the selected processor.
import { element, heading } from './dom.js';

export function createPictures(root, run, store) {
    if (run.pictures.length === 0) {
        root.hidden = true;
        return;
    }
    const image = element('img', { class: 'picture', id: 'picture' });
    const veil = element('canvas', { class: 'veil', 'aria-hidden': 'true' });
    root.append(heading('pictures-title', 'Picture'), element('div', { class: 'easel' }, image, veil));
    if (run.pictures.length > 1) {
        root.append(frameChoice(run, store));
    }
    image.addEventListener('load', () => drawVeil(veil, image, run, store.get().selected));
    store.follow(['frame'], ({ frame }) => {
        image.src = run.pictures[frame];
        image.alt = `Frame ${frame} as the machine drew it`;
    });
    store.follow(['selected'], ({ selected }) => drawVeil(veil, image, run, selected));
}

function frameChoice(run, store) {
    const last = run.pictures.length - 1;
    const show = (frame) => store.set({ frame: Math.min(Math.max(frame, 0), last) });
    const slider = element('input', { type: 'range', min: 0, max: last, 'aria-label': 'Frame', oninput: () => show(Number(slider.value)) });
    const text = element('output', {});
    store.follow(['frame'], ({ frame }) => {
        slider.value = frame;
        text.textContent = `frame ${frame} of ${last}`;
    });
    return element('div', { class: 'frames' },
        element('button', { type: 'button', 'aria-label': 'Frame before', onclick: () => show(store.get().frame - 1) }, '\u25c0'),
        slider,
        element('button', { type: 'button', 'aria-label': 'Next frame', onclick: () => show(store.get().frame + 1) }, '\u25b6'), text);
}

// Whether node `node` draws pixel (x, y), y from the top; null where that is not known.
function ownership(run, node) {
    const { grids, owners, width, height } = run.drawing.screen;
    if (owners.length > 0) {
        return (x, y) => owners[y * width + x] === node;
    }
    if (grids.length > 0) {
        const [left, bottom, stepX, stepY, columns, rows] = grids[node];
        const on = (at, start, step, number) => at >= start && (at - start) % step === 0 && (at - start) / step < number;
        return (x, y) => on(x, left, stepX, columns) && on(height - 1 - y, bottom, stepY, rows);
    }
    return null;
}

// Everything else fades.
function drawVeil(veil, image, run, selected) {
    const owns = selected?.kind === 'node' ? ownership(run, selected.index) : null;
    veil.hidden = !owns || !image.naturalWidth;
    if (veil.hidden) {
        return;
    }
    veil.width = image.naturalWidth;
    veil.height = image.naturalHeight;
    const context = veil.getContext('2d');
    const pixels = context.createImageData(veil.width, veil.height);
    for (let y = 0; y < veil.height; ++y) {
        for (let x = 0; x < veil.width; ++x) {
            const at = 4 * (y * veil.width + x);
            const colour = owns(x, y) ? [254, 232, 56, 110] : [0, 0, 0, 120];
            pixels.data.set(colour, at);
        }
    }
    context.putImageData(pixels, 0, 0);
}
