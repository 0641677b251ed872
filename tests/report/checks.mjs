// SPDX-License-Identifier: MIT
// What must hold of the report of every machine. Each check gets the open page and the run's files.
import assert from 'node:assert/strict';
import { inflateSync } from 'node:zlib';
import { meansOfBins } from './files.mjs';

const UNITS = { s: 1e12, ms: 1e9, us: 1e6, ns: 1e3, ps: 1 };

// A number as the page writes it: "145.4 ms", "86.8 %", "1 864 842".
function numberOf(text) {
    const [, digits, unit] = /^([-\d.e\u2009]+)\s*(\S*)$/.exec(text.trim()) ?? [];
    assert.ok(digits !== undefined, `'${text}' is no number`);
    const value = Number(digits.replaceAll('\u2009', ''));
    return unit === '%' ? value / 100 : value * (UNITS[unit] ?? 1);
}

function assertShows(text, value, what) {
    const tolerance = text.includes('%') ? 0.000501 : Math.abs(value) * 5.1e-4;
    assert.ok(Math.abs(numberOf(text) - value) <= tolerance, `${what} shows ${text}, but is ${value}`);
}

export async function drawsEveryNode({ page, files }) {
    const drawing = await page.$eval('#drawing', (node) => ({ ...node.dataset }));
    assert.equal(Number(drawing.cells), files.statistics.nodes);
    assert.equal(Number(drawing.parts), files.parts.length);
    assert.equal(drawing.renderer, 'webgl');
}

export async function headShowsTheRun({ page, files: { statistics } }) {
    const facts = await page.$$eval('#head .facts > div', (rows) => rows.map((row) => [row.children[0].textContent, row.children[1].firstChild.textContent]));
    const shown = Object.fromEntries(facts);
    assert.equal(numberOf(shown.Instructions), statistics.instructions);
    assert.equal(numberOf(shown.Messages), statistics.messages);
    assert.equal(numberOf(shown.Processors), statistics.nodes);
    assertShows(shown['Machine time'], statistics.end_ps, 'machine time');
    assert.equal(await page.title(), `${statistics.machine} - Rasterloom report`);
}

const MOST_ROWS = 6000; // whole pages

// Rows of a table, page by page, as exact values and as text.
async function readTable(page, key) {
    return page.evaluate(([table, most]) => {
        const grid = document.getElementById(`table-${table}`);
        const box = grid.closest('.table-box');
        grid.closest('#tables > details').open = true;
        const next = [...box.querySelectorAll('.pager button')].at(-1);
        const heads = [...grid.tHead.rows[0].cells].map((cell) => cell.textContent.trim());
        const rows = [];
        let read = 0;
        for (;;) {
            [...grid.tBodies[0].rows].forEach((row) => { rows[row.dataset.row] = [...row.cells].map((cell) => [cell.dataset.value, cell.textContent]); });
            read += grid.tBodies[0].rows.length;
            if (next.disabled || read >= most) {
                return { heads, rows };
            }
            next.click();
        }
    }, [key, MOST_ROWS]);
}

const headOf = (column) => (column === 'waited_for_ps' ? 'waited for, time' : column.replace(/_ps$/, '').replace(/_u$/, ' u').replaceAll('_', ' '));

async function tableShows(page, key, records, nameOf) {
    const { heads, rows } = await readTable(page, key);
    const read = [...rows.entries()].filter(([, cells]) => cells !== undefined);
    assert.equal(read.length, Math.min(records.length, MOST_ROWS), `rows of ${key}`);
    const columns = Object.keys(records[0]).filter((column) => heads.includes(headOf(column)) && column !== 'name');
    assert.ok(columns.length > 5, `columns of ${key}: ${heads}`);
    for (const [i, cells] of read) {
        assert.equal(cells[0][1], nameOf(records[i]));
        columns.forEach((column) => cellShows(cells[heads.indexOf(headOf(column))], records[i][column], `${key} ${i} ${column}`));
    }
}

function cellShows([value, text], expected, what) {
    if (expected === '' || Number.isNaN(Number(expected))) {
        assert.equal(text, expected, what);
    } else {
        assert.equal(Number(value), Number(expected), what);
        assertShows(text, Number(expected), what);
    }
}

