// SPDX-License-Identifier: MIT
// The bar at the top: which quantity the colours show, and the time they show it at.
import { element } from './dom.js';
import { time } from './format.js';
import { METRICS } from './kinds.js';

const STEP = 120; // milliseconds a bin while playing

export function createControls(root, run, store) {
    root.append(metricChoice(store), timeChoice(run, store));
}

function metricChoice(store) {
    const radios = METRICS.map((metric) =>
        element('label', { class: 'choice' },
            element('input', { type: 'radio', name: 'metric', value: metric.key, onchange: () => store.set({ metric: metric.key }) }),
            element('span', {}, metric.title)));
    store.follow(['metric'], ({ metric }) => {
        radios.forEach((radio) => { radio.firstChild.checked = radio.firstChild.value === metric; });
    });
    return element('fieldset', { class: 'choices' }, element('legend', { class: 'unseen' }, 'Colours show'), radios);
}

export function describeBin(run, bin) {
    if (bin === null) {
        return `whole run, ${time(run.endPs)}`;
    }
    const phase = run.phaseAt(run.binStart(bin));
    const span = `${time(run.binStart(bin))} to ${time(run.binEnd(bin))}`;
    return phase ? `${span}, ${phase.name}` : span;
}

function timeChoice(run, store) {
    const slider = element('input', {
        type: 'range', id: 'time', min: 0, max: Math.max(run.bins - 1, 0), step: 1, value: 0, 'aria-label': 'Time',
        oninput: () => store.set({ bin: Number(slider.value), playing: false }),
    });
    const whole = element('button', { type: 'button', id: 'whole', onclick: () => store.set({ bin: null, playing: false }) }, 'Whole run');
    const play = element('button', { type: 'button', id: 'play', onclick: () => store.set({ playing: !store.get().playing }) });
    const text = element('output', { id: 'time-text', for: 'time' });
    store.follow(['bin', 'playing'], ({ bin, playing }) => {
        whole.setAttribute('aria-pressed', bin === null);
        slider.value = bin ?? 0;
        slider.classList.toggle('off', bin === null);
        slider.setAttribute('aria-valuetext', describeBin(run, bin));
        play.textContent = playing ? '\u275a\u275a Pause' : '\u25b6 Play';
        text.textContent = describeBin(run, bin);
    });
    playOn(run, store);
    return element('div', { class: 'time' }, whole, play,
        element('div', { class: 'track' }, phaseStrip(run), slider), text);
}

function playOn(run, store) {
    let timer = null;
    const step = () => {
        const { bin } = store.get();
        const next = bin === null ? 0 : bin + 1;
        store.set(next < run.bins ? { bin: next } : { playing: false });
    };
    store.follow(['playing'], ({ playing, bin }) => {
        clearInterval(timer);
        if (playing) {
            if (bin === run.bins - 1) {
                store.set({ bin: 0 });
            }
            timer = setInterval(step, STEP);
        }
    });
}

// Where the phases lie, above the slider; what it says is in its text and in the table of phases.
function phaseStrip(run) {
    return element('div', { class: 'phases', 'aria-hidden': 'true' }, run.statistics.phases.map((phase, i) =>
        element('span', {
            class: i % 2 === 0 ? 'even' : 'odd',
            style: `left:${(100 * phase.start_ps) / run.endPs}%;width:${(100 * phase.duration_ps) / run.endPs}%`,
            title: `${phase.name}: ${time(phase.duration_ps)}`,
        }, phase.name)));
}
