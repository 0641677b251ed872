# SPDX-License-Identifier: MIT
"""What Chen's formulas give for figures 2, 4 and 5 and the numbers of the text."""

import chen_formula as formula
from chen_machine import save
from chen_scenes import TILES
from measuring import table

AREAS = (1, 5, 10, 25, 33, 47, 100, 250, 1000, 4000, 16000)
SIDE = 32  # of the tiles of figures 2, 4 and 5
CURVE = [10 ** (i / 50) for i in range(-50, 251)]


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
