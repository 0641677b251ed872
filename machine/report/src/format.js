// SPDX-License-Identifier: MIT
// Numbers for a person to read.

const TIMES = [[1e12, 's'], [1e9, 'ms'], [1e6, 'us'], [1e3, 'ns'], [1, 'ps']];

export function figures(value, digits = 4) {
    if (value === 0) {
        return '0';
    }
    const places = digits - 1 - Math.floor(Math.log10(Math.abs(value)));
    return String(Number(value.toFixed(Math.min(Math.max(places, 0), 12))));
}

// "145.4 ms" of picoseconds.
export function time(ps, digits = 4) {
    const [size, unit] = TIMES.find(([least]) => Math.abs(ps) >= least) ?? TIMES.at(-1);
    return `${figures(ps / size, digits)} ${unit}`;
}

export function percent(share) {
    return `${(100 * share).toFixed(1)} %`;
}

export function count(value) {
    return value.toLocaleString('en-US').replaceAll(',', '\u2009');
}

export function plural(number, noun) {
    return `${count(number)} ${noun}${number === 1 ? '' : noun.endsWith('s') ? 'es' : 's'}`;
}

// "waiting_input_ps" -> "waiting input".
export function label(column) {
    return column.replace(/_(ps|u)$/, '').replaceAll('_', ' ');
}

// What a table or the details show of a column's value: by the unit in its name.
export function cell(column, value) {
    if (typeof value !== 'number') {
        return String(value ?? '');
    }
    if (column.endsWith('_ps')) {
        return value === 0 ? '0' : time(value);
    }
    if (column === 'utilisation' || column === 'share') {
        return percent(value);
    }
    return Number.isInteger(value) ? count(value) : figures(value);
}
