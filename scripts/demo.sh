#!/usr/bin/env bash
# Sets up, builds and draws the teapot on 482 emulated processors; the picture is out/geodesic482/frame-000.png.
# Further arguments go to the run: scripts/demo.sh --frames 3 --set scene.rotate.degrees=20
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
command -v ccache >/dev/null && export CMAKE_CXX_COMPILER_LAUNCHER=ccache
[ -f build/release/build.ninja ] || cmake --preset release -DRASTERLOOM_TESTS=OFF
cmake --build --preset release --target rasterloom
build/release/rasterloom run configs/geodesic482.yaml "$@"
