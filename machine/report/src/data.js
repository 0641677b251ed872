// SPDX-License-Identifier: MIT
// The run as the page's JSON has it (docs/report.md), unpacked. Whole-run numbers are those of
// statistics.json and the CSV files; bins of time are 16-bit shares of each series' scale.
import { parseCsv } from './csv.js';
import { createKinds } from './kinds.js';

const FULL = 65535;

async function inflate(text) {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Response(stream).arrayBuffer();
}

async function readSeries(packed, bins) {
    const [values, totals] = await Promise.all([inflate(packed.bins), inflate(packed.totals_ps)]);
    const cells = new Uint16Array(values);
    const total = new Float64Array(totals);
    return {
        ...packed,
        components: total.length,
        // Share of the bin's time, or the mean number of messages in it.
        at: (component, bin) => (cells[component * bins + bin] * packed.scale) / FULL,
        totalPs: (component) => total[component],
    };
}

async function readTables(packed) {
    const tables = {};
    for (const [name, text] of Object.entries(packed)) {
        tables[name] = parseCsv(new TextDecoder().decode(await inflate(text)));
    }
    return tables;
}

export async function readRun(text) {
    const json = JSON.parse(text);
    const { bins, bin_ps: binPs } = json.timeline;
    const series = await Promise.all(json.timeline.series.map((packed) => readSeries(packed, bins)));
    const tables = await readTables(json.tables);
    const owners = new Uint32Array(await inflate(json.drawing.screen.owners));
    const endPs = json.statistics.end_ps;
    const drawing = { ...json.drawing, screen: { ...json.drawing.screen, owners } };
    const run = { statistics: json.statistics, histograms: json.histograms, pictures: json.pictures, drawing, tables, series, bins, binPs, endPs };
    run.binStart = (bin) => bin * binPs;
    run.binEnd = (bin) => Math.min((bin + 1) * binPs, endPs);
    run.binAt = (ps) => Math.min(Math.max(Math.floor(ps / binPs), 0), bins - 1);
    run.kinds = createKinds(run);
    run.kind = Object.fromEntries(run.kinds.map((kind) => [kind.key, kind]));
    run.phaseAt = (ps) => run.statistics.phases.find((phase) => ps >= phase.start_ps && ps < phase.end_ps);
    return run;
}
