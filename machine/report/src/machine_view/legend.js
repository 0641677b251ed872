// SPDX-License-Identifier: MIT
// What the colours mean, in numbers.
import { gradient } from '../colour.js';
import { element } from '../dom.js';
import { figures, percent } from '../format.js';
import { colourReach, METRICS } from '../kinds.js';

export function show(metric, value) {
    if (value === null) {
        return 'not recorded over time';
    }
    const { unit } = METRICS.find((each) => each.key === metric);
    return unit === 'share' ? percent(value) : figures(value, 3);
}

export function createLegend(run, store) {
    const least = element('span', {});
    const most = run.kinds.map((kind) => element('span', { 'data-kind': kind.key }));
    const title = element('span', { class: 'legend-title' });
    const bar = element('span', { class: 'legend-bar', style: `background:${gradient()}`, 'aria-hidden': 'true' });
    store.follow(['metric', 'bin'], ({ metric, bin }) => {
        const { title: name, unit } = METRICS.find((each) => each.key === metric);
        title.textContent = unit === 'share' ? `${name}, share of ${bin === null ? 'the run' : 'this time'}` : `${name}, messages on average`;
        least.textContent = show(metric, 0);
        run.kinds.forEach((kind, i) => {
            const text = bin !== null && !kind.hasBins(metric) ? 'not recorded over time' : show(metric, colourReach(kind, metric, bin));
            most[i].textContent = `${kind.title.toLowerCase()} ${text}`;
        });
    });
    return element('div', { class: 'legend', role: 'note' }, title, least, bar, most);
}
