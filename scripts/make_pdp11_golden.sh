#!/usr/bin/env bash
# Regenerates tests/isa/golden/ from GNU's assembler and disassembler for the PDP-11, and shows what changed.
# They come from PDP11_AS and PDP11_OBJDUMP, or are built (a few minutes) from Debian's package binutils-source.
set -euo pipefail
cd "$(dirname "$0")/.."

tools=${TMPDIR:-/tmp}/rasterloom-pdp11-binutils
if [ -z "${PDP11_AS:-}" ]; then
    PDP11_AS=$tools/build/gas/as-new
    PDP11_OBJDUMP=$tools/build/binutils/objdump
fi
if [ ! -x "$PDP11_AS" ]; then
    source=$(ls /usr/src/binutils/binutils-*.tar.xz 2>/dev/null | head -1)
    [ -n "$source" ] || { echo "install binutils-source, or set PDP11_AS and PDP11_OBJDUMP" >&2; exit 1; }
    mkdir -p "$tools/build"
    tar -xf "$source" -C "$tools" --strip-components=1
    (cd "$tools/build" &&
        ../configure --target=pdp11-aout --disable-nls --disable-gdb --disable-gprofng --disable-gprof \
            --disable-ld --disable-werror CFLAGS="-O1 -w" >configure.log 2>&1 &&
        make -j"$(nproc)" all-gas all-binutils MAKEINFO=true >make.log 2>&1)
fi

python3 scripts/make_pdp11_golden.py "$PDP11_AS" "$PDP11_OBJDUMP" tests/isa/golden
git --no-pager diff --stat -- tests/isa/golden
