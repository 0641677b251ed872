// SPDX-License-Identifier: MIT
// Keys of the drawing: arrows turn it, with Shift they move the selection.

const TURN = 6; // degrees
const DIRECTIONS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export const KEYS_TEXT = 'Arrow keys turn, plus and minus magnify, Home resets. Shift and arrows move the selection to the next component, '
    + 'N and P to the next and previous by number, K to another sort of component, Escape clears it.';

// `actions`: turn(right, up), magnify(by), reset(), move(direction), step(by), nextKind(), clear().
export function handleKeys(node, actions) {
    const keys = {
        '+': () => actions.magnify(1.2),
        '=': () => actions.magnify(1.2),
        '-': () => actions.magnify(1 / 1.2),
        Home: actions.reset,
        Escape: actions.clear,
        n: () => actions.step(1),
        p: () => actions.step(-1),
        k: actions.nextKind,
    };
    node.addEventListener('keydown', (event) => {
        if (event.ctrlKey || event.altKey || event.metaKey) {
            return;
        }
        const direction = DIRECTIONS[event.key];
        const action = direction ? () => arrow(actions, direction, event.shiftKey) : keys[event.key] ?? keys[event.key.toLowerCase()];
        if (action) {
            event.preventDefault();
            action();
        }
    });
}

function arrow(actions, [right, down], shifted) {
    if (shifted) {
        actions.move([right, down]);
    } else {
        actions.turn(-right * TURN, -down * TURN);
    }
}
