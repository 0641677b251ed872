// SPDX-License-Identifier: MIT
// The selected component: how it does at the chosen time, its own timeline, all that is counted of
// it, and what it is connected with.
import { createChart } from './chart.js';
import { lineColour } from './colour.js';
import { describeBin } from './controls.js';
import { element, heading } from './dom.js';
import { cell, label } from './format.js';
import { haltedLayer, stateLayers } from './timelines.js';
import { summary } from './tooltip.js';

export function createDetails(root, run, store) {
    const body = element('div', { class: 'details-body' });
    const live = element('p', { class: 'unseen', 'aria-live': 'polite', id: 'live' });
    root.append(heading('details-title', 'Selected'), finder(run, store), body, live);
    let charts = [];
    store.follow(['selected'], ({ selected }) => {
        charts.forEach((chart) => chart.remove());
        body.replaceChildren();
        charts = selected ? fill(body, run, store, selected) : empty(body);
    });
    store.follow(['selected', 'bin'], (state) => {
        charts.forEach((chart) => chart.redraw());
        if (state.selected) {
            body.querySelector('.now').replaceChildren(...now(run, state));
            announce(live, run, state);
        }
    });
}

function empty(body) {
    body.append(element('p', { class: 'note' }, 'Nothing: click a component, type its name, or use the keys of the drawing.'));
    return [];
}

// One field for every component's name.
function finder(run, store) {
    const field = element('input', {
        type: 'text', id: 'find', list: 'names', placeholder: 'Name of a component', 'aria-label': 'Select a component by name', autocomplete: 'off',
        onchange: () => {
            const kind = run.kinds.find((each) => each.indexOf(field.value.trim()) >= 0);
            field.setAttribute('aria-invalid', !kind);
            if (kind) {
                store.set({ selected: { kind: kind.key, index: kind.indexOf(field.value.trim()) } });
            }
        },
    });
    const names = run.kinds.filter((kind) => kind.key !== 'link').flatMap((kind) => kind.names.slice(0, 1000));
    return element('div', { class: 'finder' }, field, element('datalist', { id: 'names' }, names.map((name) => element('option', { value: name }))));
}

function now(run, state) {
    return [
        element('p', { class: 'note' }, describeBin(run, state.bin)),
        element('dl', { class: 'facts' }, summary(run, state, state.selected).map(([name, text]) =>
            element('div', {}, element('dt', {}, name), element('dd', { 'data-metric': name }, text)))),
    ];
}

function announce(live, run, state) {
    const { kind, index } = state.selected;
    const values = summary(run, state, state.selected).map(([name, text]) => `${name} ${text}`).join(', ');
    if (!state.playing) {
        live.textContent = `${run.kind[kind].noun} ${run.kind[kind].names[index]}, ${describeBin(run, state.bin)}: ${values}`;
    }
}

function chartsOf(run, kind, index) {
    const list = [];
    const states = stateLayers(run, kind, index);
    if (states.length > 0) {
        const rest = kind.key === 'node' ? haltedLayer(states) : [];
        list.push({ title: 'Share of time in each state', unit: 'share', stacked: true, top: 1, layers: [...states, ...rest] });
    }
    const queues = kind.series.filter((series) => series.role === 'queue');
    if (queues.length > 0) {
        const values = (series) => Array.from({ length: run.bins }, (_, bin) => series.at(index, bin));
        list.push({ title: 'Messages in its queues', unit: 'messages', layers: queues.map((series, i) => ({ label: series.label, colour: lineColour(i), values: values(series) })) });
    }
    return list;
}

function fill(body, run, store, { kind: key, index }) {
    const kind = run.kind[key];
    body.append(element('h3', { id: 'selected-name' }, kind.names[index], element('small', {}, ` ${kind.data.get(index, 'kind') ?? kind.noun}`)), element('div', { class: 'now' }));
    const charts = run.bins > 0 ? chartsOf(run, kind, index).map((spec) => createChart(body, run, store, spec)) : [];
    body.append(connections(run, store, key, index), counted(kind, index));
    return charts;
}

function counted(kind, index) {
    const columns = kind.data.columns.filter((column) => !/name|^node$|^kind$|^from$|^to$|in_phase/.test(column));
    return element('details', {}, element('summary', {}, 'All that was counted'),
        element('dl', { class: 'counted' }, columns.map((column) => {
            const value = kind.data.get(index, column);
            return element('div', {}, element('dt', {}, label(column)), element('dd', { 'data-value': value }, cell(column, value)));
        })));
}

function neighbours(run, key, index) {
    const { parts, fed_by: fedBy } = run.drawing;
    const links = run.kind.link?.data;
    if (key === 'link') {
        return [['node', links.get(index, 'from')], ['node', links.get(index, 'to')]];
    }
    if (key === 'part') {
        const above = parts[index].parent === null ? [] : [['part', parts[index].parent]];
        const below = parts.flatMap((part, i) => (part.parent === index ? [['part', i]] : []));
        return [...above, ...below, ...fedBy.flatMap((part, node) => (part === index ? [['node', node]] : []))];
    }
    const outgoing = links ? links.rows.flatMap((_, link) => (links.get(link, 'from') === index ? [['node', links.get(link, 'to')]] : [])) : [];
    const feeder = fedBy[index] ?? null;
    return feeder === null ? outgoing : [['part', feeder], ...outgoing];
}

const MOST_BUTTONS = 24;

function connections(run, store, key, index) {
    const all = neighbours(run, key, index);
    return element('p', { class: 'connections' }, all.length > 0 ? 'Connected with ' : '', all.slice(0, MOST_BUTTONS).map(([kind, other]) =>
        element('button', { type: 'button', class: 'link', onclick: () => store.set({ selected: { kind, index: other } }) }, run.kind[kind].names[other])),
    all.length > MOST_BUTTONS ? ` and ${all.length - MOST_BUTTONS} more` : '');
}
