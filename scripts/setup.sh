#!/usr/bin/env bash
# Installs what Rasterloom needs to build and to pass its tests on Debian 12, and what the measuring scripts need. Does nothing when all of it is there.
set -euo pipefail

packages=(
    g++ cmake ninja-build ccache git ca-certificates
    libboost-dev libboost-graph-dev libboost-filesystem-dev libfmt-dev libspdlog-dev libyaml-cpp-dev
    libcli11-dev libassimp-dev libglm-dev libpng-dev zlib1g-dev nlohmann-json3-dev libprotozero-dev libsqlite3-dev protobuf-compiler libhwy-dev
    libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev
    simh python3-numpy python3-matplotlib
    libopenmpi-dev openmpi-bin
)
# For the page of `run --report` and its test. Whoever has them from elsewhere keeps them: Debian's npm is 400 packages.
command -v node >/dev/null || packages+=(nodejs)
command -v npm >/dev/null || packages+=(npm)
command -v chromium >/dev/null || command -v chromium-browser >/dev/null || command -v google-chrome >/dev/null || packages+=(chromium)

missing=()
for package in "${packages[@]}"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
echo "Installing: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
