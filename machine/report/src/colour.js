// SPDX-License-Identifier: MIT
// Cividis (Nuñez, Anderton and Renslow 2018): perceptually uniform, the same to people who are
// colour-blind. States have colours of Okabe and Ito's palette, always with their names beside.

const CIVIDIS = ['#00224e', '#123570', '#3b496c', '#575d6d', '#707173', '#8a8678', '#a59c74', '#c3b369', '#e1cc55', '#fee838'];

const STATES = {
    busy: '#0072b2',
    waiting_input: '#e69f00',
    waiting_output: '#cc79a7',
    waiting_phase: '#9fc9e8',
    waiting_interrupt: '#b9a6e0',
    asleep: '#d9d9d9',
    halted: '#8c8c8c',
    waiting: '#e69f00',
    blocked: '#e69f00',
};
const OTHERS = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#8c8c8c'];

const STOPS = CIVIDIS.map(channels);

export function channels(hex) {
    return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
}

// [red, green, blue], 0 to 255, of a value from 0 to 1.
export function scaleColour(value) {
    const at = Math.min(Math.max(value, 0), 1) * (STOPS.length - 1);
    const low = Math.min(Math.floor(at), STOPS.length - 2);
    return STOPS[low].map((channel, i) => channel + (STOPS[low + 1][i] - channel) * (at - low));
}

export function gradient() {
    return `linear-gradient(to right, ${CIVIDIS.join(', ')})`;
}

export function stateColour(name, index = 0) {
    return STATES[name] ?? OTHERS[index % OTHERS.length];
}

export function lineColour(index) {
    return OTHERS[index % OTHERS.length];
}

export function themeColour(name) {
    return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

// Paper is light, too.
export function onThemeChange(callback) {
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', callback);
    matchMedia('print').addEventListener('change', callback);
}
