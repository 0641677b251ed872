# SPDX-License-Identifier: MIT
"""That the picture is the same, byte for byte, whatever draws it: with any tiles, rule, assignment, FIFO and number of rasterizers, by hardware and software."""

import sys
import tempfile
from itertools import product
from pathlib import Path

from chen_machine import HARDWARE, RULES, SOFTWARE, UNLIMITED, UNTILED, changes_of
from chen_scenes import TILES, synthetic
from measuring import table

SIDES = (*TILES, "24x40", UNTILED)
ASSIGNMENTS = ("interleaved", "blocks", "next_free", "largest_first")
COUNTS = (1, 16)
SCENES = ("Quake", "Cylhead")
PICTURE = "frame-000.png"


def picture(emulator, scene, config, tile, **changes):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        emulator.run_into(out, config, *changes_of(emulator, scene, tile, **changes))
        return (out / PICTURE).read_bytes()


def hardware_runs():
    for tile, rule, assignment, fifo, count in product(SIDES, RULES.values(), ASSIGNMENTS, (1, UNLIMITED), COUNTS):
        yield tile, {"sorter__rule": rule, "sorter__assignment": assignment, "rasterizer__fifo": fifo, "topology__rasterizers": count}


def software_runs():
    for tile, rule, count in product(SIDES, RULES.values(), COUNTS):
        yield tile, {"sorter__rule": rule, "sorter__assignment": "next_free", "topology__rasterizers": count}


def pictures(emulator, _arguments):
    rows, other = [], []
    for name in SCENES:
        scene = synthetic(name)
        expected = picture(emulator, scene, HARDWARE, UNTILED)
        for title, config, runs in (("hardware", HARDWARE, hardware_runs()), ("software", SOFTWARE, software_runs())):
            found = [(tile, changes, picture(emulator, scene, config, tile, **changes) == expected) for tile, changes in runs]
            other += [f"{name}, {title}, {tile}, {changes}" for tile, changes, same in found if not same]
            rows.append([name, title, len(found), sum(same for _, _, same in found)])
    table(["scene", "rasterizers", "runs", f"with the untiled {PICTURE}, byte for byte"], rows)
    if other:
        sys.exit("\n".join(["Pictures that differ:", *other]))
