// SPDX-License-Identifier: MIT
// node report_test.mjs RASTERLOOM NODE_MODULES SOURCE: makes the report of every shipped machine and
// looks at it in a browser, as docs/report.md says it works. Ends with status 77, for skipped, where
// there is no Chromium. RASTERLOOM_SCREENSHOTS=DIR keeps what it saw.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join, resolve } from 'node:path';
import { deflateSync } from 'node:zlib';
import { emulate, openReport, startBrowser } from './browser.mjs';
import * as checks from './checks.mjs';
import { readFiles } from './files.mjs';

const [rasterloom, modules, source] = process.argv.slice(2).map((path) => resolve(path));
const long = process.env.RASTERLOOM_LONG_TESTS !== undefined;
const pictures = process.env.RASTERLOOM_SCREENSHOTS;
const AT_ONCE = 2;

const ONLY_LONG = ['geodesic12002.yaml', 'princeton1024-sort-last-dense.yaml', 'princeton1024-sort-last-sparse.yaml'];
// Beside the shipped ones: what they do not have.
const OTHERS = [
    { name: 'frames', config: 'geodesic482.yaml', changes: ['run.frames=3', 'topology.b=2', 'topology.c=1', 'screen={width: 64, height: 64}', 'scene.rotate.degrees=15'] },
    { name: 'torus', config: 'edge-list.yaml', changes: ['topology={kind: torus, width: 5, height: 4}'] },
    { name: 'grid', config: 'edge-list.yaml', changes: ['topology={kind: grid, width: 6, height: 3}'] },
    { name: 'digests', config: 'hybrid16.yaml', changes: ['fabric.half_digested=true'] },
    { name: 'pixel-bus', config: 'interlace16.yaml', changes: ['fabric.frame_buffer=bus'] },
];

function machines() {
    const shipped = readdirSync(join(source, 'configs')).filter((file) => file.endsWith('.yaml')).sort();
    return [...shipped.filter((file) => long || !ONLY_LONG.includes(file)).map((config) => ({ name: basename(config, '.yaml'), config, changes: [] })), ...OTHERS];
}

async function look(browser, machine, folder) {
    const report = await openReport(browser, join(folder, 'report.html'));
    const files = readFiles(folder);
    for (const [name, check] of Object.entries(checks)) {
        try {
            await check({ page: report.page, files });
        } catch (error) {
            error.message = `${machine.name}, ${name}: ${error.message}`;
            throw error;
        }
    }
    await keepPicture(report.page, machine.name);
    assert.deepEqual(report.complaints, [], machine.name);
    await report.close();
}

async function keepPicture(page, name) {
    if (pictures) {
        mkdirSync(pictures, { recursive: true });
        await page.screenshot({ path: join(pictures, `${name}.png`), fullPage: true });
    }
}

async function drawsFlatWithoutWebgl(browser, folder) {
    const report = await openReport(browser, join(folder, 'report.html'), { webgl: false });
    assert.equal(await report.page.getAttribute('#drawing', 'data-renderer'), 'flat');
    assert.match(await report.page.textContent('#no-webgl'), /no WebGL/);
    await checks.turnsByKey({ page: report.page });
    await checks.tooltipShowsTheFiles({ page: report.page, files: readFiles(folder) });
    await keepPicture(report.page, `${basename(folder)}-flat`);
    assert.deepEqual(report.complaints, []);
    await report.close();
}

async function isDarkWherePreferred(browser, folder) {
    const backgrounds = [];
    for (const colorScheme of ['light', 'dark']) {
        const report = await openReport(browser, join(folder, 'report.html'), { colorScheme });
        backgrounds.push(await report.page.$eval('body', (body) => getComputedStyle(body).backgroundColor));
        await keepPicture(report.page, `${basename(folder)}-${colorScheme}`);
        await report.page.emulateMedia({ media: 'print' });
        assert.equal(await report.page.$eval('#controls', (node) => getComputedStyle(node).display), 'none');
        assert.deepEqual(report.complaints, []);
        await report.close();
    }
    assert.notEqual(backgrounds[0], backgrounds[1]);
}

async function goesThroughFrames(browser, folder) {
    const report = await openReport(browser, join(folder, 'report.html'));
    const { page } = report;
    const first = await page.getAttribute('#picture', 'src');
    await page.focus('#pictures input');
    await page.keyboard.press('ArrowRight');
    assert.notEqual(await page.getAttribute('#picture', 'src'), first);
    assert.match(await page.textContent('#path'), /Frame 1/);
    assert.deepEqual(report.complaints, []);
    await report.close();
}

