// SPDX-License-Identifier: MIT
// The machine as what it is, in colours of the chosen quantity at the chosen time.
import { channels, onThemeChange, scaleColour, themeColour } from '../colour.js';
import { coalesced, element, heading, onResize } from '../dom.js';
import { plural } from '../format.js';
import { colourReach } from '../kinds.js';
import { hideTooltip, showTooltip } from '../tooltip.js';
import { createCamera } from './camera.js';
import { createFlat } from './flat.js';
import { drawGraph } from './graph.js';
import { handleKeys, KEYS_TEXT } from './keyboard.js';
import { createLegend } from './legend.js';
import { createOverlay } from './overlay.js';
import { handlePointer } from './pointer.js';
import { drawScreen } from './screen.js';
import { createSeen } from './seen.js';
import { drawSphere } from './sphere.js';
import { createWebgl } from './webgl.js';

const LAYOUTS = { sphere: drawSphere, plane: drawGraph, screen: drawScreen };

export function createMachineView(root, run, store) {
    const model = LAYOUTS[run.drawing.layout](run);
    const canvas = element('canvas', { class: 'drawing' });
    const over = element('canvas', { class: 'drawing', 'aria-hidden': 'true' });
    const stand = element('div', { class: 'stand', id: 'drawing', tabindex: 0, role: 'application', 'aria-label': describe(run), 'aria-describedby': 'drawing-keys' }, canvas, over);
    const note = element('p', { class: 'note', id: 'drawing-keys' }, KEYS_TEXT);
    root.append(heading('machine-title', 'Machine'), createLegend(run, store), stand, ...explanations(run), note);
    const renderer = createWebgl(canvas, model) ?? withoutWebgl(root, canvas, model);
    stand.dataset.renderer = renderer.name;
    stand.dataset.cells = model.shapes.items.filter((item) => item.kind === 'node' && item.faces.length > 0).length;
    stand.dataset.parts = model.shapes.items.filter((item) => item.kind === 'part' && item.faces.length > 0).length;
    const view = createView(run, store, model, renderer, stand, over);
    handleKeys(stand, view.actions);
    handlePointer(stand, view.actions);
}

function explanations(run) {
    const shared = run.drawing.screen.grids.some(([, , stepX, stepY]) => stepX > 1 || stepY > 1);
    return [
        run.kind.link ? 'Each direction of a link is a strip on its right, wide where it begins.' : null,
        shared ? 'Processors that share a part of the screen pixel by pixel are drawn as one of its blocks of pixels, enlarged; the picture shows the pixels of a selected one.' : null,
    ].filter((text) => text !== null).map((text) => element('p', { class: 'note' }, text));
}

function describe(run) {
    return `Drawing of ${run.kinds.map((kind) => plural(kind.count, kind.noun)).join(', ')}`;
}

function withoutWebgl(root, canvas, model) {
    root.append(element('p', { class: 'note', id: 'no-webgl' }, 'This browser offers no WebGL: the machine is drawn flat, which is slower to turn.'));
    return createFlat(canvas, model);
}

// Grey where a component's quantity is not known over time.
function colouring(run, model, { metric, bin }) {
    const limits = Object.fromEntries(run.kinds.map((kind) => [kind.key, colourReach(kind, metric, bin) || 1]));
    const ground = channels(themeColour('ground'));
    const unknown = channels(themeColour('unknown'));
    return (face) => {
        if (face.item < 0) {
            return ground;
        }
        const { kind, index } = model.shapes.items[face.item];
        const value = run.kind[kind].value(metric, index, bin);
        return (value === null ? unknown : scaleColour(value / limits[kind])).map((channel) => channel * face.shade);
    };
}

function createView(run, store, model, renderer, stand, over) {
    const { shapes } = model;
    const camera = createCamera(model);
    const seen = createSeen(model, camera);
    const overlay = createOverlay(over, run, model, seen);
    let pointed = -1;

    const selectedItem = () => {
        const { selected } = store.get();
        return selected ? shapes.find(selected.kind, selected.index) : -1;
    };
    const redraw = coalesced(() => {
        camera.resize(Math.max(stand.clientWidth, 1), Math.max(stand.clientHeight, 1));
        seen.changed();
        renderer.draw(camera);
        overlay.draw(camera, selectedItem(), pointed);
    });
    const redrawOverlay = coalesced(() => overlay.draw(camera, selectedItem(), pointed));
    const recolour = () => {
        renderer.colour(colouring(run, model, store.get()));
        redraw();
    };
    const select = (item) => {
        const { kind, index } = shapes.items[item] ?? {};
        store.set({ selected: item < 0 ? null : { kind, index } });
    };
    // On a sphere what is selected elsewhere, or by key, may lie on the far side.
    const showSelected = () => {
        const item = selectedItem();
        if (item >= 0 && model.culls && !isInView(camera, shapes.items[item].anchor)) {
            camera.lookAtPoint(shapes.items[item].anchor);
            redraw();
        } else {
            redrawOverlay();
        }
    };
    const kindNow = () => store.get().selected?.kind ?? 'node';

    const actions = {
        turn(right, up) { camera.turn(right, up); redraw(); },
        magnify(by) { camera.magnify(by); redraw(); },
        reset() { camera.reset(); redraw(); },
        clear: () => select(-1),
        move: (direction) => select(seen.next(selectedItem(), direction, kindNow())),
        step(by) {
            const { count } = run.kind[kindNow()];
            const index = store.get().selected?.index ?? (by > 0 ? -1 : 0);
            select(shapes.find(kindNow(), (index + by + count) % count));
        },
        nextKind() {
            const keys = run.kinds.map((kind) => kind.key);
            select(shapes.find(keys[(keys.indexOf(kindNow()) + 1) % keys.length], 0));
        },
        point(x, y, event) {
            pointed = seen.at(x, y);
            if (pointed < 0) {
                hideTooltip();
            } else {
                showTooltip(run, store.get(), shapes.items[pointed], event);
            }
            redrawOverlay();
        },
        leave() { pointed = -1; hideTooltip(); redrawOverlay(); },
        click: (x, y) => select(seen.at(x, y)),
    };

    store.follow(['metric', 'bin'], recolour);
    store.follow(['selected'], showSelected);
    onResize(stand, redraw);
    onThemeChange(recolour);
    return { actions };
}

function isInView(camera, point) {
    const { back } = camera.axes();
    return point[0] * back[0] + point[1] * back[1] + point[2] * back[2] > 0.25 * Math.hypot(...point);
}
