// SPDX-License-Identifier: MIT
// One chart over the run's time, by uPlot: steps a bin wide, phases as dashed lines, the chosen time
// shaded. A click chooses a time; what a pointer does here the slider does for keys.
import uPlot from 'uplot';
import { onThemeChange, themeColour } from './colour.js';
import { element, onResize } from './dom.js';
import { percent, figures, time } from './format.js';

const HEIGHT = 150;

const formats = { share: percent, messages: (value) => figures(value, 3) };

// Steps end where the run does.
function withEnd(run, values) {
    return [...values, values.at(-1)];
}

function times(run) {
    return [...Array.from({ length: run.bins }, (_, bin) => run.binStart(bin)), run.endPs];
}

// Stacked layers: each reaches from zero to the sum of itself and those below, the tallest first.
function stack(layers) {
    let below = layers[0].values.map(() => 0);
    return layers.map((layer) => {
        below = layer.values.map((value, i) => value + below[i]);
        return { ...layer, drawn: below };
    }).reverse();
}

function seriesOf(layer, unit, stacked) {
    return {
        label: layer.label,
        stroke: layer.colour,
        fill: stacked ? layer.colour : undefined,
        width: stacked ? 0 : 1.75,
        dash: layer.dash,
        points: { show: false },
        paths: uPlot.paths.stepped({ align: 1 }),
        value: (_, value, series, i) => (i === null || i === undefined ? '-' : formats[unit](layer.values[Math.min(i, layer.values.length - 1)])),
    };
}

function drawPhases(chart, run) {
    const { ctx, bbox } = chart;
    ctx.save();
    ctx.strokeStyle = themeColour('phase');
    ctx.setLineDash([3, 4]);
    ctx.beginPath();
    for (const phase of run.statistics.phases.slice(1)) {
        const x = chart.valToPos(phase.start_ps, 'x', true);
        ctx.moveTo(x, bbox.top);
        ctx.lineTo(x, bbox.top + bbox.height);
    }
    ctx.stroke();
    ctx.restore();
}

function shadeBin(chart, run, bin) {
    if (bin === null) {
        return;
    }
    const { ctx, bbox } = chart;
    const left = chart.valToPos(run.binStart(bin), 'x', true);
    const right = chart.valToPos(run.binEnd(bin), 'x', true);
    ctx.save();
    ctx.strokeStyle = themeColour('text');
    ctx.lineWidth = 1.5 * devicePixelRatio;
    ctx.strokeRect(left, bbox.top, Math.max(right - left, 2), bbox.height);
    ctx.restore();
}

function axis(values, size) {
    const grid = { stroke: themeColour('grid'), width: 1 };
    return { stroke: themeColour('muted'), grid, ticks: grid, font: '11px system-ui, sans-serif', values, size, gap: 4 };
}

function options(run, store, { unit, stacked, top }, layers, width) {
    const most = top ?? Math.max(...layers.flatMap((layer) => layer.drawn ?? layer.values), 0);
    return {
        width,
        height: HEIGHT,
        scales: { x: { time: false, range: [0, run.endPs || 1] }, y: { range: [0, most > 0 ? 1.02 * most : 1] } },
        axes: [
            { ...axis((_, ticks) => ticks.map((tick) => (tick === 0 ? '0' : time(tick, 3))), 26), space: 80 },
            axis((_, ticks) => ticks.map(unit === 'share' ? (tick) => `${Math.round(100 * tick)} %` : (tick) => figures(tick, 3)), 48),
        ],
        series: [{ label: 'time', value: (_, value) => (value === null || value === undefined ? '-' : time(value)) }, ...layers.map((layer) => seriesOf(layer, unit, stacked))],
        cursor: { sync: { key: 'run' }, drag: { x: false, y: false }, points: { show: false }, y: false },
        hooks: { draw: [(chart) => { drawPhases(chart, run); shadeBin(chart, run, store.get().bin); }] },
    };
}

// `spec`: { title, unit: 'share' or 'messages', stacked, top, layers: [{ label, colour, values }] }.
export function createChart(root, run, store, spec) {
    const figure = element('figure', { class: 'chart' }, element('figcaption', {}, spec.title));
    const plot = element('div', { class: 'plot', role: 'img', 'aria-label': `${spec.title}: ${describe(spec)}` });
    figure.append(plot);
    root.append(figure);
    const layers = spec.stacked ? stack(spec.layers) : spec.layers;
    const data = [times(run), ...layers.map((layer) => withEnd(run, layer.drawn ?? layer.values))];
    let chart = null;
    const build = () => {
        chart?.destroy();
        chart = new uPlot(options(run, store, spec, layers, Math.max(plot.clientWidth, 100)), data, plot);
        chart.over.addEventListener('click', () => store.set({ bin: run.binAt(chart.posToVal(chart.cursor.left, 'x')), playing: false }));
    };
    build();
    onThemeChange(build);
    onResize(plot, () => {
        if (plot.clientWidth > 0 && plot.clientWidth !== chart.width) {
            chart.setSize({ width: plot.clientWidth, height: HEIGHT });
        }
    });
    return { redraw: () => chart.redraw(false), remove: () => { chart.destroy(); figure.remove(); } };
}

function describe({ unit, layers }) {
    const format = formats[unit];
    return layers.map(({ label, values }) => {
        const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
        return `${label} ${format(mean)} on average, at most ${format(values.reduce((a, b) => Math.max(a, b), 0))}`;
    }).join('; ');
}
