# SPDX-License-Identifier: MIT
"""M. Chen, G. Stoll, H. Igehy, K. Proudfoot, P. Hanrahan, models of the impact of overlap in bucket rendering, 1998."""

import chen_formula as formula
from chen_scenes import PUBLISHED, overlap_factor, overlaps, synthetic
from claims import EXACT, Claim, Tolerance

TITLE = "Chen 1998: overlap in bucket rendering"
NOTES = [
    "Formulas, and overlap factors by `rasterloom overlap` (docs/overlap.md). The scenes are lost; ours are triangles at random with the count and the "
    "mean area of figure 6, whose bounding boxes were chosen so that they overlap as many tiles of 8 x 8 as the paper says: that they do is no "
    "evidence, that depth complexities and formulas agree is. The graphs cannot be read: only points that the text names."]

ONE, FIVE = Tolerance(percent=1), Tolerance(percent=5)
ARITHMETIC = "Arithmetic, and right."
CHOSEN = "The shape of the triangles was chosen for it."
SMALL = 8


def arithmetic(where, what, published, value, by, unit="", tolerance=ONE, because=ARITHMETIC):
    """A number that the paper works out; `value` is what its formula gives."""
    return Claim(where, what, published, None, unit, tolerance, because, value, by)


def depth_complexity(name):
    return lambda emulator: overlaps(emulator, synthetic(name))["depth_complexity"]


def tiled_cycles(emulator):
    """Equation 3 for all of Quake, with the overlap that was counted, millions."""
    found = overlaps(emulator, synthetic("Quake"))
    return found["visible"] * max(formula.K * overlap_factor(emulator, synthetic("Quake"), SMALL), found["mean_area"]) / 1e6


def untiled_cycles(emulator):
    found = overlaps(emulator, synthetic("Quake"))
    return found["visible"] * max(formula.K, found["mean_area"]) / 1e6


SCENES = [
    Claim("4.1", "tiles of 8 x 8 on 1024 x 768 pixels", 12288, lambda e: overlaps(e, synthetic("Head"))["sizes"][SMALL]["tiles"]),
    *(Claim("figure 6", f"{name}, depth complexity", row.complexity, depth_complexity(name), "", Tolerance(margin=0.01), "",
            row.visible * row.area / formula.PIXELS, "count times mean area over 1024 x 768") for name, row in PUBLISHED.items()),
    *(Claim("4.1, 4.2", f"{name}, overlap of bounding boxes, 8 x 8", row.overlap, lambda e, name=name: overlap_factor(e, synthetic(name), SMALL), "", FIVE,
            note=CHOSEN) for name, row in PUBLISHED.items() if row.overlap),
]

FORMULAS = [
    arithmetic("figure 8", "a_worst of non-textured scenes, 8 x 8", 70, formula.worst_area(formula.K_PLAIN, SMALL),
               "the appendix's formula with their k of 9.3 (25, the hardware's, gives 70.4)", "pixels", because=""),
    arithmetic("figure 10", "a_worst, hardware, 8 x 8", 25, formula.K, "k", "pixels", EXACT),
    arithmetic("figure 10", "k', k = 25, 8 x 8, by its formula", 3670, formula.balance_printed(formula.K, SMALL), "the appendix's formula", "pixels"),
    arithmetic("figure 10", "k O at a = k', which has to be k'", 3670, formula.K * formula.overlap(3670, SMALL),
               "equation 1. k O = a has no solution for S up to sqrt(k rho) = 8.66; the formula squares a root below 0", "pixels", because=""),
    arithmetic("equation 3", "limit of R for large triangles, hardware, k = 25, 8 x 8", 1, formula.hardware_limit(formula.K, SMALL),
               "k rho / S^2, for want of a k'", because=""),
    arithmetic("4.3", "average effective area of Quake's triangles, 8 x 8", 21, PUBLISHED["Quake"].area / PUBLISHED["Quake"].overlap, "2784.4 over 132",
               "pixels", Tolerance(margin=0.5)),
    Claim("4.3", "Quake untiled, unlimited buffer", 1.492, untiled_cycles, "million cycles", ONE, "",
          PUBLISHED["Quake"].visible * PUBLISHED["Quake"].area / 1e6, "equation 3 with figure 6"),
    Claim("4.3", "Quake, 8 x 8, unlimited buffer", 1.77, tiled_cycles, "million cycles", FIVE, "",
          PUBLISHED["Quake"].visible * formula.K * PUBLISHED["Quake"].overlap / 1e6, "equation 3 with an overlap of 132", note=CHOSEN),
]

CLAIMS = [*SCENES, *FORMULAS]
