#!/usr/bin/env bash
# What a trace costs: a run of geodesic482's teapot without one, with one for the viewer and with one for SQL by turns, whole processes, the
# least of RUNS each. Wants an idle host. Needs a build (preset release).
set -euo pipefail
cd "$(dirname "$0")/.."

rasterloom=${RASTERLOOM:-build/release/rasterloom}
runs=${RUNS:-7}
frames=${FRAMES:-10}
machine=${MACHINE:-geodesic482}
[ -x "$rasterloom" ] || { echo "bench_trace.sh: $rasterloom is missing; build the preset release first" >&2; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

TIMEFORMAT='%R %U %S'
# Milliseconds of a whole process, of wall time and of all processors' time.
milliseconds() {
    { time "$rasterloom" run "configs/$machine.yaml" --frames "$frames" --threads 1 --no-files --quiet "$@"; } 2>&1 |
        awk '{print 1000 * $1, 1000 * ($2 + $3)}'
}
emulated() {
    "$rasterloom" run "configs/$machine.yaml" --frames "$frames" --threads 1 --no-files | awk '/^Emulated in/ {print $4 == "s" ? 1000 * $3 : $3}'
}

for _ in $(seq "$runs"); do
    echo "run $(emulated) 0"
    echo "off $(milliseconds)"
    echo "perfetto $(milliseconds --trace "$folder/x.perfetto-trace")"
    echo "sqlite $(milliseconds --trace "$folder/x.sqlite")"
done | awk -v machine="$machine" -v frames="$frames" '
    !($1 in wall) || $2 < wall[$1] {wall[$1] = $2}
    !($1 in busy) || $3 < busy[$1] {busy[$1] = $3}
    END {
        printf "%s, %d frames: %.0f ms emulated; the whole process %.0f ms, %.0f ms of processor time\n", machine, frames, wall["run"], wall["off"], busy["off"]
        for (i = 1; i <= 2; ++i) {
            kind = i == 1 ? "perfetto" : "sqlite"
            printf "%s: %.0f ms, %.0f ms of processor time; of the emulated run %.0f %% and %.0f %% more\n", kind, wall[kind], busy[kind],
                100 * (wall[kind] - wall["off"]) / wall["run"], 100 * (busy[kind] - busy["off"]) / wall["run"]
        }
    }'
# Counted by parsers that are not ours.
events=$(protoc --proto_path=tests/emulation --decode=Trace perfetto_subset.proto <"$folder/x.perfetto-trace" | grep -c '^  track_event {')
rows=$(/usr/bin/python3 -c 'import sqlite3, sys
print(sum(sqlite3.connect(sys.argv[1]).execute(f"SELECT count(*) FROM {table}").fetchone()[0] for table in ("message", "state")))' "$folder/x.sqlite")
report() {
    awk -v what="$1" -v count="$2" -v bytes="$(stat -c %s "$3")" 'BEGIN {printf "%s, %d bytes, %.1f each\n", what " " count, bytes, bytes / count}'
}
report 'perfetto: events' "$events" "$folder/x.perfetto-trace"
report 'sqlite: messages and states' "$rows" "$folder/x.sqlite"
