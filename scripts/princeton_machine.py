# SPDX-License-Identifier: MIT
"""What the emulated Princeton Engine did (`rasterloom run configs/princeton1024-sort-middle.yaml`), as numbers: princeton.py prints them,
papers/eldridge1995.py compares them. All of it is emulated time; nothing depends on the host."""

import re
import sys
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from eldridge_formula import WORDS
from eldridge_ring import counts
from measuring import ROOT

CONFIG = "princeton1024-sort-middle"
SMALL = ()  # the configuration's own teapot, of 9408 triangles
LARGE = (("scene.polygons", "34404"),)  # 34 440
PROGRAM = "programs/vliw/sort_middle.s"
PICTURE = 910 * 525  # cycles of a picture on the video output
TURNS = (10, 20, 30)  # degrees
STRIDES = (1, 2, 4, 8, 16, 32)  # of the far passes; 1: none
BEST_STRIDE = 16
TEXTURE = "checker"
CROWDED = "does not fit a lane's memory"
SAMPLES = {False: 8, True: 4}  # pixels between two looks for the next polygon; programs/vliw/options.s


def changes_of(changes):
    return [part for name, value in changes for part in ("--set", f"{name}={value}")]


def textured_scene(scene, textured):
    return scene + (("scene.texture", TEXTURE),) if textured else scene


def symbols(**values):
    """Options of the program (programs/vliw/options.s)."""
    return (("nodes.symbols", "{" + ", ".join(f"{name}: {value}" for name, value in values.items()) + "}"),)


@lru_cache(maxsize=None)
def statistics(emulator, changes, *arguments):
    return emulator.run(CONFIG, *changes_of(changes), *arguments)[0]


def array(emulator, scene, line_locked=False, **options):
    """The array's part of the statistics of one frame."""
    locked = (("array.line_locked", "true" if line_locked else "false"),)
    return statistics(emulator, scene + locked + (symbols(**options) if options else ()))["array"]


def is_crowded(error):
    """Whether a run failed since there are too many polygons or descriptors for a lane's memory."""
    return "array is full" in str(error) or "polygons on" in str(error)


def named(rows, name):
    return next(row for row in rows if row["name"] == name)


def phase(found, name):
    return named(found["phases"], name)


def procedure(found, name):
    return named(found["procedures"], name)


def passes(found, stride=1):
    """Passes of descriptors by `stride` places, and by one. A pass shifts each word of a descriptor once, and nothing else does."""
    pass_words, words_places = found["shifts"], found["places"]
    far = (words_places - pass_words) // (stride - 1) // WORDS if stride > 1 else 0
    return far, pass_words // WORDS - far


def model(emulator, scene, *arguments):
    """`rasterloom communicate` on the boxes of the machine's first frame."""
    return counts(emulator, ("--machine", f"configs/{CONFIG}.yaml", *changes_of(scene)), *arguments)


@lru_cache(maxsize=None)
def packed(emulator, textured):
    """Bundles by label, as the assembler's report has them."""
    report = emulator.text("assemble", PROGRAM, "--isa", "vliw", "--pack", "--listing", "-D", f"textured={int(textured)}")
    return {label: int(bundles) for label, bundles in re.findall(r"^(\S+) +\d+ +\d+ +(\d+) +[\d.]+$", report, re.MULTILINE)}


def lit(found):
    """Polygons lit on the lane with most of them: one a call but the last, which finds no more."""
    return procedure(found, "light")["calls"] - 1


@dataclass(frozen=True)
class StageCosts:
    """Bundles (transform, light) and cycles of one item, as one lane goes through it."""

    transform: float
    light: float
    a_pass: float
    normalise: float
    look: float  # for the next polygon
    sample: float


def rounds(emulator, found, textured):
    """Times that all lanes looked for the next polygon."""
    bundles = packed(emulator, textured)
    some = procedure(found, "rasterise_some")
    once = bundles["rasterise_some"] + bundles["rasterise_save"]
    return (some["bundles"] - some["calls"] * once) // (bundles["rasterise_round"] + bundles["rasterise_rows"])


