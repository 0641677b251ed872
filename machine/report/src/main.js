// SPDX-License-Identifier: MIT
// The page: reads the run, makes every view, and has them follow one store.
import { createControls } from './controls.js';
import { readRun } from './data.js';
import { createDetails } from './details.js';
import { createFoot, createHead } from './head.js';
import { createHistograms } from './histograms.js';
import { createMachineView } from './machine_view/index.js';
import { createPath } from './path.js';
import { createPictures } from './pictures.js';
import { createStore } from './store.js';
import { createTables } from './tables.js';
import { createTimelines } from './timelines.js';

const VIEWS = {
    head: createHead,
    controls: createControls,
    pictures: createPictures,
    machine: createMachineView,
    details: createDetails,
    timelines: createTimelines,
    path: createPath,
    histograms: createHistograms,
    tables: createTables,
    foot: createFoot,
};

async function start() {
    const run = await readRun(document.getElementById('run').textContent);
    const store = createStore({ metric: 'busy', bin: null, selected: null, frame: 0, playing: false });
    for (const [id, create] of Object.entries(VIEWS)) {
        create(document.getElementById(id), run, store);
    }
    document.body.dataset.ready = 'yes';
}

start();
