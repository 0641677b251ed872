// SPDX-License-Identifier: MIT
// node docs_picture.mjs NODE_MODULES REPORT.html PICTURE.png: the picture in README.
import { resolve } from 'node:path';
import { openReport, startBrowser } from './browser.mjs';

const [modules, file, picture] = process.argv.slice(2).map((path) => resolve(path));
const browser = await startBrowser(modules);
const { page } = await openReport(browser, file);
await page.setViewportSize({ width: 1400, height: 1130 });
await page.fill('#find', 'P261-95');
await page.keyboard.press('Enter');
await page.locator('#find').blur();
await page.waitForTimeout(500);
await page.screenshot({ path: picture });
await browser.close();
