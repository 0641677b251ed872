# SPDX-License-Identifier: MIT
"""How fast the emulation runs: real-time factor at 300 ns a cycle."""

import re

from measuring import table
from parks_machines import scene_arguments


def factor(emulator, machine, threads, *arguments):
    summary = emulator.text("run", f"configs/{machine}.yaml", "--no-files", "--threads", str(threads), *arguments)
    return float(re.search(r"real-time factor ([0-9.e+-]+)", summary).group(1))


def speed(emulator, _arguments):
    """The best of five runs each; runs with one and two threads take turns."""
    rows = []
    for machine, scene, frames in (("uniprocessor", "runway", 1), ("splitter16", "runway", 1), ("splitter16", "airport", 60),
                                   ("interlace16", "airport", 60), ("interlace256", "runway", 1), ("interlace256", "airport", 60),
                                   ("splitter256", "airport", 60), ("geodesic482", None, 1)):
        arguments = scene_arguments(scene, frames) if scene else []
        best = {1: 0.0, 2: 0.0}
        for _ in range(5):
            for threads in best:
                best[threads] = max(best[threads], factor(emulator, machine, threads, *arguments))
        rows.append([machine, scene or "teapot", frames, f"{best[1]:.2f}", f"{best[2]:.2f}", f"{best[2] / best[1]:.2f}"])
    table(["machine", "scene", "frames", "real-time factor, one thread", "two threads", "speed-up"], rows)
