# SPDX-License-Identifier: MIT
"""Chen's figures 7 and 8 on an emulated processor: what triangles, scanlines and pixels cost, k, and R against the tile's side, the formula beside it."""

from dataclasses import dataclass

import chen_formula as formula
from chen_machine import RULES, UNTILED, bars_by_scene, counted, save
from chen_scenes import PUBLISHED, TILES, overlap_factor, overlaps, synthetics
from measuring import table

SMALL = 8
KINDS = {"plain": False, "textured": True}
PUBLISHED_K = {"plain": formula.K_PLAIN, "textured": formula.K_TEXTURED}


@dataclass(frozen=True)
class Work:
    """Cycles of a frame."""

    triangles: int
    scanlines: int
    pixels: int

    def of_model(self):
        return self.triangles + self.pixels

    def all(self):
        return self.triangles + self.scanlines + self.pixels


def kind_of(name):
    """As the paper draws the scene."""
    return "textured" if PUBLISHED[name].textured else "plain"


def work(emulator, scene, tile, kind, rule="bounding_box"):
    spent = counted(emulator, scene, tile, KINDS[kind], rule)["cycles_u"]
    return Work(spent["polygon"] + spent["vertex"], spent["segment"], spent["pixel"])


def costs(emulator, scene, tile, kind):
    """Cycles a (triangle, tile) pair, a scanline of it and a pixel."""
    done, spent = counted(emulator, scene, tile, KINDS[kind]), work(emulator, scene, tile, kind)
    return spent.triangles / done["polygons"], spent.scanlines / done["segments"], spent.pixels / done["pixels"]


def k_of(emulator, scene, kind, tile=UNTILED):
    triangle, _, pixel = costs(emulator, scene, tile, kind)
    return triangle / pixel


def inefficiency(emulator, scene, kind, tile=SMALL, part=Work.all, rule="bounding_box"):
    return part(work(emulator, scene, tile, kind, rule)) / part(work(emulator, scene, UNTILED, kind))


def without_scanlines(emulator, scene, kind):
    return inefficiency(emulator, scene, kind, part=Work.of_model)


def by_formula(emulator, scene, kind, estimated=False, k=None):
    """Equation 2 for tiles of 8 x 8, with k as it was measured without tiles unless it is given."""
    found = overlaps(emulator, scene)
    overlap = found["sizes"][SMALL]["molnar_eyles"] if estimated else overlap_factor(emulator, scene, SMALL)
    return formula.r_software(found["mean_area"], k or k_of(emulator, scene, kind), overlap)


CURVES = {"emulated": inefficiency, "without scanlines": without_scanlines, "formula, measured k, overlap as counted": by_formula,
          "formula, measured k, Molnar-Eyles": lambda emulator, scene, kind: by_formula(emulator, scene, kind, True),
          "formula, published k, overlap as counted": lambda emulator, scene, kind: by_formula(emulator, scene, kind, k=PUBLISHED_K[kind])}


def measured_costs(emulator, scenes):
    rows = []
    for name, scene in scenes.items():
        for kind in KINDS:
            cells = [f"{cost:.1f}" for tile in (UNTILED, SMALL) for cost in costs(emulator, scene, tile, kind)]
            rows.append([name, kind, *cells, f"{k_of(emulator, scene, kind):.1f}", f"{k_of(emulator, scene, kind, SMALL):.1f}", PUBLISHED_K[kind]])
    table(["scene", "cycles", "a triangle, untiled", "a scanline", "a pixel", "a triangle in a tile, 8 x 8", "a scanline", "a pixel", "k, untiled", "k, 8 x 8",
           "published k"], rows)


def figure_7(emulator, scenes):
    rows = []
    for name, scene in scenes.items():
        for kind in KINDS:
            whole = work(emulator, scene, UNTILED, kind).all()
            parts = [work(emulator, scene, tile, kind) for tile in (*TILES, UNTILED)]
            rows.append([name, kind, *(f"{part.triangles / whole:.3f} + {part.scanlines / whole:.3f} + {part.pixels / whole:.3f} = {part.all() / whole:.3f}"
                                       for part in parts)])
    table(["scene", "R, software: triangles + scanlines + pixels", *(f"{S} x {S}" for S in TILES), "untiled"], rows)


def figure_8(emulator, scenes):
    rows = [[name, kind, *(f"{curve(emulator, scene, kind):.3f}" for curve in CURVES.values()),
             kind == kind_of(name) and PUBLISHED[name].software or "-"] for name, scene in scenes.items() for kind in KINDS]
    table(["scene", "R, software, 8 x 8", *CURVES, "published"], rows)


def rules(emulator, scenes):
    rows = [[name, kind, *(f"{inefficiency(emulator, scene, kind, rule=rule):.3f}" for rule in RULES.values())] for name, scene in scenes.items()
            for kind in KINDS]
    table(["scene", "R, software, 8 x 8, by tiles of the", *RULES], rows)


def draw_figure_7(emulator, scenes, axes):
    sizes = (*TILES, UNTILED)
    places, parts = [], []
    for i, (name, scene) in enumerate(scenes.items()):
        whole = work(emulator, scene, UNTILED, kind_of(name)).all()
        for j, tile in enumerate(sizes):
            spent = work(emulator, scene, tile, kind_of(name))
            places.append(i * (len(sizes) + 1) + j)
            parts.append((spent.pixels / whole, spent.scanlines / whole, spent.triangles / whole))
    below = [0.0] * len(places)
    for title, heights in zip(("pixels", "scanlines", "triangles"), zip(*parts)):
        axes.bar(places, heights, bottom=below, label=title)
        below = [low + height for low, height in zip(below, heights)]
    axes.set_xticks([i * (len(sizes) + 1) + (len(sizes) - 1) / 2 for i in range(len(scenes))], scenes)


def draw_figure_8(emulator, scenes, axes):
    bars = {title: [curve(emulator, scene, kind_of(name)) for name, scene in scenes.items()] for title, curve in CURVES.items()}
    bars_by_scene(axes, list(scenes), bars | {"published": [PUBLISHED[name].software for name in scenes]})


def software(emulator, arguments):
    scenes = synthetics()
    measured_costs(emulator, scenes)
    figure_7(emulator, scenes)
    figure_8(emulator, scenes)
    rules(emulator, scenes)
    save(arguments, "figure7", lambda axes: draw_figure_7(emulator, scenes, axes), "Chen 1998, figure 7: software; Quake and Flight textured",
         "tiles of " + ", ".join(map(str, TILES)) + ", untiled", "R")
    save(arguments, "figure8", lambda axes: draw_figure_8(emulator, scenes, axes), "Chen 1998, figure 8: software and formula, tiles of 8 x 8", "", "R")
