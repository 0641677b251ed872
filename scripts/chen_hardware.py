# SPDX-License-Identifier: MIT
"""Chen's figures 9 and 10 on the emulated hardware rasterizer: R against the tile's side, the work of its units, the formula beside it."""

import chen_formula as formula
from chen_machine import RULES, UNLIMITED, UNTILED, bars_by_scene, draw_cycles, inefficiency, save, size_axis, tiler
from chen_scenes import PUBLISHED, TILES, overlap_factor, overlaps, stand_ins, synthetics
from measuring import table

SMALL = 8
QUAKE = {(UNTILED, 1): 1.496, (UNTILED, UNLIMITED): 1.492, (SMALL, 1): 2.57, (SMALL, UNLIMITED): 1.77}  # million cycles, 4.3


def by_formula(emulator, scene, tile, estimated=False):
    """Equation 3 with the scene's mean area and the overlap that was counted or that Molnar and Eyles estimate."""
    found = overlaps(emulator, scene)
    overlap = found["sizes"][tile]["molnar_eyles"] if estimated else overlap_factor(emulator, scene, tile)
    return formula.r_hardware(found["mean_area"], formula.K, overlap)


CURVES = {"FIFO 1": inefficiency, "FIFO unlimited": lambda emulator, scene, tile: inefficiency(emulator, scene, tile, UNLIMITED),
          "formula, overlap as counted": by_formula, "formula, Molnar-Eyles": lambda emulator, scene, tile: by_formula(emulator, scene, tile, True)}


def figures_9_and_10(emulator, scenes):
    rows = []
    for name, scene in scenes.items():
        for title, curve in CURVES.items():
            published = PUBLISHED[name].hardware if name in PUBLISHED and title == "FIFO 1" else None
            rows.append([name, title, *(f"{curve(emulator, scene, S):.3f}" for S in TILES), published or "-"])
    table(["scene", f"R, hardware, k = {formula.K}", *(f"{S} x {S}" for S in TILES), "published, 8 x 8"], rows)


def quake(emulator, scene):
    rows = []
    for (tile, fifo), published in QUAKE.items():
        found = draw_cycles(emulator, scene, tile, fifo) / 1e6
        rows.append(["untiled" if tile == UNTILED else f"{tile} x {tile}", fifo, f"{found:.3f}", published, f"{100 * (found / published - 1):+.1f} %"])
    table(["Quake", "FIFO", "million cycles", "published", "difference"], rows)


def units(emulator, scenes):
    rows = []
    for name, scene in scenes.items():
        for tile in (*TILES, UNTILED):
            part, = tiler(emulator, scene, tile)["rasterizers"]
            triangle, pixel = part["triangle_unit"], part["pixel_unit"]
            spent = (draw_cycles(emulator, scene, tile), triangle["busy_u"], triangle["blocked_u"], pixel["busy_u"], pixel["starved_u"])
            rows.append([name, "untiled" if tile == UNTILED else tile, *(f"{cycles / 1000:.1f}" for cycles in spent),
                         f"{100 * part['pairs_without_pixels'] / part['pairs']:.0f} %"])
    table(["scene, FIFO 1; thousand cycles", "tile", "frame", "triangle unit busy", "blocked: FIFO full", "pixel unit busy", "starved: FIFO empty",
           "pairs without a pixel"], rows)


def rules(emulator, scenes):
    rows = [[name, title, *(f"{inefficiency(emulator, scene, S, rule=rule):.3f}" for S in TILES)] for name, scene in scenes.items()
            for title, rule in RULES.items()]
    table(["scene, FIFO 1", "R by tiles of the", *(f"{S} x {S}" for S in TILES)], rows)


def draw_figure_9(emulator, scenes, axes):
    for i, (name, scene) in enumerate(scenes.items()):
        axes.plot(TILES, [inefficiency(emulator, scene, S) for S in TILES], "o-", color=f"C{i}", label=name)
        axes.plot(TILES, [inefficiency(emulator, scene, S, UNLIMITED) for S in TILES], ":", color=f"C{i}")
        if name in PUBLISHED and PUBLISHED[name].hardware:
            axes.plot([SMALL], [PUBLISHED[name].hardware], "k*", markersize=9)
    axes.plot([], [], "k:", label="FIFO unlimited")
    size_axis(axes, TILES)


def draw_figure_10(emulator, scenes, axes):
    bars = {title: [curve(emulator, scene, SMALL) for scene in scenes.values()] for title, curve in CURVES.items()}
    bars_by_scene(axes, list(scenes), bars | {"published": [PUBLISHED[name].hardware if name in PUBLISHED else None for name in scenes]})


def hardware(emulator, arguments):
    scenes = synthetics() | stand_ins(arguments.models)
    figures_9_and_10(emulator, scenes)
    quake(emulator, scenes["Quake"])
    units(emulator, scenes)
    rules(emulator, scenes)
    save(arguments, "figure9", lambda axes: draw_figure_9(emulator, scenes, axes), "Chen 1998, figure 9: hardware, one triangle of buffering",
         "side of a tile, pixels", "R")
    save(arguments, "figure10", lambda axes: draw_figure_10(emulator, scenes, axes), "Chen 1998, figure 10: hardware and formula, tiles of 8 x 8", "", "R")
