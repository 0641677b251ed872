// SPDX-License-Identifier: MIT
// node build.mjs NODE_MODULES OUTPUT.cpp: bundles the page into one HTML file without references to
// others, and writes it as C++ (observe::page_template).
import { mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const [modules, output] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(modules, 'any.js'))('esbuild');
const LONGEST_LITERAL = 60000; // characters: what every compiler takes

async function bundle(entry) {
    const result = await esbuild.build({
        entryPoints: [join(here, entry)],
        nodePaths: [modules],
        bundle: true,
        minify: true,
        format: 'iife',
        target: ['es2021', 'chrome100', 'firefox113', 'safari16'],
        legalComments: 'none',
        write: false,
        logLevel: 'warning',
    });
    return result.outputFiles[0].text.trim();
}

function fill(template, mark, text) {
    const parts = template.split(mark);
    if (parts.length !== 2) {
        throw new Error(`index.html has ${parts.length - 1} places for ${mark}, not one`);
    }
    return parts.join(text);
}

// The licences of what is bundled ask for a notice in every copy.
function notices() {
    return ['three', 'uplot']
        .map((name) => {
            const about = JSON.parse(readFileSync(join(modules, name, 'package.json'), 'utf8'));
            const licence = readFileSync(join(modules, name, 'LICENSE'), 'utf8').trim();
            return `${name} ${about.version}\n${licence}`;
        })
        .join('\n\n');
}

function literals(text) {
    const parts = [];
    for (let at = 0; at < text.length; at += LONGEST_LITERAL) {
        parts.push(`R"page(${text.slice(at, at + LONGEST_LITERAL)})page"`);
    }
    return parts;
}

function cpp(page) {
    const parts = literals(page);
    return `// Generated from machine/report/ by build.mjs.
#include "machine/observe/page/report_page.hpp"

#include <array>

namespace rasterloom::observe {

std::optional<std::string> page_template() {
    constexpr std::array<const char*, ${parts.length}> kParts{
${parts.join(',\n')}};
    std::string page;
    for (const char* part : kParts) {
        page += part;
    }
    return page;
}

}  // namespace rasterloom::observe
`;
}

let page = readFileSync(join(here, 'index.html'), 'utf8');
page = fill(page, '@NOTICES@', notices().replaceAll('--', '- -').replaceAll('\u00a9', '(c)'));
page = fill(page, '/*@STYLE@*/', await bundle('style.css'));
page = fill(page, '/*@SCRIPT@*/', (await bundle('src/main.js')).replaceAll('</script', '<\\/script'));
if (page.includes(')page"') || page.split('@RUN@').length !== 2 || !/^[\x00-\x7f]*$/.test(page)) {
    throw new Error('the page cannot be a C++ literal, or does not have exactly one place for the run');
}
mkdirSync(dirname(output), { recursive: true });
writeFileSync(`${output}.partial`, cpp(page));
renameSync(`${output}.partial`, output);
console.log(`report page: ${(page.length / 1024).toFixed(0)} KiB`);