export async function tablesShowTheFiles({ page, files }) {
    await tableShows(page, 'node', files.nodes, (node) => node.name);
    if (files.links.length > 0) {
        await tableShows(page, 'link', files.links, (link) => `${link.from_name} > ${link.to_name}`);
    }
    if (files.parts.length > 0) {
        await tableShows(page, 'part', files.parts, (part) => part.name);
    }
    const phases = files.statistics.phases.map(({ all_nodes: all, synchronous, ...phase }) => ({ ...phase, ...all }));
    const { heads, rows } = await readTable(page, 'phases');
    assert.equal(rows.length, phases.length);
    phases.forEach((phase, i) => heads.forEach((head, column) => {
        const key = Object.keys(phase).find((name) => headOf(name) === head);
        assert.equal(rows[i][column][0], String(phase[key]), `phase ${i} ${head}`);
    }));
}

export async function pathShowsStatistics({ page, files: { statistics } }) {
    const paths = statistics.critical_paths ?? [];
    assert.equal(await page.$eval('#path', (node) => node.hidden), paths.length === 0);
    if (paths.length > 0) {
        const shown = await page.$$eval('#path table:first-of-type td[data-value]', (cells) => cells.map((cell) => [Number(cell.dataset.value), cell.textContent]));
        assert.deepEqual(shown.slice(0, paths[0].kinds.length).map(([value]) => value), paths[0].kinds.map((kind) => kind.time_ps));
        shown.forEach(([value, text]) => assertShows(text, value, 'a time on the path'));
    }
}

export async function sortsByKey({ page, files }) {
    const head = page.locator('#table-node thead button', { hasText: /^busy$/ });
    await head.focus();
    await page.keyboard.press('Enter');
    const sorted = await page.$eval('#table-node', (table) => ({
        order: [...table.tHead.rows[0].cells].map((cell) => cell.getAttribute('aria-sort')),
        first: table.tBodies[0].rows[0].cells[0].textContent,
    }));
    const most = Math.max(...files.nodes.map((node) => Number(node.busy_ps)));
    assert.equal(sorted.first, files.nodes.find((node) => Number(node.busy_ps) === most).name);
    assert.deepEqual(sorted.order.filter((order) => order !== 'none'), ['descending']);
    await page.keyboard.press('Enter');
    const least = Math.min(...files.nodes.map((node) => Number(node.busy_ps)));
    const first = await page.$eval('#table-node', (table) => table.tBodies[0].rows[0].cells[0].textContent);
    assert.equal(Number(files.nodes.find((node) => node.name === first).busy_ps), least);
}

export async function slidesByKey({ page }) {
    assert.equal(await page.getAttribute('#whole', 'aria-pressed'), 'true');
    await page.focus('#time');
    await page.keyboard.press('ArrowRight');
    const first = await page.textContent('#time-text');
    await page.keyboard.press('ArrowRight');
    const second = await page.textContent('#time-text');
    assert.notEqual(first, second);
    assert.equal(await page.getAttribute('#time', 'aria-valuetext'), second);
    assert.equal(await page.getAttribute('#whole', 'aria-pressed'), 'false');
    await page.focus('#whole');
    await page.keyboard.press('Enter');
    assert.equal(await page.getAttribute('#whole', 'aria-pressed'), 'true');
}

export async function turnsByKey({ page }) {
    const drawing = page.locator('#drawing');
    await drawing.focus();
    await page.keyboard.press('Home');
    const before = await drawing.screenshot();
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('ArrowUp');
    assert.ok(!before.equals(await drawing.screenshot()), 'the turned machine looks the same');
}

const shareOf = (node, { end_ps: end }, columns) => columns.reduce((sum, column) => sum + Number(node[column]), 0) / end;
// Lanes of an array that are asleep take no part, which counts as waiting.
const WAITING = ['waiting_input_ps', 'waiting_output_ps', 'waiting_phase_ps', 'waiting_interrupt_ps', 'asleep_ps'];

export async function selectionShowsTheFiles({ page, files }) {
    await page.focus('#drawing');
    await page.keyboard.press('n');
    assert.ok((await page.textContent('#selected-name')).startsWith(files.nodes[0].name));
    const middle = files.nodes[Math.floor(files.nodes.length / 2)];
    await page.fill('#find', middle.name);
    await page.keyboard.press('Enter');
    assert.ok((await page.textContent('#selected-name')).startsWith(middle.name));
    assertShows(await page.textContent('#details [data-metric="busy"]'), shareOf(middle, files.statistics, ['busy_ps']), 'busy');
    assertShows(await page.textContent('#details [data-metric="waiting"]'), shareOf(middle, files.statistics, WAITING), 'waiting');
    assert.match(await page.textContent('#live'), new RegExp(middle.name));
    if (files.nodes.length > 1) {
        await page.focus('#drawing');
        const names = new Set([await page.textContent('#selected-name')]);
        for (const key of ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown']) {
            if (names.size > 1) {
                break;
            }
            await page.keyboard.press(`Shift+${key}`);
            names.add(await page.textContent('#selected-name'));
        }
        assert.ok(names.size > 1, 'the selection does not move');
    }
    await page.focus('#drawing');
    await page.keyboard.press('Escape');
    assert.equal(await page.$('#selected-name'), null);
}

