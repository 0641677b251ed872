# SPDX-License-Identifier: MIT
"""How fast the emulation of the Princeton Engine runs: emulated time over wall time."""

import re
import tempfile
from dataclasses import dataclass
from pathlib import Path

from measuring import EmulatorError, table
from princeton_machine import CONFIG, SMALL, changes_of, machine_scenes, textured_scene

SCHEMES = ("sort-first", "sort-middle", "sort-twice", "sort-last-sparse", "sort-last-dense")
STAGES = ("geometry", "migrate", "communicate", "normalise", "rasterise", "composite", "finish")
LANES = (64, 256, 1024, 4096, 16384)  # the renderers number lanes up to 32 767; below 768 one draws as many columns
MANY_LANES = (1024, 65536)  # of another program
RUNS = 3
FRAMES = "3"  # what is new to the host's memory in the first counts less
LONG = "1"  # where a frame takes the host seconds
FREE = (("array.line_locked", "false"),)

# Arithmetic in all units between two passes of a word around the ring.
PROGRAM = """
turns   = c0
start:  phase   1
        setc    turns, 200
next:   .rept   16
        adds    r1, r1, r2 | mul r3, r1, r2, 15
        adc     r2, r2, r3 | st r3, 0x100
        tltu    r1, r3
        .endr
        put     r1
        right   1
        get     r2
        dec     turns, next
        frame
        halt
        .end    start
"""
MACHINE = "topology: {{ kind: ring, nodes: {lanes} }}\nnodes: {{ isa: vliw, clock: 14MHz, program: many.s }}\narray: {{ line_locked: false }}\n"


@dataclass
class Figures:
    factor: float = 0.0  # of real time, over the run
    rate: float = 0.0  # thousand million lane-instructions/s
    stages: tuple = ()  # (name, real-time factor)


def figures(emulator, config, *arguments):
    """Those of the best of some runs."""
    best = Figures()
    for _ in range(RUNS):
        summary = emulator.text("run", str(config), "--no-files", *arguments)
        factor = float(re.search(r"real-time factor ([0-9.e+-]+)", summary).group(1))
        if factor > best.factor:
            rate = float(re.search(r"time: ([0-9.]+) million", summary).group(1)) / 1000
            phases = summary.partition("\nPhase ")[2].partition("\n\n")[0]
            best = Figures(factor, rate, tuple(re.findall(r"^(\S+) .*?([0-9.e+-]+)$", phases, re.M)))
    return best


def both(emulator, config, *arguments):
    """On one thread and on two."""
    return [figures(emulator, config, "--threads", str(threads), *arguments) for threads in (1, 2)]


def scene_run(emulator, scene, *arguments, scheme="sort-middle", frames=FRAMES):
    return both(emulator, f"configs/princeton1024-{scheme}.yaml", "--frames", frames, *changes_of(scene), *arguments)


def row(title, runs):
    return [title, *(cell for run in runs for cell in (f"{run.factor:.3f}", f"{run.rate:.2f}"))]


def stage_row(title, runs):
    stages = [dict(run.stages) for run in runs]
    return [title, *(", ".join(run.get(stage, "") for run in stages).strip(", ") for stage in STAGES)]


def vector_paths(emulator):
    """Those of this host, as the command names them where it is asked for another."""
    try:
        emulator.text("run", f"configs/{CONFIG}.yaml", "--no-files", "--vectors", "?")
    except EmulatorError as error:
        return re.search(r"expected one of (.*)", str(error)).group(1).split(", ")


def many_lanes(emulator, lanes):
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "many.s").write_text(PROGRAM)
        (Path(folder) / "many.yaml").write_text(MACHINE.format(lanes=lanes))
        return both(emulator, Path(folder) / "many.yaml")


def speed(emulator, arguments):
    """Not line-locked but for the first row: waiting for a scanline costs the host nothing."""
    runs = {"teapot 9408, shaded, but line-locked": scene_run(emulator, SMALL)}
    for name, scene in machine_scenes(arguments).items():
        for textured in (False, True):
            runs[f"{name}, {'textured' if textured else 'shaded'}"] = scene_run(emulator, textured_scene(scene, textured) + FREE)
    for scheme in SCHEMES:
        runs[f"teapot 9408, shaded, {scheme}"] = scene_run(emulator, FREE, scheme=scheme, frames=LONG if "last" in scheme else FRAMES)
    staged = list(runs)
    for lanes in LANES:
        screen = (("topology.nodes", str(lanes)), ("screen.width", str(min(lanes, 768))))
        runs[f"teapot 9408, shaded, {lanes} lanes"] = scene_run(emulator, FREE + screen, frames=LONG if lanes > 4096 else FRAMES)
    for lanes in MANY_LANES:
        runs[f"a loop of arithmetic and passes, {lanes} lanes"] = many_lanes(emulator, lanes)
    for path in vector_paths(emulator):
        runs[f"teapot 9408, shaded, {path}"] = scene_run(emulator, FREE, "--vectors", path)
    table(["scene, not line-locked", "real-time factor, one thread", "10^9 lane-instructions/s", "two threads", "10^9 lane-instructions/s"],
          [row(title, each) for title, each in runs.items()])
    table(["real-time factors by stage: one thread, two", *STAGES], [stage_row(title, runs[title]) for title in staged])
