#!/usr/bin/env bash
# Million PDP-11 instructions a second, cycles counted, beside SIMH's on the same raw images in the same minute.
# Times are processor time, so that other work on the machine disturbs them less. Needs a build (preset release).
set -euo pipefail
cd "$(dirname "$0")/.."

rasterloom=${RASTERLOOM:-build/release/rasterloom}
[ -x "$rasterloom" ] || { echo "bench_core.sh: $rasterloom is missing; build the preset release first" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Seconds of processor time a command takes.
seconds() {
    local TIMEFORMAT='%U %S'
    { time "$@" >"$work/out" 2>&1 </dev/null; } 2>"$work/time"
    awk '{print $1 + $2}' "$work/time"
}

# The image's words as deposits: it stands at 01000 (configs/bare-pdp11.yaml).
simh_script() {
    echo "set cpu 11/40"
    echo "set cpu 64k"
    od -An -v -w2 -to2 "$1" | awk '$1 != "000000" {printf "dep %o %s\n", 512 + 2 * (NR - 1), $1}'
    echo "run 1000"
    echo "quit"
}

printf '%-15s %15s %15s %15s %8s\n' loop instructions 'SIMH M/s' 'Rasterloom M/s' ratio
for loop in register_loop memory_loop muldiv_loop; do
    "$rasterloom" assemble "tests/bench/pdp11/$loop.s" -o "$work/$loop.bin" >/dev/null
    simh_script "$work/$loop.bin" >"$work/$loop.simh"
    simh=$(seconds pdp11 "$work/$loop.simh")
    ours=$(seconds "$rasterloom" run configs/bare-pdp11.yaml --set "nodes.program=$work/$loop.bin" --out "$work/results")
    count=$(grep -o '"instructions": *[0-9]*' "$work/results/statistics.json" | head -1 | grep -o '[0-9]*$')
    awk -v loop="$loop" -v n="$count" -v s="$simh" -v r="$ours" \
        'BEGIN {printf "%-15s %15d %15.1f %15.1f %8.2f\n", loop, n, n / s / 1e6, n / r / 1e6, s / r}'
done
