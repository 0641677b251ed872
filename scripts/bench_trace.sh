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

# Milliseconds of a whole process.
milliseconds() {
    local start
    start=$(date +%s%N)
    "$rasterloom" run "configs/$machine.yaml" --frames "$frames" --threads 1 --no-files --quiet "$@"
    echo $((($(date +%s%N) - start) / 1000)) | awk '{print $1 / 1000}'
}
emulated() {
    "$rasterloom" run "configs/$machine.yaml" --frames "$frames" --threads 1 --no-files | awk '/^Emulated in/ {print $4 == "s" ? 1000 * $3 : $3}'
}

for _ in $(seq "$runs"); do
    echo "run $(emulated)"
    echo "off $(milliseconds)"
    echo "perfetto $(milliseconds --trace "$folder/x.perfetto-trace")"
    echo "sqlite $(milliseconds --trace "$folder/x.sqlite")"
done | awk -v machine="$machine" -v frames="$frames" '
    !($1 in least) || $2 < least[$1] {least[$1] = $2}
    END {
        printf "%s, %d frames: %.0f ms emulated, %.0f ms the whole process\n", machine, frames, least["run"], least["off"]
        for (i = 1; i <= 2; ++i) {
            kind = i == 1 ? "perfetto" : "sqlite"
            printf "--trace NAME.%s: %.0f ms, %.0f %% of the emulated run more\n", kind, least[kind], 100 * (least[kind] - least["off"]) / least["run"]
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
