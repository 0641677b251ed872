# SPDX-License-Identifier: MIT
"""Runs and sweeps of the bucket tiler on Chen's scenes: arguments of `triangles`, as chen_scenes.py has them."""

import csv
import json
import tempfile
from functools import lru_cache
from pathlib import Path

from chen_formula import HEIGHT, WIDTH
from chen_scenes import triangles_file
from measuring import ROOT, EmulatorError, plot_figure, scratch_folder, setting

UNTILED = f"{WIDTH}x{HEIGHT}"
HARDWARE, SOFTWARE = "bucket-hardware", "bucket-software"
UNLIMITED = "unlimited"
RULES = {"bounding box": "bounding_box", "exact": "exact", "covered": "covered"}


@lru_cache(maxsize=None)
def scene_file(emulator, scene):
    triangles = triangles_file(emulator, scene)
    path = triangles.with_suffix(".yaml")
    path.write_text(f"object: {triangles}\n")
    return path


def changes_of(emulator, scene, tile, **changes):
    return setting(scene=scene_file(emulator, scene), topology__tile=tile, **changes)


@lru_cache(maxsize=None)
def tiler(emulator, scene, tile, fifo=1, rule="bounding_box"):
    """What the statistics of a frame on one hardware rasterizer say of the tiler."""
    return emulator.run(HARDWARE, *changes_of(emulator, scene, tile, rasterizer__fifo=fifo, sorter__rule=rule))[0]["buckets"]


def draw_cycles(emulator, scene, tile, fifo=1, rule="bounding_box"):
    return tiler(emulator, scene, tile, fifo, rule)["frames"][0]["draw_u"]


def inefficiency(emulator, scene, tile, fifo=1, rule="bounding_box"):
    """R: time with tiles over that without, where every visible triangle is set up once."""
    return draw_cycles(emulator, scene, tile, fifo, rule) / draw_cycles(emulator, scene, UNTILED, fifo)


@lru_cache(maxsize=None)
def counted(emulator, scene, tile, textured=False, rule="bounding_box"):
    """What the software rasterizer spent on a frame, as `run --appendix-c` says."""
    texture = {"scene__texture": "checker"} if textured else {}
    records = {}
    emulator.run(SOFTWARE, *changes_of(emulator, scene, tile, sorter__rule=rule, **texture), "--appendix-c", records=records)
    return records["appendix-c.json"]["all_nodes"]


def sweep(emulator, scenes, vary):
    """Hardware rasterizers: a function from a scene's name and a value of each key of `vary` to the point's row of the sweep, as text."""
    folder = Path(tempfile.mkdtemp(dir=scratch_folder()))
    names = {str(scene_file(emulator, scene)): name for name, scene in scenes.items()}
    file = folder / "points.yaml"
    file.write_text(json.dumps({"configs": [str(ROOT / f"configs/{HARDWARE}.yaml")], "scenes": list(names), "vary": vary}))
    emulator.text("sweep", str(file), "--out", str(folder / "out"), "--quiet")
    with open(folder / "out" / "results.csv", newline="") as results:
        rows = {(names[row["scene"]], *(row[key] for key in vary)): row for row in csv.DictReader(results)}
    failed = [row for row in rows.values() if row["status"] != "done"]
    if failed:
        raise EmulatorError(f"{failed[0]['key']}: {failed[0]['error']}")
    return lambda name, *values: rows[(name, *map(str, values))]


def save(arguments, name, draw, title, x_label, y_label):
    if arguments.plots:
        plot_figure(arguments.plots / f"chen-{name}.png", draw, title, x_label, y_label)


def size_axis(axes, sizes):
    """A logarithmic axis with the tiles' sides as its marks."""
    axes.set_xscale("log", base=2)
    axes.set_xticks(sizes, [str(size) for size in sizes])


def bars_by_scene(axes, names, bars):
    """`bars`: title to a height a scene, side by side; a height may be missing."""
    width = 0.8 / len(bars)
    for i, (title, heights) in enumerate(bars.items()):
        there = [(place, height) for place, height in enumerate(heights) if height is not None]
        axes.bar([place + (i - (len(bars) - 1) / 2) * width for place, _ in there], [height for _, height in there], width, label=title)
    axes.set_xticks(range(len(names)), [name.replace(" ", "\n") for name in names])
    axes.margins(y=0.4)  # for the legend
