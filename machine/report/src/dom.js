// SPDX-License-Identifier: MIT
// Elements in one expression: element('button', { class: 'x', onclick }, 'text', child).

const SVG = 'http://www.w3.org/2000/svg';

function fill(node, attributes, children) {
    for (const [name, value] of Object.entries(attributes)) {
        if (name.startsWith('on')) {
            node.addEventListener(name.slice(2), value);
        } else if (value === true) {
            node.setAttribute(name, '');
        } else if (value !== false && value !== null && value !== undefined) {
            node.setAttribute(name, value);
        }
    }
    node.append(...children.flat().filter((child) => child !== null && child !== undefined));
    return node;
}

export function element(tag, attributes = {}, ...children) {
    return fill(document.createElement(tag), attributes, children);
}

export function svg(tag, attributes = {}, ...children) {
    return fill(document.createElementNS(SVG, tag), attributes, children);
}

export function heading(id, text, note = null) {
    return element('h2', { id }, text, note ? element('small', {}, ` ${note}`) : null);
}

// At most once a frame, however often it is asked for.
export function coalesced(work) {
    let due = false;
    return () => {
        if (!due) {
            due = true;
            requestAnimationFrame(() => {
                due = false;
                work();
            });
        }
    };
}

export function onResize(node, callback) {
    new ResizeObserver(coalesced(callback)).observe(node);
}
