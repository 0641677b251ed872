// SPDX-License-Identifier: MIT
// What the run was, in figures.
import { element } from './dom.js';
import { count, figures, plural, time } from './format.js';

function facts(run) {
    const { statistics } = run;
    const frames = statistics.frames;
    const drawn = frames.reduce((sum, frame) => sum + frame.duration_ps, 0);
    const list = [];
    if (frames.length > 0) {
        const mean = drawn / frames.length;
        list.push([frames.length > 1 ? `Mean of ${frames.length} frames` : 'Frame', time(mean), `${figures(1e12 / mean)} frames/s`]);
    }
    list.push(['Machine time', time(statistics.end_ps), `${count(statistics.end_u)} u of ${time(statistics.u_ps)}`]);
    for (const kind of run.kinds) {
        list.push([kind.title, count(kind.count), null]);
    }
    list.push(['Instructions', count(statistics.instructions), `${count(statistics.cycles_u)} cycles`]);
    list.push(['Messages', count(statistics.messages), `${count(statistics.bytes)} bytes`]);
    return list;
}

export function createHead(root, run) {
    const name = run.statistics.machine || 'machine';
    document.title = `${name} - Rasterloom report`;
    root.append(
        element('h1', {}, name),
        element('dl', { class: 'facts' }, facts(run).map(([term, value, more]) =>
            element('div', {}, element('dt', {}, term), element('dd', {}, value, more ? element('small', {}, more) : null)))),
    );
}

export function createFoot(root, run) {
    root.append(element('p', {}, `Emulated by Rasterloom. ${plural(run.bins, 'bin')} of ${time(run.binPs)}. `,
        'The same numbers, exact, are in statistics.json and the CSV files beside this page.'));
}
