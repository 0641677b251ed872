// SPDX-License-Identifier: MIT
// CSV of RFC 4180, as the files beside this page are written: a header, then rows.

function splitRows(text) {
    const rows = [];
    let row = [];
    const field = /("(?:[^"]|"")*"|[^,\n]*)(,|\n|$)/gy;
    while (field.lastIndex < text.length) {
        const [, value, end] = field.exec(text);
        row.push(value.startsWith('"') ? value.slice(1, -1).replaceAll('""', '"') : value);
        if (end !== ',') {
            rows.push(row);
            row = [];
        }
    }
    return rows;
}

// Columns of numbers are numbers; names stay text, even such as look like numbers.
export function parseCsv(text) {
    const [columns, ...rows] = splitRows(text);
    const isName = columns.map((column) => /name|kind|waited_for$/.test(column));
    const values = rows.map((row) => row.map((field, i) => (isName[i] || field === '' || Number.isNaN(Number(field)) ? field : Number(field))));
    const at = Object.fromEntries(columns.map((column, i) => [column, i]));
    return { columns, rows: values, get: (row, column) => (column in at ? values[row][at[column]] : undefined), has: (column) => column in at };
}