// A ring with a controller that feeds it, in a state that no machine of ours has: nothing in the page
// knows of it.
async function showsAMachineOfAnotherKind(browser, folder) {
    const file = join(folder, 'another.html');
    writeFileSync(file, readFileSync(join(folder, 'report.html'), 'utf8').replace(/(id="run">)(.*?)(<\/script>)/s, (_, start, text, end) => {
        const run = JSON.parse(text);
        run.tables.parts = deflateSync('name,kind,busy_ps,blocked_ps\ncontroller,controller,9000000,0\nmaster,host,1000000,0\n').toString('base64');
        run.drawing.parts = [{ place: 'before', parent: 1 }, { place: 'before', parent: null }];
        run.drawing.fed_by = run.drawing.positions.map(() => 0);
        Object.assign(run.timeline.series.find((series) => series.name === 'waiting_input'), { name: 'masked', label: 'switched off' });
        return start + JSON.stringify(run).replaceAll('<', '\\u003c') + end;
    }));
    const report = await openReport(browser, file);
    const { page } = report;
    assert.deepEqual(await page.$eval('#drawing', ({ dataset }) => [dataset.cells, dataset.parts]), ['16', '2']);
    assert.match(await page.textContent('#timelines'), /switched off/);
    await page.fill('#find', 'controller');
    await page.keyboard.press('Enter');
    assert.match(await page.textContent('#selected-name'), /controller/);
    assert.match(await page.textContent('.connections'), /master.*R0.*R15/);
    assert.deepEqual(report.complaints, []);
    await report.close();
}

async function playsTime(browser, folder) {
    const report = await openReport(browser, join(folder, 'report.html'));
    const { page } = report;
    await page.focus('#drawing');
    const still = await page.locator('#drawing').screenshot();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('Home');
    assert.ok(still.equals(await page.locator('#drawing').screenshot()), 'Home does not bring the first view back');
    await page.focus('#play');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.getElementById('time').value > 3);
    await page.keyboard.press('Enter');
    const at = await page.$eval('#time', (slider) => slider.value);
    await page.waitForTimeout(300);
    assert.equal(await page.$eval('#time', (slider) => slider.value), at, 'it does not pause');
    assert.ok(!still.equals(await page.locator('#drawing').screenshot()), 'another time looks the same');
    assert.deepEqual(report.complaints, []);
    await report.close();
}

async function showsTheFocus(browser, folder) {
    const report = await openReport(browser, join(folder, 'report.html'));
    const { page } = report;
    for (const id of ['#drawing', '#play', '#time', '#find']) {
        await page.focus('body');
        await page.focus(id);
        await page.keyboard.press('Shift');
        const outline = await page.$eval(id, (node) => getComputedStyle(node).outlineStyle);
        assert.equal(outline, 'solid', `${id} in focus`);
    }
    await report.close();
}

// Runs `work` for all of `list`, a few at once.
async function forAll(list, work) {
    const rest = [...list];
    await Promise.all(Array.from({ length: AT_ONCE }, async () => {
        while (rest.length > 0) {
            await work(rest.shift());
        }
    }));
}

const browser = await startBrowser(modules);
if (!browser) {
    console.log('skipped: no chromium on the path');
    process.exit(77);
}
const folder = mkdtempSync(join(tmpdir(), 'rasterloom-report-'));
const failures = [];
const attempt = async (name, work) => {
    const began = Date.now();
    try {
        await work();
        console.log(`ok    ${name} (${Date.now() - began} ms)`);
    } catch (error) {
        failures.push(name);
        console.log(`FAIL  ${name}: ${error.message}`);
    }
};
try {
    await forAll(machines(), (machine) => attempt(machine.name, async () => {
        await emulate(rasterloom, join(source, 'configs', machine.config), join(folder, machine.name), machine.changes);
        await look(browser, machine, join(folder, machine.name));
    }));
    await forAll([
        ['geodesic482 without WebGL', () => drawsFlatWithoutWebgl(browser, join(folder, 'geodesic482'))],
        ['splitter16 without WebGL', () => drawsFlatWithoutWebgl(browser, join(folder, 'splitter16'))],
        ['light, dark and on paper', () => isDarkWherePreferred(browser, join(folder, 'geodesic482'))],
        ['frames', () => goesThroughFrames(browser, join(folder, 'frames'))],
        ['a machine of another kind', () => showsAMachineOfAnotherKind(browser, join(folder, 'ring'))],
        ['focus', () => showsTheFocus(browser, join(folder, 'splitter16'))],
        ['playing', () => playsTime(browser, join(folder, 'geodesic482'))],
    ], ([name, work]) => attempt(name, work));
} finally {
    await browser.close();
    rmSync(folder, { recursive: true, force: true });
}
process.exit(failures.length > 0 ? 1 : 0);
