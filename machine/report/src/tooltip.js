// SPDX-License-Identifier: MIT
// What a component under the pointer is and how it does, in words.
import { element } from './dom.js';
import { METRICS } from './kinds.js';
import { show } from './machine_view/legend.js';

export function summary(run, { bin }, { kind, index }) {
    return METRICS.map((metric) => [metric.text, show(metric.key, run.kind[kind].value(metric.key, index, bin))]);
}

export function showTooltip(run, state, component, { clientX, clientY }) {
    const box = document.getElementById('tooltip');
    const kind = run.kind[component.kind];
    box.replaceChildren(
        element('strong', {}, kind.names[component.index]),
        element('dl', {}, summary(run, state, component).map(([name, text]) => element('div', {}, element('dt', {}, name), element('dd', {}, text)))),
    );
    box.hidden = false;
    const { offsetWidth: width, offsetHeight: height } = box;
    box.style.left = `${Math.min(clientX + 14, innerWidth - width - 8)}px`;
    box.style.top = `${clientY + 18 + height > innerHeight ? clientY - height - 10 : clientY + 18}px`;
}

export function hideTooltip() {
    document.getElementById('tooltip').hidden = true;
}
