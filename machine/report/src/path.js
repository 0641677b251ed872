// SPDX-License-Identifier: MIT
// The critical path of a frame: the chain of causes that made it as long as it is.
import { element, heading } from './dom.js';
import { count, percent, time } from './format.js';

const MOST_COMPONENTS = 15;

function bar(share) {
    return element('td', { class: 'bar-cell' }, element('span', { class: 'bar', style: `width:${(100 * share).toFixed(2)}%` }));
}

// Rows { cells, ps }: what it is, its time, its share of the whole as text and bar.
function barTable(title, heads, rows, whole) {
    const head = [...heads, 'Time', 'Share'].map((text) => element('th', { scope: 'col' }, text));
    const body = rows.map(({ cells, ps }) => element('tr', {}, cells.map((text) => element('td', {}, text)),
        element('td', { class: 'number', 'data-value': ps }, time(ps)), element('td', { class: 'number' }, percent(whole > 0 ? ps / whole : 0)), bar(whole > 0 ? ps / whole : 0)));
    return element('table', { class: 'bars' }, element('caption', {}, title),
        element('thead', {}, element('tr', {}, head, element('th', { 'aria-hidden': 'true' }))), element('tbody', {}, body));
}

function phaseTable(path) {
    const kinds = path.kinds.map((kind) => kind.name);
    const phases = [...new Map(path.phases.map((part) => [part.phase, part.name]))];
    const of = (phase, kind) => path.phases.find((part) => part.phase === phase && part.kind === kind)?.time_ps ?? 0;
    const rows = phases.map(([phase, name]) => {
        const times = kinds.map((kind) => of(phase, kind));
        const sum = times.reduce((a, b) => a + b, 0);
        return element('tr', {}, element('th', { scope: 'row' }, name), element('td', { class: 'number', 'data-value': sum }, time(sum)),
            times.map((ps) => element('td', { class: 'number', 'data-value': ps }, ps === 0 ? '0' : time(ps))), bar(sum / path.duration_ps));
    });
    return element('table', { class: 'bars' }, element('caption', {}, 'By phase'),
        element('thead', {}, element('tr', {}, ['Phase', 'On the path', ...kinds].map((text) => element('th', { scope: 'col' }, text)), element('th', { 'aria-hidden': 'true' }))),
        element('tbody', {}, rows));
}

// Names on the path are those of components, or for parts "3" of kind "splitter".
function selectButton(run, store, { kind, name }) {
    for (const each of run.kinds) {
        const index = Math.max(each.indexOf(name), each.indexOf(`${kind}/${name}`));
        if (index >= 0) {
            return element('button', { type: 'button', class: 'link', onclick: () => store.set({ selected: { kind: each.key, index } }) }, name);
        }
    }
    return name;
}

// Where the run looked for them (--bottlenecks).
function lineTable(path) {
    const lines = path.lines ?? [];
    return lines.length === 0 ? null : barTable('Lines of the programs', ['Line', 'Instructions'],
        lines.slice(0, MOST_COMPONENTS).map((part) => ({ cells: [`${part.file}:${part.line}`, count(part.instructions)], ps: part.time_ps })), path.duration_ps);
}

function show(body, run, store, path) {
    const whole = path.duration_ps;
    body.replaceChildren(
        element('p', {}, `Frame ${path.frame}: ${time(whole)} in ${count(path.steps)} steps, one after the other; what nobody waited for is not on the path.`),
        element('div', { class: 'path-tables' },
            barTable('By kind', ['Kind', 'Steps'], path.kinds.map((part) => ({ cells: [part.kind, count(part.steps)], ps: part.time_ps })), whole),
            phaseTable(path),
            path.activities.length > 0 ? barTable('Programs on it were at', ['Activity'], path.activities.map((part) => ({ cells: [part.name], ps: part.time_ps })), whole) : null,
            lineTable(path),
            barTable('Components', ['Kind', 'Name', 'Steps'], path.components.slice(0, MOST_COMPONENTS).map((part) => ({ cells: [part.kind, selectButton(run, store, part), count(part.steps)], ps: part.time_ps })), whole)),
    );
}

export function createPath(root, run, store) {
    const paths = run.statistics.critical_paths ?? [];
    if (paths.length === 0) {
        root.hidden = true;
        return;
    }
    const body = element('div', {});
    root.append(heading('path-title', 'Critical path', paths.length > 1 ? 'of the frame chosen above' : ''));
    if (paths.length > 1 && run.pictures.length < 2) {
        root.append(frameChoice(paths, store));
    }
    root.append(body);
    store.follow(['frame'], ({ frame }) => show(body, run, store, paths[Math.min(frame, paths.length - 1)]));
}

function frameChoice(paths, store) {
    const choice = element('select', { 'aria-label': 'Frame', onchange: () => store.set({ frame: Number(choice.value) }) },
        paths.map((path, i) => element('option', { value: i }, `frame ${path.frame}`)));
    return choice;
}
