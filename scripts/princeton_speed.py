# SPDX-License-Identifier: MIT
"""How fast the emulation of the Princeton Engine runs: emulated time over wall time."""

import re

from measuring import EmulatorError, table
from princeton_machine import CONFIG, SMALL, changes_of, machine_scenes, textured_scene

LANES = (64, 256, 1024, 4096, 16384)  # the program numbers lanes up to 32 767; below 768 it draws as many columns
RUNS = 3
FRAMES = "1"  # one of 16 384 lanes takes the host some 20 s


def figures(emulator, scene, *arguments):
    """Real-time factor, thousand million lane-instructions/s: the best of some runs."""
    best = (0.0, 0.0)
    for _ in range(RUNS):
        summary = emulator.text("run", f"configs/{CONFIG}.yaml", "--no-files", "--frames", FRAMES, *changes_of(scene), *arguments)
        rate = float(re.search(r"time: ([0-9.]+) million", summary).group(1)) / 1000
        best = max(best, (float(re.search(r"real-time factor ([0-9.e+-]+)", summary).group(1)), rate))
    return best


def row(emulator, title, scene, *arguments):
    one, two = (figures(emulator, scene, "--threads", str(threads), *arguments) for threads in (1, 2))
    return [title, f"{one[0]:.3f}", f"{one[1]:.2f}", f"{two[0]:.3f}", f"{two[1]:.2f}"]


def vector_paths(emulator):
    """Those of this host, as the command names them where it is asked for another."""
    try:
        emulator.text("run", f"configs/{CONFIG}.yaml", "--no-files", "--vectors", "?")
    except EmulatorError as error:
        return re.search(r"expected one of (.*)", str(error)).group(1).split(", ")


def speed(emulator, arguments):
    """Not line-locked but for the first row: waiting for a scanline costs the host nothing."""
    free = (("array.line_locked", "false"),)
    rows = [row(emulator, "teapot 9408, shaded, but line-locked", SMALL)]
    for name, scene in machine_scenes(arguments).items():
        for textured in (False, True):
            rows.append(row(emulator, f"{name}, {'textured' if textured else 'shaded'}", textured_scene(scene, textured) + free))
    for n in LANES:
        screen = (("topology.nodes", str(n)), ("screen.width", str(min(n, 768))))
        rows.append(row(emulator, f"teapot 9408, shaded, {n} lanes", free + screen))
    for path in vector_paths(emulator):
        rows.append(row(emulator, f"teapot 9408, shaded, {path}", free, "--vectors", path))
    table(["scene, not line-locked", "real-time factor, one thread", "10^9 lane-instructions/s", "two threads", "10^9 lane-instructions/s"], rows)
