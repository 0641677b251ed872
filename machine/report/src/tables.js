// SPDX-License-Identifier: MIT
// Everything as tables: a click or Enter on a column's head sorts, rows come by pages, the name of a
// component selects it.
import { element, heading } from './dom.js';
import { cell, count, label, plural } from './format.js';

const PAGE = 20;

function phaseTable(run) {
    const columns = ['frame', 'phase', 'name', 'start_ps', 'duration_ps', 'duration_u', 'messages', 'bytes', 'longest_route_hops', 'instructions', 'busy_ps', 'waiting_input_ps', 'waiting_output_ps', 'waiting_phase_ps'];
    const rows = run.statistics.phases.map((phase) => columns.map((column) => phase[column] ?? phase.all_nodes[column]));
    return { key: 'phases', title: 'Phases', columns, rows, names: null };
}

function componentTable(kind) {
    const { columns, rows } = kind.data;
    const kept = columns.map((_, i) => i).filter((i) => !/^from_name$|^to_name$|^name$|^from$|^to$|^node$/.test(columns[i]));
    return {
        key: kind.key,
        title: kind.title,
        columns: ['name', ...kept.map((i) => columns[i])],
        rows: rows.map((row, index) => [kind.names[index], ...kept.map((i) => row[i])]),
        names: (index) => ({ kind: kind.key, index }),
    };
}

const natural = new Intl.Collator('en', { numeric: true });

function compare(a, b) {
    return typeof a === 'number' && typeof b === 'number' ? a - b : natural.compare(String(a), String(b));
}

// The order in which rows are shown: numbers begin with the greatest, names with the first.
function ordered(table, { column, descending }, filter) {
    const wanted = table.rows.map((_, i) => i).filter((i) => filter === '' || String(table.rows[i][0]).toLowerCase().includes(filter));
    if (column === null) {
        return wanted;
    }
    const sign = descending ? -1 : 1;
    return wanted.sort((a, b) => sign * compare(table.rows[a][column], table.rows[b][column]) || a - b);
}

// "waited_for" is a name, "waited_for_ps" a time.
function headOf(table, name) {
    return name.endsWith('_ps') && table.columns.includes(name.slice(0, -3)) ? `${label(name)}, time` : label(name);
}

function createTable(table, store) {
    const state = { sort: { column: null, descending: false }, page: 0, filter: '' };
    const body = element('tbody', {});
    const heads = table.columns.map((name, column) => element('th', { scope: 'col' },
        element('button', { type: 'button', onclick: () => sortBy(column) }, headOf(table, name), name.endsWith('_u') ? element('small', {}, ' u') : null)));
    const pages = pager(table, state, () => show());
    const grid = element('table', { id: `table-${table.key}`, class: 'sortable' }, element('caption', { class: 'unseen' }, table.title),
        element('thead', {}, element('tr', {}, heads)), body);

    function sortBy(column) {
        const same = state.sort.column === column;
        const descending = same ? !state.sort.descending : typeof table.rows[0]?.[column] === 'number';
        state.sort = { column, descending };
        state.page = 0;
        show();
    }
    function show() {
        const order = ordered(table, state.sort, state.filter);
        heads.forEach((head, i) => head.setAttribute('aria-sort', i !== state.sort.column ? 'none' : state.sort.descending ? 'descending' : 'ascending'));
        pages.update(order.length);
        body.replaceChildren(...order.slice(state.page * PAGE, (state.page + 1) * PAGE).map((row) => tableRow(table, row, store)));
    }
    show();
    return element('div', { class: 'table-box' }, pages.node, element('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': table.title }, grid));
}

function tableRow(table, index, store) {
    const cells = table.rows[index].map((value, column) => {
        const text = cell(table.columns[column], value);
        if (column === 0 && table.names) {
            return element('th', { scope: 'row', 'data-value': value }, element('button', { type: 'button', class: 'link', onclick: () => store.set({ selected: table.names(index) }) }, text));
        }
        return element('td', { class: typeof value === 'number' ? 'number' : '', 'data-value': value ?? '' }, text);
    });
    return element('tr', { 'data-row': index }, cells);
}

function pager(table, state, show) {
    const text = element('output', {});
    const move = (by) => { state.page += by; show(); };
    const before = element('button', { type: 'button', 'aria-label': `${table.title}: rows before`, onclick: () => move(-1) }, '\u25c0');
    const next = element('button', { type: 'button', 'aria-label': `${table.title}: next rows`, onclick: () => move(1) }, '\u25b6');
    const filter = element('input', {
        type: 'search', placeholder: 'Name contains', 'aria-label': `${table.title}: names that contain`,
        oninput: () => { state.filter = filter.value.trim().toLowerCase(); state.page = 0; show(); },
    });
    const node = element('div', { class: 'pager' }, table.names && table.rows.length > PAGE ? filter : null, before, next, text);
    return {
        node,
        update(rows) {
            const first = state.page * PAGE;
            const last = Math.min(first + PAGE, rows);
            before.disabled = state.page === 0;
            next.disabled = last >= rows;
            before.hidden = next.hidden = table.rows.length <= PAGE;
            text.textContent = rows === 0 ? 'none' : rows <= PAGE ? plural(rows, 'row') : `${count(first + 1)} to ${count(last)} of ${count(rows)}`;
        },
    };
}

export function createTables(root, run, store) {
    const tables = [phaseTable(run), ...run.kinds.map(componentTable)].filter((table) => table.rows.length > 0);
    root.append(heading('tables-title', 'Tables'), ...tables.map((table, i) =>
        element('details', { open: i < 2 }, element('summary', {}, element('h3', {}, table.title, element('small', {}, ` ${count(table.rows.length)}`))), createTable(table, store))));
}
