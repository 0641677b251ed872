#!/usr/bin/env bash
# Sets up, builds and runs every test. With --long, also the campaigns that take longer than five minutes.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
[ "${1:-}" = --long ] && export RASTERLOOM_LONG_TESTS=1
command -v ccache >/dev/null && export CMAKE_CXX_COMPILER_LAUNCHER=ccache
# scripts/demo.sh may have set the build up without them.
cmake --preset release -DRASTERLOOM_WERROR=ON -DRASTERLOOM_TESTS=ON
cmake --build --preset release
ctest --preset release -j "$(nproc)" --no-tests=error
