#!/usr/bin/env bash
# How well the critical path predicts what another clock, link, bus or latency would do: for every shipped machine
# that has frames, the mean error of the predictions against the reruns. Needs a build (preset release).
set -euo pipefail
cd "$(dirname "$0")/.."

rasterloom=${RASTERLOOM:-build/release/rasterloom}
[ -x "$rasterloom" ] || { echo "bench_whatif.sh: $rasterloom is missing; build the preset release first" >&2; exit 1; }

graph=(--vary nodes.clock=x0.5,x2 --vary links.time_per_byte=x0.5,x2 --vary links.latency=x0.5,x2 --vary supervisor.latency=x0.5,x2)
rounds=(--vary nodes.clock=x0.5,x2 --vary links.time_per_message=x0.5,x2 --vary links.latency=x2,x5)
fabric=(--vary nodes.clock=x0.5,x2 --vary fabric.polygon_bus.time_per_word=x0.5,x2 --vary fabric.splitter.time_per_vertex=x0.5,x2
        --vary fabric.latency=x0.5,x2 --vary host.time_per_polygon=x0.5,x2 --vary supervisor.latency=x0.5,x2)
tiler=(--vary nodes.clock=x0.5,x2 --vary rasterizer.cycles_per_triangle=12,x2 --vary rasterizer.cycles_per_pixel=x2 --vary supervisor.latency=x2)
program=(--vary nodes.clock=x0.5,x2 --vary supervisor.latency=x2)

rows=$(for machine in ring edge-list geodesic482 geodesic482-rounds geodesic12002 uniprocessor splitter4 splitter16 splitter64 splitter256 interlace4 interlace16 interlace64 interlace256 hybrid16 hybrid64 \
    bucket-hardware bucket-hardware-infinite bucket16-static bucket16-dynamic bucket-software; do
    case $machine in geodesic482-rounds) vary=("${rounds[@]}") ;; geodesic*|ring|edge-list) vary=("${graph[@]}") ;;
        bucket-software) vary=("${program[@]}") ;; bucket*) vary=("${tiler[@]}") ;; *) vary=("${fabric[@]}") ;; esac
    "$rasterloom" whatif "configs/$machine.yaml" "${vary[@]}" | awk -v machine="$machine" '
        $NF ~ /%$/ {gsub("%", ""); error = ($NF - $(NF - 1)) / (1 + $(NF - 1) / 100); error = error < 0 ? -error : error
                    sum += error; ++count; greatest = error > greatest ? error : greatest}
        END {printf "| %s | %.2f | %.2f |\n", machine, sum / count, greatest}'
done)
printf '| machine | mean error, %% | greatest, %% |\n|---|---|---|\n%s\n' "$rows"
awk -F'|' '{sum += $3; ++count} END {printf "\nMean over all machines: %.2f %%\n", sum / count}' <<<"$rows"
