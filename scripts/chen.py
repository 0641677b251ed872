#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Prints and draws the formulas of Chen's paper on tiles, and how many tiles triangles overlap.

    scripts/chen.py analytic | overlap | all
        [--rasterloom build/release/rasterloom] [--models ../shared/models] [--plots DIR]

`analytic` prints what the formulas give for figures 2, 4 and 5 and the numbers of the text; `overlap` counts overlap factors as figure 6 has them,
on synthetic scenes with the paper's statistics and on meshes, beside the formula of Molnar and Eyles. The paper's graphs cannot be read: published
numbers are those that its text names.
"""

import chen_formula as formula
from chen_scenes import PUBLISHED, TILES, meshes, overlap_factor, overlaps, synthetic
from measuring import plot_figure, print_tables, table

AREAS = (1, 5, 10, 25, 33, 47, 100, 250, 1000, 4000, 16000)
SIDE = 32  # of the tiles of figures 2, 4 and 5
CURVE = [10 ** (i / 50) for i in range(-50, 251)]


def save(arguments, name, draw, title, x_label, y_label):
    if arguments.plots:
        plot_figure(arguments.plots / f"chen-{name}.png", draw, title, x_label, y_label)


def short(value):
    return f"{value:.4g}" if value < 10_000 else f"{value:.0f}"


def by_area(title, curves, y_label, arguments, name):
    """`curves`: name to function of the area."""
    print(f"### {title}\n")
    table(["area, pixels", *AREAS], [[text, *(short(curve(a)) for a in AREAS)] for text, curve in curves.items()])

    def draw(axes):
        for text, curve in curves.items():
            axes.semilogx(CURVE, [curve(a) for a in CURVE], label=text)
        if len(curves) > 1:
            axes.set_yscale("log")

    save(arguments, name, draw, f"Chen 1998, {title}", "area of a triangle, pixels", y_label)


def numbers():
    k, plain, textured = formula.K, formula.K_PLAIN, formula.K_TEXTURED
    rows = [[S, f"{formula.overlap(k, S):.3f}", f"{formula.worst_area(k, S):.1f}", f"{formula.worst_area(plain, S):.1f}",
             f"{formula.worst_area(textured, S):.1f}", f"{formula.software_limit(k, S):.3f}", f"{formula.balance_printed(k, S):.1f}",
             f"{formula.balance(k, S):.1f}", f"{formula.hardware_limit(k, S):.3f}"] for S in TILES]
    print("### Worst areas, balance and limits\n")
    table(["tile", f"worst R, hardware (a = k = {k})", f"worst area, software, k = {k}", f"k = {plain}", f"k = {textured}", f"limit of R, software, k = {k}",
           "k', as printed", "k', solved", "limit of R, hardware"], rows)
    print("Published, 8 x 8: k' 3670; worst area 70 \"for non-textured scenes\", whose k is 9.3.\n")


def analytic(_emulator, arguments):
    k = formula.K

    def tiles(a):
        return formula.overlap(a, SIDE)

    by_area(f"Figure 2: work of a triangle in pixels, k = {k}, S = {SIDE}", {"pixels": lambda a: a, "triangle, untiled": lambda a: k,
            "triangle, tiled": lambda a: k * tiles(a)}, "pixels", arguments, "2")
    by_area(f"Figure 4: R, software, k = {k}, S = {SIDE}", {"R": lambda a: formula.r_software(a, k, tiles(a))}, "R", arguments, "4")
    by_area(f"Figure 5: R, hardware, k = {k}, S = {SIDE}", {"R": lambda a: formula.r_hardware(a, k, tiles(a))}, "R", arguments, "5")
    numbers()


def statistics(emulator, scenes):
    rows = []
    for name, scene in scenes.items():
        found, published = overlaps(emulator, scene), PUBLISHED.get(name)
        rows.append([name, found["visible"], f"{found['mean_area']:.1f}", published.area if published else "-", f"{found['depth_complexity']:.2f}",
                     published.complexity if published else "-", f"{found['box_ratio']:.2f}"])
    table(["scene", "visible triangles", "pixels a triangle", "published", "depth complexity", "published", "box over triangle"], rows)


def factors(emulator, scenes):
    rows = []
    for name, scene in scenes.items():
        found = overlaps(emulator, scene)
        for text, value in (("bounding box", lambda S: overlap_factor(emulator, scene, S)), ("exact", lambda S: overlap_factor(emulator, scene, S, "exact")),
                            ("covered", lambda S: overlap_factor(emulator, scene, S, "covered")),
                            ("Molnar-Eyles", lambda S: found["sizes"][S]["molnar_eyles"])):
            published = PUBLISHED[name].overlap if name in PUBLISHED and text == "bounding box" else None
            rows.append([name, text, *(f"{value(S):.2f}" for S in TILES), published or "-"])
    table(["scene", "overlap", *(f"{S} x {S}" for S in TILES), "published, 8 x 8"], rows)


def overlap(emulator, arguments):
    for title, kind, scenes in (("Synthetic scenes with the paper's statistics", "synthetic", {name: synthetic(name) for name in PUBLISHED}),
                                ("Meshes", "meshes", meshes(arguments.models))):
        print(f"### {title}\n")
        statistics(emulator, scenes)
        factors(emulator, scenes)

        def draw(axes):
            for i, (name, scene) in enumerate(scenes.items()):
                axes.loglog(TILES, [overlap_factor(emulator, scene, S) for S in TILES], "o-", color=f"C{i}", label=name)
                axes.loglog(TILES, [overlap_factor(emulator, scene, S, "exact") for S in TILES], ":", color=f"C{i}")
                if name in PUBLISHED and PUBLISHED[name].overlap:
                    axes.plot([8], [PUBLISHED[name].overlap], "k*", markersize=9)
            axes.plot([], [], "k:", label="exact")

        save(arguments, f"6-{kind}", draw, f"Chen 1998, figure 6: tiles a triangle, {kind}", "side of a tile, pixels", "overlap factor")


if __name__ == "__main__":
    print_tables(__doc__, {"analytic": analytic, "overlap": overlap})
