#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures what docs/results.md reports about the geodesic machine and prints it as Markdown tables.

    scripts/results.py graph | rounds | frame | pictures | speed | scaling | all
        [--rasterloom build/release/rasterloom] [--models ../shared/models] [--plots DIR]

Each table runs `rasterloom` on the shipped configurations; nothing is computed here but ratios. Models that are
not there are left out, and the table says so.
"""

import json
import os
import re
import subprocess
import tempfile
from pathlib import Path

from geodesic_measures import CONFIG, PHASES, compared, drawing, frame_of, graph_of, rotation
from measuring import ROOT, EmulatorError, plot_figure, print_tables, setting, table

MODELS = ["beethoven.ply", "bunny.obj", "shuttle.obj"]


def graph(emulator, _arguments):
    rows = []
    for b, c in ((1, 0), (1, 1), (2, 1), (3, 2), (5, 0), (4, 4), (8, 8), (20, 20)):
        found = graph_of(emulator, b, c)
        degrees = ", ".join(str(found["degrees"].get(degree, 0)) for degree in (5, 6))
        rows.append([f"({b}, {c})", found["nodes"], degrees, *(found[key] for key in ("edges", "diameter", "radius", "mean", "planar"))])
    table(["(b, c)", "nodes", "of degree 5, 6", "edges", "diameter", "radius", "mean distance", "planar"], rows)
    print(emulator.text("describe", CONFIG, "--node", "P31-123"))


PUBLISHED_ROTATIONS = {6: (1, 2), 30: (3, 5), 180: (20, 26)}
PUBLISHED_DRAWINGS = {"sphere": (9, 10), "cube": (3, 5)}


def rounds(emulator, arguments):
    curves = {}
    rows = []
    for routing in ("small_circle", "great_circle"):
        found = {f"rotate the sphere by {degrees} degrees": (rotation(emulator, degrees, routing), published)
                 for degrees, published in PUBLISHED_ROTATIONS.items()}
        found |= {f"draw the {name}": (drawing(emulator, name, routing), published) for name, published in PUBLISHED_DRAWINGS.items()}
        for what, (numbers, published) in found.items():
            curves[f"{what}, {routing}"] = numbers["utilisation"]
            longest, expected = published if routing == "small_circle" else ("-", "-")
            rows.append([what, routing.replace("_", "-"), numbers["longest"], longest, numbers["rounds"], expected,
                         f"{numbers['busiest']} ({numbers['busiest_messages']})", shares(numbers["utilisation"])])
    table(["what", "routing", "longest route", "published", "rounds", "published", "busiest sender (messages)",
           "processors that send, % a round"], rows)
    if arguments.plots:
        plot(curves, arguments.plots)


def shares(utilisation):
    shown = [f"{100 * share:.0f}" for share in utilisation]
    return " ".join(shown if len(shown) <= 12 else shown[:8] + ["...", *shown[-3:]]) + (
        f" ({len(shown)} rounds)" if len(shown) > 12 else "")


def plot(curves, folder):
    for routing in ("small_circle", "great_circle"):
        def draw(axes, routing=routing):
            for label, utilisation in curves.items():
                if label.endswith(routing):
                    axes.plot(range(1, len(utilisation) + 1), [100 * u for u in utilisation],
                              label=label.split(", " + routing)[0])
        plot_figure(folder / f"rounds-{routing}.png", draw,
                    f"Utilisation a round, {routing.replace('_', '-')} routing (compare Strothotte 1981, figures 18, 20-23)",
                    "round", "processors that send, %")


# Strothotte 1981, 5.3.5: p = 482, m = 1, two crossings, 6 degrees, half of the screen, 500 triangles.
THESIS_FRAME = {"rotate": 66, "points": 1096, "assemble": "in Ci", "transfer": 800, "draw": 3680}


def frame(emulator, _arguments):
    rows = []
    for name, scale in (("sphere", 0.8), ("teapot", 0.9)):
        for move in (0, 1):
            for u in ("1us", "5us"):
                found = frame_of(emulator, name, scale, move, u)
                rows.append([name, u, move, *(found[part] for part in PHASES), found["frame"], f"{1e12 / found['picoseconds']:.2f}"])
    rows.append(["thesis' estimate", "5us", 0, *THESIS_FRAME.values(), 5642, f"{1e6 / (5642 * 5):.1f}"])
    table(["object", "u", "move, branch", *(f"{part} (u)" for part in THESIS_FRAME), "frame (u)", "frames/s"], rows)


def pictures(emulator, arguments):
    scenes = [(name, setting(scene__object=name)) for name in ("sphere", "cube", "teapot")]
    for model in MODELS:
        path = Path(arguments.models) / model
        if (ROOT / path).exists():
            scenes.append((model, ["--mesh", str(path)]))
        else:
            print(f"({model} is not in {arguments.models}: left out)\n")
    rows = []
    for name, choice in scenes:
        for b, c in ((4, 4), (8, 8)):
            for degrees, frames in ((0, 1), (6, 3)):
                _, summary = emulator.run("geodesic482", "--compare", "--frames", str(frames), *choice,
                                          *setting(topology__b=b, topology__c=c, scene__rotate__degrees=degrees))
                rows.append([name, f"({b}, {c})", degrees * (frames - 1), *compared(summary)])
    table(["object", "(b, c)", "turned by, degrees", "pixels within 2 grey levels, %", "of the object's pixels, %",
           "greatest difference"], rows)


def emulated_in(summary):
    line = next(line for line in summary.splitlines() if line.startswith("Emulated in"))
    return re.sub(r"\s+", " ", line.removeprefix("Emulated in").strip())


def speed(emulator, _arguments):
    rows = []
    for frames in (1, 10):
        best = None
        for _ in range(5):
            statistics, summary = emulator.run("geodesic482", "--frames", str(frames))
            line = emulated_in(summary)
            factor = float(re.search(r"real-time factor ([0-9.e+-]+)", line).group(1))
            if best is None or factor > best[0]:
                best = (factor, statistics, line)
        rows.append([frames, best[1]["instructions"], best[1]["messages"], best[2]])
    table(["teapot frames", "instructions", "hops", "best of five runs"], rows)


def scaling(emulator, _arguments):
    rows = []
    for b, c in ((4, 4), (6, 6), (8, 8), (12, 12), (16, 16), (20, 20)):
        statistics, wall, memory = measured(emulator, *setting(topology__b=b, topology__c=c))
        nodes = statistics["nodes"]
        rows.append([f"({b}, {c})", nodes, statistics["instructions"], statistics["messages"],
                     statistics["frames"][0]["duration_u"], f"{wall:.2f}", f"{memory / 1024:.0f}",
                     f"{1e9 * wall / statistics['instructions']:.0f}", f"{memory / nodes:.0f}"])
    table(["(b, c)", "nodes", "instructions", "hops", "frame (u)", "processor time (s)", "memory (MiB)",
           "ns an instruction", "KiB a node"], rows)


def measured(emulator, *arguments):
    """One run of the teapot, files and all: its statistics, seconds of processor time, KiB of memory."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        child = subprocess.Popen([emulator.binary, "run", "configs/geodesic482.yaml", "--out", str(out), "--quiet", *arguments],
                                 cwd=ROOT)
        _, status, usage = os.wait4(child.pid, 0)
        if status != 0:
            raise EmulatorError(f"{' '.join(arguments)} failed")
        statistics = json.loads((out / "statistics.json").read_text())
    return statistics, usage.ru_utime + usage.ru_stime, usage.ru_maxrss


TABLES = {"graph": graph, "rounds": rounds, "frame": frame, "pictures": pictures, "speed": speed, "scaling": scaling}


if __name__ == "__main__":
    print_tables(__doc__, TABLES)
