# SPDX-License-Identifier: MIT
"""Scenes for Chen's tiles and the tiles that they overlap (`rasterloom triangles`, `rasterloom overlap`; docs/overlap.md): chen.py prints them,
papers/chen1998.py compares them."""

import json
import sys
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from measuring import ROOT, scratch_folder

TILES = (8, 16, 32, 64, 128)


@dataclass(frozen=True)
class Published:
    """A row of figure 6; where the text has them, the overlap by bounding box and R of hardware and software, all at 8 x 8."""

    visible: int
    area: float
    complexity: float
    textured: bool = False
    overlap: float | None = None
    hardware: float | None = None
    software: float | None = None


PUBLISHED = {"Quake": Published(536, 2784.4, 1.90, True, overlap=132, software=1.37), "Flight": Published(643, 1544.3, 1.26, True),
             "Studio": Published(1676, 807.8, 1.72, overlap=37, hardware=1.62),
             "Cylhead": Published(4836, 38.3, 0.24, overlap=7.2, hardware=3.63, software=2.38), "Head": Published(29045, 8.4, 0.31, overlap=2.4)}


def synthetic(name):
    """Of any machine: only its screen and its scene count."""
    return ("--machine", "configs/bucket-hardware.yaml", "--set", f"scene=scenes/chen-{name.lower()}.yaml")


def synthetics():
    return {name: synthetic(name) for name in PUBLISHED}


def arena(*view):
    return ("arena.obj", "--up", "z", "--front", "y", *view)


MESHES = {"head": ("head.obj",), "arena, inside": arena("--eye", "0,0,0.1", "--target", "1,0,0", "--field-of-view", "90"),
          "arena, from one end": arena("--eye", "-0.6,0,0", "--field-of-view", "90"), "beethoven": ("beethoven.ply",), "bunny": ("bunny.obj",),
          "alligator": ("alligator.obj",)}

STAND_INS = {"arena, inside": "game level", "head": "scanned head"}


def meshes(folder):
    """The teapot and those whose files are there."""
    return {"teapot": ("--object", "teapot"), **of_files(folder, MESHES)}


def stand_ins(folder):
    """For Quake and Head, as far as their files are there."""
    found = of_files(folder, STAND_INS)
    return {STAND_INS[name]: scene for name, scene in found.items()}


def of_files(folder, names):
    found = {}
    for name in names:
        file, *view = MESHES[name]
        path = (ROOT / folder / file).resolve()
        if path.exists():
            found[name] = ("--mesh", str(path), *view)
        else:
            print(f"{Path(sys.argv[0]).name}: {path} is not there: left out", file=sys.stderr)
    return found


@lru_cache(maxsize=None)
def triangles_file(emulator, scene):
    """What `triangles` writes with the arguments `scene`."""
    path = scratch_folder() / f"{triangles_file.cache_info().currsize}.triangles"
    emulator.text("triangles", *scene, "--out", str(path))
    return path


@lru_cache(maxsize=None)
def overlaps(emulator, scene):
    """What `overlap --json` says of a scene (arguments of `triangles`), sizes by the tile's side."""
    found = json.loads(emulator.text("overlap", str(triangles_file(emulator, scene)), "--json", "--tile", ",".join(map(str, TILES))))
    found["sizes"] = {size["width"]: size for size in found["sizes"]}
    return found


def overlap_factor(emulator, scene, tile, rule="bounding_box"):
    found = overlaps(emulator, scene)
    return found["sizes"][tile]["pairs"][rule] / found["visible"]
