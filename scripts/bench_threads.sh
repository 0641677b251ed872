#!/usr/bin/env bash
# How much faster two threads are than one: both by turns, the least of five runs each, for a few machines.
# Wants an idle host. Needs a build (preset release).
set -euo pipefail
cd "$(dirname "$0")/.."

rasterloom=${RASTERLOOM:-build/release/rasterloom}
threads=${THREADS:-2}
runs=${RUNS:-5}
[ -x "$rasterloom" ] || { echo "bench_threads.sh: $rasterloom is missing; build the preset release first" >&2; exit 1; }

# Milliseconds of wall time that a run took, building and loading not counted.
milliseconds() {
    "$rasterloom" run "configs/$1.yaml" --frames "$2" --threads "$3" --no-files |
        awk '/^Emulated in/ {print $4 == "s" ? 1000 * $3 : $3}'
}

printf '%-18s %8s %12s %12s %9s\n' machine frames '1 thread' "$threads threads" speed-up
while read -r machine frames; do
    for _ in $(seq "$runs"); do
        echo "1 $(milliseconds "$machine" "$frames" 1)"
        echo "n $(milliseconds "$machine" "$frames" "$threads")"
    done | awk -v machine="$machine" -v frames="$frames" '
        !($1 in least) || $2 < least[$1] {least[$1] = $2}
        END {printf "%-18s %8d %9.1f ms %9.1f ms %9.2f\n", machine, frames, least["1"], least["n"], least["1"] / least["n"]}'
done <<'MACHINES'
splitter16 20
interlace256 10
hybrid64 20
geodesic482 10
geodesic12002 1
MACHINES
