// SPDX-License-Identifier: MIT
// The files that a run left beside its report, read without any of the report's code.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

// Names in shipped machines hold no commas or quotes.
function readCsv(path) {
    if (!existsSync(path)) {
        return [];
    }
    const [head, ...lines] = readFileSync(path, 'utf8').trimEnd().split('\n');
    const columns = head.split(',');
    return lines.map((line) => Object.fromEntries(line.split(',').map((field, i) => [columns[i], field])));
}

export function readFiles(folder) {
    const statistics = JSON.parse(readFileSync(join(folder, 'statistics.json'), 'utf8'));
    const frame = join(folder, 'frame-000.png');
    return {
        statistics,
        nodes: readCsv(join(folder, 'nodes.csv')),
        links: readCsv(join(folder, 'links.csv')),
        parts: readCsv(join(folder, 'fabric.csv')),
        messages: () => readCsv(join(folder, 'messages.csv')),
        picture: existsSync(frame) ? readFileSync(frame) : null,
        html: () => readFileSync(join(folder, 'report.html'), 'utf8'),
    };
}

// The mean of a quantity in each bin: `spans` are [from, to] in picoseconds, each adds one.
export function meansOfBins(spans, binPs, bins, endPs) {
    const sums = new Array(bins).fill(0);
    for (const [from, to] of spans) {
        for (let bin = Math.floor(from / binPs); bin < bins && bin * binPs < to; ++bin) {
            sums[bin] += Math.min(to, (bin + 1) * binPs) - Math.max(from, bin * binPs);
        }
    }
    return sums.map((sum, bin) => sum / (Math.min((bin + 1) * binPs, endPs) - bin * binPs));
}
