// SPDX-License-Identifier: MIT
// Sorts of components and what is known of each: processors, links, parts of the fabric. Which
// there are, and in which states, comes from the data.

export const METRICS = [
    { key: 'busy', title: 'Utilisation', unit: 'share', text: 'busy' },
    { key: 'waiting', title: 'Waiting', unit: 'share', text: 'waiting' },
    { key: 'queue', title: 'Queue length', unit: 'messages', text: 'queued' },
];

// Columns that stand in for a role where nothing was followed over time.
const COLUMNS = { busy: ['busy_ps'], waiting: ['blocked_ps'], queue: ['input_mean', 'low_mean', 'high_mean'] };

const SORTS = [
    { key: 'node', table: 'nodes', noun: 'processor', title: 'Processors', name: (table, i) => table.get(i, 'name') },
    { key: 'link', table: 'links', noun: 'link', title: 'Links', name: (table, i) => `${table.get(i, 'from_name')} > ${table.get(i, 'to_name')}` },
    { key: 'part', table: 'parts', noun: 'part', title: 'Fabric', name: (table, i) => table.get(i, 'name') },
];

export function createKinds(run) {
    return SORTS.filter((sort) => run.tables[sort.table]?.rows.length > 0).map((sort) => createKind(sort, run));
}

function createKind(sort, run) {
    const table = run.tables[sort.table];
    const series = run.series.filter((each) => each.of === sort.key);
    const byRole = (role) => series.filter((each) => each.role === role);
    const names = table.rows.map((_, i) => sort.name(table, i));
    const greatest = {};
    const index = new Map(names.map((name, i) => [name, i]));

    function whole(metric, i) {
        const followed = byRole(metric);
        const ps = followed.length > 0 ? followed.reduce((sum, each) => sum + each.totalPs(i), 0) : null;
        if (ps !== null) {
            return run.endPs > 0 ? ps / run.endPs : 0;
        }
        const sum = COLUMNS[metric].reduce((all, column) => all + (table.get(i, column) ?? 0), 0);
        return metric === 'queue' || run.endPs === 0 ? sum : sum / run.endPs;
    }

    return {
        ...sort,
        data: table,
        series,
        names,
        count: names.length,
        indexOf: (name) => index.get(name) ?? -1,
        hasBins: (metric) => byRole(metric).length > 0,
        // Share of time, or messages; of one bin or, with null, of the whole run. Null: not known.
        value(metric, i, bin) {
            if (bin === null) {
                return whole(metric, i);
            }
            const followed = byRole(metric);
            return followed.length > 0 ? followed.reduce((sum, each) => sum + each.at(i, bin), 0) : null;
        },
        greatest(metric) {
            greatest[metric] ??= names.reduce((most, _, i) => Math.max(most, whole(metric, i)), 0);
            return greatest[metric];
        },
        // Of all components, in one bin.
        mean(metric, bin) {
            let sum = 0;
            for (let i = 0; i < names.length; ++i) {
                sum += this.value(metric, i, bin);
            }
            return sum / names.length;
        },
        most(metric, bin) {
            let most = 0;
            for (let i = 0; i < names.length; ++i) {
                most = Math.max(most, this.value(metric, i, bin));
            }
            return most;
        },
    };
}

// What the colours of one sort reach to, so that differences can be seen: to the greatest of the
// whole run, or in a bin to all of its time.
export function colourReach(kind, metric, bin) {
    if (bin === null) {
        const greatest = kind.greatest(metric);
        return metric === 'queue' ? greatest : Math.min(greatest, 1);
    }
    return Math.max(...kind.series.filter((each) => each.role === metric).map((each) => each.scale), 0);
}
