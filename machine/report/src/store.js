// SPDX-License-Identifier: MIT
// What is shown at the moment, in one place; every view is told what has changed.
//
//   metric    'busy', 'waiting' or 'queue'
//   bin       of the timeline; null: the whole run
//   selected  a component { kind, index }; null: none
//   frame     whose picture and critical path are shown
//   playing   whether time goes on by itself

export function createStore(initial) {
    const state = { ...initial };
    const listeners = [];
    return {
        get: () => state,
        set(changes) {
            const changed = Object.keys(changes).filter((key) => state[key] !== changes[key]);
            Object.assign(state, changes);
            if (changed.length > 0) {
                listeners.forEach((listener) => listener(state, changed));
            }
        },
        // Called once now, and whenever one of `keys` changes.
        follow(keys, listener) {
            listeners.push((now, changed) => {
                if (changed.some((key) => keys.includes(key))) {
                    listener(now);
                }
            });
            listener(state);
        },
    };
}
