// SPDX-License-Identifier: MIT
// The browser, the command and a page to test, for report_test.mjs.
import { execFile } from 'node:child_process';
import { accessSync, constants } from 'node:fs';
import { createRequire } from 'node:module';
import { delimiter, join } from 'node:path';
import { promisify } from 'node:util';

const runProgram = promisify(execFile);

// Root has no sandbox; without the others Chromium looks for its maker's hosts.
const FLAGS = [
    '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
    '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
];

function findProgram(names) {
    for (const folder of (process.env.PATH ?? '').split(delimiter)) {
        for (const name of names) {
            try {
                accessSync(join(folder, name), constants.X_OK);
                return join(folder, name);
            } catch {
                // the next one
            }
        }
    }
    return null;
}

// Null where there is no Chromium.
export async function startBrowser(modules) {
    const executablePath = findProgram(['chromium', 'chromium-browser', 'google-chrome']);
    if (!executablePath) {
        return null;
    }
    const { chromium } = createRequire(join(modules, 'any.js'))('playwright-core');
    return chromium.launch({ executablePath, headless: true, args: FLAGS });
}

export async function emulate(rasterloom, config, out, changes) {
    const settings = changes.flatMap((change) => ['--set', change]);
    await runProgram(rasterloom, ['run', config, '--report', '--quiet', '--out', out, ...settings], { maxBuffer: 1 << 24 });
}

// Opens a report with the network off; `complaints` gathers all that is not silence.
export async function openReport(browser, file, { colorScheme = 'light', webgl = true } = {}) {
    const context = await browser.newContext({ viewport: { width: 1000, height: 700 }, colorScheme, offline: true });
    const page = await context.newPage();
    const complaints = [];
    page.on('console', (message) => complaints.push(`console ${message.type()}: ${message.text()}`));
    page.on('pageerror', (error) => complaints.push(`error: ${error.stack}`));
    page.on('requestfailed', (request) => complaints.push(`failed request: ${request.url().slice(0, 200)}`));
    page.on('request', (request) => {
        if (!/^(file|data|blob):/.test(request.url())) {
            complaints.push(`request: ${request.url().slice(0, 200)}`);
        }
    });
    if (!webgl) {
        await page.addInitScript(() => {
            const original = HTMLCanvasElement.prototype.getContext;
            HTMLCanvasElement.prototype.getContext = function getContext(kind, ...rest) {
                return kind.startsWith('webgl') ? null : original.call(this, kind, ...rest);
            };
        });
    }
    await page.goto(`file://${file}`);
    await page.waitForSelector('body[data-ready]', { timeout: 60000 });
    return { page, complaints, close: () => context.close() };
}
