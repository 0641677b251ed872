# SPDX-License-Identifier: MIT
"""M. Chen, G. Stoll, H. Igehy, K. Proudfoot, P. Hanrahan, models of the impact of overlap in bucket rendering, 1998."""

import chen_formula as formula
import chen_hardware as hardware
import chen_software as software
from chen_hardware import SMALL
from chen_machine import UNLIMITED, UNTILED, draw_cycles
from chen_scenes import PUBLISHED, overlap_factor, overlaps, synthetic
from claims import EXACT, Claim, Tolerance

TITLE = "Chen 1998: overlap in bucket rendering"
NOTES = [
    "Formulas, overlap factors by `rasterloom overlap` (docs/overlap.md), and emulated bucket tilers. The scenes are lost; ours are triangles at random with the "
    "count and the mean area of figure 6, whose shapes were chosen so that their bounding boxes overlap as many tiles of 8 x 8 as the paper says, with the "
    "skew of Quake's areas for its 1.496 million cycles and the skew and the aspect of Studio and Cylhead for their hardware R: that those come out is no "
    "evidence, that depth complexities, formulas and everything else agree is. The graphs cannot be read: only points that the text names."]

ONE, FIVE, TEN = Tolerance(percent=1), Tolerance(percent=5), Tolerance(percent=10)
ARITHMETIC = "Arithmetic, and right."
CHOSEN = "The shape of the triangles was chosen for it."
OF_OVERLAP = "Follows from the overlap, for which the shape of the triangles was chosen."
OTHER_PROCESSOR = "k of the PDP-11 program is several times as large as Argus': it sets edges and planes up with many 16-bit multiplications and divisions."
LINES = "The work on scanlines decides: without it, it is the scene that the paper says."
LARGE = 128


def arithmetic(where, what, published, value, by, unit="", tolerance=ONE, because=ARITHMETIC):
    """A number that the paper works out; `value` is what its formula gives."""
    return Claim(where, what, published, None, unit, tolerance, because, value, by)


def depth_complexity(name):
    return lambda emulator: overlaps(emulator, synthetic(name))["depth_complexity"]


def hardware_r(name, tile=SMALL):
    return lambda emulator: hardware.inefficiency(emulator, synthetic(name), tile)


def software_r(name, tile=SMALL):
    return lambda emulator: software.inefficiency(emulator, synthetic(name), software.kind_of(name), tile)


def without_scanlines(name):
    return lambda emulator: software.without_scanlines(emulator, synthetic(name), software.kind_of(name))


def by_equation_2(kind):
    return lambda name: lambda emulator: software.by_formula(emulator, synthetic(name), kind, k=software.PUBLISHED_K[kind])


def end(which, r):
    """The scene with the least or the greatest R at 8 x 8."""
    return lambda emulator: which(PUBLISHED, key=lambda name: r(name)(emulator))


def worst(r):
    return lambda emulator: max(r(name, LARGE)(emulator) for name in PUBLISHED)


def below_formula(emulator):
    """Of the scenes that 4.3 names."""
    return ", ".join(name for name in ("Quake", "Flight", "Studio", "Cylhead")
                     if hardware.inefficiency(emulator, synthetic(name), SMALL) < hardware.by_formula(emulator, synthetic(name), SMALL))


def peak_at_flight(estimated):
    def found(emulator):
        quake, flight, studio = (hardware.by_formula(emulator, synthetic(name), SMALL, estimated) for name in ("Quake", "Flight", "Studio"))
        return "peak" if flight > max(quake, studio) else "none"

    return found


def quake(tile, fifo, note="", **implied):
    return Claim("4.3", f"Quake, {'untiled' if tile == UNTILED else f'{tile} x {tile}'}, {'unlimited' if fifo == UNLIMITED else 'one triangle of'} buffer",
                 hardware.QUAKE[tile, fifo], lambda emulator: draw_cycles(emulator, synthetic("Quake"), tile, fifo) / 1e6, "million cycles", TEN, note=note, **implied)


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
]

HARDWARE = [
    quake(UNTILED, 1, CHOSEN),
    quake(UNTILED, UNLIMITED, "The number of its pixels.", implied=PUBLISHED["Quake"].visible * PUBLISHED["Quake"].area / 1e6,
          implied_by="equation 3 with figure 6", slack=ONE),
    quake(SMALL, 1, "Nothing but the overlap was chosen for it."),
    quake(SMALL, UNLIMITED, OF_OVERLAP, implied=PUBLISHED["Quake"].visible * formula.K * PUBLISHED["Quake"].overlap / 1e6,
          implied_by="equation 3 with an overlap of 132", slack=ONE),
    *(Claim("4.3", f"{name}, R of hardware, 8 x 8", row.hardware, hardware_r(name), "", TEN, note=CHOSEN) for name, row in PUBLISHED.items() if row.hardware),
    Claim("4.3", "scene with the best R of hardware, 8 x 8", "Studio", end(min, hardware_r), note="Studio's R was chosen, those of Quake, Flight and Head were not."),
    Claim("4.3", "scene with the worst R of hardware, 8 x 8", "Cylhead", end(max, hardware_r), note="Cylhead's R was chosen, those of Quake, Flight and Head were not."),
    Claim("4.3", "greatest R of hardware of all scenes, 128 x 128 (\"close to 100%\")", 1, worst(hardware_r), "", TEN),
    Claim("4.3", "scenes whose R of hardware is less than by equation 3, 8 x 8", "Cylhead", below_formula),
    Claim("figure 10", "equation 3 at Flight, overlap as counted", "peak", peak_at_flight(False), note="Flight has Quake's shapes; nothing was chosen for it."),
    Claim("figure 10", "equation 3 at Flight, overlap by Molnar and Eyles", "none", peak_at_flight(True)),
]

SOFTWARE = [
    Claim("4.2", "k, not textured", formula.K_PLAIN, lambda e: software.k_of(e, synthetic("Cylhead"), "plain"), "", TEN, OTHER_PROCESSOR, note="Of Cylhead, untiled."),
    Claim("4.2", "k, textured", formula.K_TEXTURED, lambda e: software.k_of(e, synthetic("Quake"), "textured"), "", TEN, OTHER_PROCESSOR, note="Of Quake, untiled."),
    *(Claim("4.2", f"{name}, R of software, 8 x 8", row.software, software_r(name), "", TEN, OTHER_PROCESSOR,
            note="Textured." if row.textured else "Not textured.") for name, row in PUBLISHED.items() if row.software),
    Claim("4.2", "scene with the best R of software, 8 x 8", "Quake", end(min, software_r), because=LINES),
    Claim("4.2", "scene with the worst R of software, 8 x 8", "Cylhead", end(max, software_r), because=LINES),
    Claim("figure 8", "the same without the work on scanlines", "Cylhead", end(max, without_scanlines)),
    *(Claim("figure 8", f"scene with the greatest R by equation 2, 8 x 8, overlap as counted, k = {k:g}", "Cylhead", end(max, by_equation_2(kind)))
      for kind, k in software.PUBLISHED_K.items()),
    Claim("4.2", "greatest R of software of all scenes, 128 x 128 (\"close to 100%\")", 1, worst(software_r), "", TEN),
]

CLAIMS = [*SCENES, *FORMULAS, *HARDWARE, *SOFTWARE]
