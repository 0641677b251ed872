// SPDX-License-Identifier: MIT
// How often each value came: busy time of processors, their fullest queues, latencies and hops of
// messages.
import { element, heading, svg } from './dom.js';
import { count, percent, time } from './format.js';

const WIDTH = 420;
const HEIGHT = 170;
const MARGIN = { left: 46, right: 8, top: 10, bottom: 34 };
const BINS = 20;

// Bars { from, to, count } of a value of each component, equally wide.
function equalBars(values, format) {
    const most = Math.max(...values, 0) || 1;
    const bars = Array.from({ length: BINS }, (_, i) => ({ from: (i / BINS) * most, to: ((i + 1) / BINS) * most, count: 0 }));
    values.forEach((value) => { bars[Math.min(Math.floor((value / most) * BINS), BINS - 1)].count += 1; });
    return bars.map((bar) => ({ ...bar, label: `${format(bar.from)} to ${format(bar.to)}`, tick: format(bar.from), end: format(bar.to) }));
}

// One bar a whole number.
function numberBars(pairs) {
    const counts = new Map(pairs);
    const last = Math.max(...counts.keys(), 0);
    const first = Math.min(...counts.keys(), last);
    return Array.from({ length: last - first + 1 }, (_, i) => ({ count: counts.get(first + i) ?? 0, label: String(first + i), tick: String(first + i) }));
}

function tally(values) {
    const counts = new Map();
    values.forEach((value) => counts.set(value, (counts.get(value) ?? 0) + 1));
    return [...counts];
}

// Classes are an eighth of a power of two wide at the least; between the first and the last all are shown.
function latencyBars(pairs) {
    const counts = new Map(pairs);
    const last = Math.max(...counts.keys());
    const bars = [];
    for (let from = Math.min(...counts.keys()); from <= last;) {
        const to = from < 8 ? from + 1 : from + 2 ** (Math.floor(Math.log2(from)) - 3);
        bars.push({ count: counts.get(from) ?? 0, label: `${time(from, 3)} to ${time(to, 3)}`, tick: time(from, 3), end: time(to, 3) });
        from = to;
    }
    return bars;
}

function axisLabels(bars) {
    const every = Math.ceil(bars.length / 6);
    const wide = (WIDTH - MARGIN.left - MARGIN.right) / bars.length;
    return bars.flatMap((bar, i) => (i % every === 0
        ? [svg('text', { x: MARGIN.left + wide * (bar.end === undefined ? i + 0.5 : i), y: HEIGHT - MARGIN.bottom + 14, class: 'axis', 'text-anchor': bar.end === undefined ? 'middle' : 'start' }, bar.tick)]
        : []));
}

function draw({ title, what, unit, bars }) {
    const most = Math.max(...bars.map((bar) => bar.count), 1);
    const wide = (WIDTH - MARGIN.left - MARGIN.right) / bars.length;
    const tall = HEIGHT - MARGIN.top - MARGIN.bottom;
    const columns = bars.map((bar, i) => {
        const height = bar.count > 0 ? Math.max((bar.count / most) * tall, 1) : 0;
        return svg('rect', { x: MARGIN.left + i * wide + 0.5, y: MARGIN.top + tall - height, width: Math.max(wide - 1, 0.5), height, class: 'bar' },
            svg('title', {}, `${bar.label}: ${count(bar.count)}`));
    });
    const tops = (most > 1 ? [0, 0.5, 1] : [0, 1]).map((share) => svg('text', { x: MARGIN.left - 6, y: MARGIN.top + tall * (1 - share) + 4, class: 'axis', 'text-anchor': 'end' }, count(Math.round(share * most))));
    const base = svg('line', { x1: MARGIN.left, x2: WIDTH - MARGIN.right, y1: MARGIN.top + tall, y2: MARGIN.top + tall, class: 'base' });
    const caption = svg('text', { x: (MARGIN.left + WIDTH) / 2, y: HEIGHT - 4, class: 'axis', 'text-anchor': 'middle' }, unit);
    const highest = bars.find((bar) => bar.count === most) ?? bars[0];
    return element('figure', { class: 'histogram' }, element('figcaption', {}, title),
        svg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', 'aria-label': `${title}: ${bars.length} bars, most ${what} (${count(most)}) at ${highest.label}` },
            tops, base, columns, axisLabels(bars), caption),
        numbers(bars, what));
}

function numbers(bars, what) {
    const rows = bars.filter((bar) => bar.count > 0).map((bar) => element('tr', {}, element('td', {}, bar.label), element('td', {}, count(bar.count))));
    return element('details', {}, element('summary', {}, 'As numbers'),
        element('table', { class: 'small' }, element('thead', {}, element('tr', {}, element('th', {}, 'Value'), element('th', {}, what))), element('tbody', {}, rows)));
}

function histograms(run) {
    const { node } = run.kind;
    const { latency_ps: latency, hops } = run.histograms;
    const column = (name) => node.data.rows.map((_, i) => node.data.get(i, name));
    const list = [{ title: 'Busy time of processors', what: 'processors', unit: 'busy, share of the run', bars: equalBars(node.names.map((_, i) => node.value('busy', i, null)), percent) }];
    if (latency.length > 0) {
        list.push({ title: 'Fullest input queue of processors', what: 'processors', unit: 'messages', bars: numberBars(tally(column('peak_input_queue'))) });
        list.push({ title: 'Latency of messages', what: 'messages', unit: 'from being sent to being read, over one hop', bars: latencyBars(latency) });
    }
    if (run.kind.link) {
        list.push({ title: 'Fullest output queue of processors', what: 'processors', unit: 'messages', bars: numberBars(tally(column('peak_output_queue'))) });
        list.push({ title: 'Messages that went so many hops or more', what: 'messages', unit: 'hops', bars: numberBars(hops) });
    }
    return list;
}

export function createHistograms(root, run) {
    root.append(heading('histograms-title', 'Distributions'), element('div', { class: 'histograms' }, histograms(run).map(draw)));
}