// Somewhere in the drawing lies a processor.
export async function tooltipShowsTheFiles({ page, files }) {
    await page.locator('#drawing').scrollIntoViewIfNeeded();
    const box = await page.locator('#drawing').boundingBox();
    for (let i = 0; i < 400; ++i) {
        const x = box.x + box.width * ((0.5 + i * 0.618034) % 1);
        const y = box.y + box.height * ((0.6 + i * 0.754878) % 1);
        await page.mouse.move(x, y);
        const name = await page.$eval('#tooltip', (tip) => (tip.hidden ? null : tip.querySelector('strong').textContent));
        const node = files.nodes.find((each) => each.name === name);
        if (node) {
            const shown = await page.$$eval('#tooltip dd', (cells) => cells.map((cell) => cell.textContent));
            assertShows(shown[0], shareOf(node, files.statistics, ['busy_ps']), 'tooltip: busy');
            assertShows(shown[1], shareOf(node, files.statistics, WAITING), 'tooltip: waiting');
            return;
        }
    }
    assert.fail('no processor found under the pointer');
}

export async function picturesAreTheRuns({ page, files: { picture } }) {
    if (picture === null) {
        assert.equal(await page.$eval('#pictures', (node) => node.hidden), true);
        return;
    }
    const { src, width } = await page.$eval('#picture', (image) => ({ src: image.src, width: image.naturalWidth }));
    assert.ok(src === `data:image/png;base64,${picture.toString('base64')}`, 'another picture than frame-000.png');
    assert.equal(width, picture.readUInt32BE(16));
}

export async function everyControlHasAName({ page }) {
    const nameless = await page.evaluate(() => [...document.querySelectorAll('button, input, select, [tabindex], [role="img"]')]
        .filter((node) => !(node.getAttribute('aria-label') || node.textContent.trim() || node.labels?.[0]?.textContent))
        .map((node) => node.outerHTML.slice(0, 120)));
    assert.deepEqual(nameless, []);
}

function seriesOf(files) {
    const text = /<script type="application\/json" id="run">(.*?)<\/script>/s.exec(files.html())[1];
    return JSON.parse(text).timeline;
}

function unpackBins(series, component, bins) {
    const bytes = inflateSync(Buffer.from(series.bins, 'base64'));
    return Array.from({ length: bins }, (_, bin) => (bytes.readUInt16LE(2 * (component * bins + bin)) * series.scale) / 65535);
}

// Bins follow from messages.csv, and over all of them a state's time is that of nodes.csv.
export async function binsShowTheMessages({ files }) {
    const timeline = seriesOf(files);
    const { bin_ps: binPs, bins } = timeline;
    const end = files.statistics.end_ps;
    const find = (of, name) => timeline.series.find((series) => series.of === of && series.name === name);
    const messages = files.messages();
    const close = (found, expected, scale, what) => found.forEach((value, bin) =>
        assert.ok(Math.abs(value - expected[bin]) <= scale / 65535, `${what}, bin ${bin}: ${value}, but ${expected[bin]}`));

    const underWay = find('machine', 'under_way');
    close(unpackBins(underWay, 0, bins), meansOfBins(messages.map((m) => [Number(m.queued_ps), Number(m.consumed_ps)]), binPs, bins, end), underWay.scale, 'under way');
    const input = find('node', 'input_queue');
    const node = files.nodes.length >> 1;
    const waited = messages.filter((m) => Number(m.destination) === node).map((m) => [Number(m.delivered_ps), Number(m.consumed_ps)]);
    close(unpackBins(input, node, bins), meansOfBins(waited, binPs, bins, end), input.scale, 'input queue');
    for (const state of ['busy', 'waiting_input', 'waiting_output', 'waiting_phase', 'waiting_interrupt', 'asleep']) {
        const totals = inflateSync(Buffer.from(find('node', state).totals_ps, 'base64'));
        files.nodes.forEach((each, i) => assert.equal(totals.readDoubleLE(8 * i), Number(each[`${state}_ps`]), `${state} of ${each.name}`));
    }
}