def stage_costs(emulator, scene, textured):
    """From a frame that is not line-locked: a stage's cycles over the items of the lane that has most of them."""
    scene = textured_scene(scene, textured)
    found, counted = array(emulator, scene), model(emulator, scene)
    most = -(-counted["polygons"] // found["lanes"])
    bundles, some = packed(emulator, textured), procedure(found, "rasterise_some")
    a_round = some["cycles_u"] / rounds(emulator, found, textured)
    return StageCosts(procedure(found, "transform")["cycles_u"] / most,
                      procedure(found, "light")["cycles_u"] / lit(found),
                      procedure(found, "pass_near")["cycles_u"] / passes(found)[1],
                      procedure(found, "normalise_some")["cycles_u"] / max(counted["stages"][-1]["received"]),
                      bundles["rasterise_round"],
                      (a_round - bundles["rasterise_round"]) / SAMPLES[textured])


@dataclass(frozen=True)
class LineFigures:
    """What a scanline of a line-locked frame holds."""

    transformed: float
    lit: float
    passes: float
    normalised: float
    samples: float


def line_figures(emulator, scene, textured):
    """The fullest scanline: items over scanlines, up to the next whole one, since the last scanline of a stage is not full."""
    scene = textured_scene(scene, textured)
    found, counted = array(emulator, scene, line_locked=True), model(emulator, scene)
    most = -(-counted["polygons"] // found["lanes"])

    def a_line(items, name):
        return -(-items // procedure(found, name)["calls"])

    return LineFigures(a_line(most, "transform"), a_line(lit(found), "light"),
                       a_line(passes(found)[1], "pass_near"), a_line(max(counted["stages"][-1]["received"]), "normalise_some"),
                       a_line(rounds(emulator, found, textured), "rasterise_some") * SAMPLES[textured])


@dataclass(frozen=True)
class FrameFigures:
    """A line-locked frame, as table 8.1 has it."""

    degrees: int
    polygons: int
    visible: int
    pictures: int  # of the video output that the frame took
    slices: int  # polygons on the fullest column
    geometry: float  # share of the frame's time
    communicate: float
    rasterise: float  # the rest, waiting for the next picture included, as he counts
    waiting: float  # that wait's share

    def a_second(self, clock=14e6):
        return clock / PICTURE / self.pictures


def frame_figures(emulator, scene, textured, turns=TURNS, **options):
    """One a turn, which are evenly spaced. The frame before them, whose predecessor the video need not show, is left out."""
    scene = textured_scene(scene, textured)
    step = turns[1] - turns[0]
    turning = (("scene.rotate.degrees", str(step)), ("scene.rotate.start", str(turns[0] - step)))
    program = symbols(**options) if options else ()
    found = statistics(emulator, scene + program + turning, "--frames", str(len(turns) + 1))
    return [frame_of(emulator, scene, found, number, degrees) for number, degrees in enumerate(turns, 1)]


def frame_of(emulator, scene, found, number, degrees):
    counted = model(emulator, scene + (("scene.rotate.start", str(degrees)),))
    stages = [part for part in found["phases"] if part["frame"] == number]
    whole = found["frames"][number]["duration_u"]
    share = {name: sum(part["duration_u"] for part in stages if part["name"] == name) / whole for name in ("geometry", "communicate")}
    return FrameFigures(degrees, counted["polygons"], counted["visible"], round(whole / PICTURE), max(counted["stages"][-1]["received"]),
                        share["geometry"], share["communicate"],
                        1 - share["geometry"] - share["communicate"], stages[-1]["duration_u"] / whole)


def passes_a_polygon(emulator, scene, **options):
    """Of one place, a visible polygon."""
    return passes(array(emulator, scene, **options))[1] / model(emulator, scene)["visible"]


def far_pass(emulator, scene, stride):
    found = array(emulator, scene, stride=stride)
    return procedure(found, "pass_far")["cycles_u"] / passes(found, stride)[0]


def strides_on_machine(emulator, scene):
    """Cycles to communicate, by stride."""
    return {d: phase(array(emulator, scene, stride=d), "communicate")["cycles_u"] for d in STRIDES}


def geometry_and_communication(emulator, scene, copies):
    """Cycles a visible polygon."""
    found = array(emulator, scene, duplication=copies)
    return (phase(found, "geometry")["cycles_u"] + phase(found, "communicate")["cycles_u"]) / model(emulator, scene)["visible"]


def share_of(emulator, scene, stage):
    """Of all cycles."""
    found = array(emulator, scene)
    return phase(found, stage)["cycles_u"] / found["cycles_u"]


def dispatching(emulator, scene):
    """Cycles of a scanline before the program's procedure begins."""
    dispatch = procedure(array(emulator, scene, line_locked=True), "dispatch")
    return dispatch["cycles_u"] / dispatch["calls"]


def machine_scenes(arguments):
    """The thesis' three models, or what stands for them: Beethoven (5030 polygons), teapot (9408), crocodile (34 404)."""
    found = {"teapot 9408": SMALL, "teapot 34 440": LARGE}
    for name, file in (("beethoven 5030", "beethoven.ply"), ("head 37 629", "head.obj")):
        path = (ROOT / arguments.models / file).resolve()
        if path.exists():
            found[name] = (("scene.object", str(path)),)
        else:
            print(f"{Path(sys.argv[0]).name}: {path} is not there: left out", file=sys.stderr)
    return found
