// SPDX-License-Identifier: MIT
// What the machine as a whole was at over time.
import { createChart } from './chart.js';
import { lineColour, stateColour } from './colour.js';
import { element, heading } from './dom.js';

const eachBin = (run, value) => Array.from({ length: run.bins }, (_, bin) => value(bin));

// Shares of time of one component or, with null, of all on average; what is missing to all time is
// "halted" for processors, "idle" for others.
export function stateLayers(run, kind, component) {
    const states = kind.series.filter((series) => series.role !== 'queue');
    const mean = (series, bin) => {
        let sum = 0;
        for (let i = 0; i < series.components; ++i) {
            sum += series.at(i, bin);
        }
        return sum / series.components;
    };
    const layers = states.map((series, i) => ({
        label: series.label,
        colour: stateColour(series.name, i),
        values: eachBin(run, (bin) => (component === null ? mean(series, bin) : series.at(component, bin))),
    }));
    const seen = layers.filter((layer) => layer.values.some((value) => value > 0));
    return seen.length > 0 ? seen : layers.slice(0, 1);
}

export function haltedLayer(layers) {
    const values = layers[0].values.map((_, bin) => Math.max(0, 1 - layers.reduce((sum, layer) => sum + layer.values[bin], 0)));
    return values.some((value) => value > 0.001) ? [{ label: 'halted', colour: stateColour('halted'), values }] : [];
}

function meanAndMost(run, kind, metric, noun) {
    return [
        { label: `mean of all ${noun}`, colour: lineColour(0), values: eachBin(run, (bin) => kind.mean(metric, bin)) },
        { label: 'the greatest', colour: lineColour(1), dash: [4, 3], values: eachBin(run, (bin) => kind.most(metric, bin)) },
    ];
}

const MOST_LINES = 7;

function partLayers(run, kind) {
    if (kind.count > MOST_LINES) {
        return meanAndMost(run, kind, 'busy', 'parts');
    }
    return kind.names.map((name, i) => ({ label: name, colour: lineColour(i), values: eachBin(run, (bin) => kind.value('busy', i, bin)) }));
}

function charts(run) {
    const { node, link, part } = run.kind;
    const list = [];
    const states = stateLayers(run, node, null);
    list.push({ title: 'Processors: share of them in each state', unit: 'share', stacked: true, top: 1, layers: [...states, ...haltedLayer(states)] });
    const underWay = run.series.find((series) => series.of === 'machine');
    const sends = run.statistics.messages > 0; // lanes of an array do not
    if (underWay && sends) {
        list.push({ title: 'Messages under way', unit: 'messages', layers: [{ label: underWay.label, colour: lineColour(0), values: eachBin(run, (bin) => underWay.at(0, bin)) }] });
    }
    if (sends) {
        list.push({ title: 'Queues of processors, messages', unit: 'messages', layers: meanAndMost(run, node, 'queue', 'processors') });
    }
    if (link) {
        list.push({ title: 'Links: utilisation', unit: 'share', layers: meanAndMost(run, link, 'busy', 'links') });
    }
    if (part?.hasBins('busy')) {
        list.push({ title: 'Fabric: utilisation', unit: 'share', layers: partLayers(run, part) });
    }
    if (sends && part?.hasBins('queue')) {
        list.push({ title: 'Queues of the fabric, messages', unit: 'messages', layers: meanAndMost(run, part, 'queue', 'parts') });
    }
    return list;
}

export function createTimelines(root, run, store) {
    if (run.bins === 0) {
        root.hidden = true;
        return;
    }
    const grid = element('div', { class: 'charts' });
    root.append(heading('timelines-title', 'Over time', 'a click chooses a time'), grid);
    const made = charts(run).map((spec) => createChart(grid, run, store, spec));
    store.follow(['bin'], () => made.forEach((chart) => chart.redraw()));
}
