# SPDX-License-Identifier: MIT
"""Small measurements of Parks' claims: what instruction forms cost, and how many small polygons take as long as a large one."""

import csv
import re
import tempfile
from pathlib import Path

from measuring import ROOT, setting
from parks_machines import THESIS, appendix_c

FORMS = ROOT / "tests/isa/parks-costs.csv"
BLOCK = 128
POINTS = 200  # on average over so many
CELL = 24


def listed(form):
    """A form of the table as assembly; a far jump is an inverted branch and a JMP."""
    text = form.replace("any,", "r1, ").replace("#", "#1234").replace("@X(R)", "@8.(r3)").replace("X(R)", "10(r3)")
    text = re.sub(r"\(R\)", "(r4)", text)
    text = re.sub(r"\bR\b", "r0", text)
    return {"br near": "br .+4", "bcc near": "bcc .+4", "bcc far": "bcs .+6\n jmp @#1000"}.get(form, text)


def differing_forms(emulator):
    """How many forms the assembler's listing does not count as the thesis does: fetch and data cycles together."""
    with open(FORMS, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return sum(cycles_of(emulator, listed(row["form"])) != int(row["fetch"]) + int(row["data"]) for row in rows)


def cycles_of(emulator, text):
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "form.s"
        source.write_text(f"start: {text}\n .end start\n")
        listing = emulator.text("assemble", str(source), "--listing", "--cost", "parks")
    return sum(int(fetch) + int(data) for fetch, data in re.findall(r"^\d{6}  (?:\d{6} ?)+ +(\d+) +(\d+) ", listing, re.MULTILINE))


def cycles_of_scene(emulator, polygons):
    """By the formula and emulated, thesis' precision: all of the polygons, lists of (x, y)."""
    lines = [line for polygon in polygons for line in ("polygon", *(f"{x} {y} 1000 100" for x, y in polygon))]
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "claim.polygons"
        scene.write_text("\n".join(lines) + "\n")
        found = appendix_c(emulator, "uniprocessor", *setting(scene__object=scene), *THESIS)[0]["P0"]
    return found["formula_u"], sum(found["cycles_u"].values()) - found["cycles_u"]["other"]


def block():
    return [(0, 0), (BLOCK - 1, 0), (BLOCK - 1, BLOCK - 1), (0, BLOCK - 1)]


def corners():
    return [(CELL * (i % 20), CELL * (i // 20)) for i in range(POINTS)]


def times_as_long(emulator, small):
    """Cycles of a block over the mean of the small polygons': by the formula, emulated."""
    return tuple(large / (cycles / len(small)) for large, cycles in zip(cycles_of_scene(emulator, [block()]), cycles_of_scene(emulator, small)))


def points_for_a_block(emulator):
    return times_as_long(emulator, [[corner] for corner in corners()])


def small_triangles_for_a_block(emulator):
    """Right triangles of 13 lines, emulated."""
    return times_as_long(emulator, [[(x, y), (x + 12, y), (x, y + 12)] for x, y in corners()])[1]
