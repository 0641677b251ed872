// SPDX-License-Identifier: MIT
// Pointer on the drawing: dragging turns it, a click selects, the wheel magnifies once the drawing
// has the focus (before, it scrolls the page).

const DEGREES_A_PIXEL = 0.35;
const CLICK = 4; // pixels that a click may move

export function handlePointer(node, actions) {
    let down = null;
    node.addEventListener('pointerdown', (event) => {
        down = { x: event.clientX, y: event.clientY, moved: 0 };
        node.setPointerCapture(event.pointerId);
    });
    node.addEventListener('pointermove', (event) => {
        if (down) {
            const by = [event.clientX - down.x, event.clientY - down.y];
            down = { x: event.clientX, y: event.clientY, moved: down.moved + Math.hypot(...by) };
            actions.turn(by[0] * DEGREES_A_PIXEL, by[1] * DEGREES_A_PIXEL);
        } else {
            actions.point(event.offsetX, event.offsetY, event);
        }
    });
    node.addEventListener('pointerup', (event) => {
        if (down && down.moved < CLICK) {
            actions.click(event.offsetX, event.offsetY);
        }
        down = null;
    });
    node.addEventListener('pointercancel', () => { down = null; });
    node.addEventListener('pointerleave', () => actions.leave());
    node.addEventListener('wheel', (event) => {
        if (document.activeElement === node) {
            event.preventDefault();
            actions.magnify(Math.exp(-event.deltaY / 600));
        }
    }, { passive: false });
}
