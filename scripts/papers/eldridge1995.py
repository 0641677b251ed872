# SPDX-License-Identifier: MIT
"""M. Eldridge, polygon rendering on the Princeton Engine, M.Sc. thesis, 1995: a ring of 1024 lock-step processors; chapters 4 to 8 and A."""

import eldridge_formula as formula
from claims import EXACT, Claim, Tolerance
from eldridge_ring import (RING_SIZES, TEAPOT, all_instructions, best_pair, busiest_with_locality, composite_of, counts, distribution,
                           duplication, locality_penalty, overtaken_at, random_scene, received, shifts, sort_twice, sorting_instructions,
                           sparse_over_dense, stride_speedup)
from princeton_machine import (BEST_STRIDE, LARGE, SMALL, array, dispatching, far_pass, frame_figures, geometry_and_communication, line_figures,
                               passes_a_polygon, share_of, stage_costs, strides_on_machine)

TITLE = "Eldridge 1995: the Princeton Engine, sorting on a ring"
NOTES = [
    "Chapters 4 to 6 by `rasterloom communicate` (docs/ring-model.md), which counts what the thesis' simulator counts: passes on the ring, and "
    "instructions from them by its costs. The scenes are lost; ours are a teapot of 9312 polygons (his has 9408) seen so that a polygon is on 5.7 "
    "columns as his is, and random polygons of 196 pixels' boxes, whose size he does not say. What the thesis puts in (1024 processors, 768 x 512 "
    "pixels, instructions a polygon and a pixel) is not listed, nor are its graphs, which cannot be read: only points that its text names.",
    "Chapters 7 and 8, and 5 where it says \"on the machine\", by `rasterloom run configs/princeton1024-sort-middle.yaml`: 1024 lanes at 14 MHz execute "
    "programs/vliw/sort_middle.s. The teapot has 9408 triangles as his has; for his crocodile of 34 404, which is lost, stands a teapot of 34 440. "
    "Beethoven is no part of the project (`scripts/princeton.py table` runs it where it is). Costs are cycles of one item as a lane goes through it, "
    "not line-locked; figures of a scanline and of table 8.1 are line-locked."]

FIVE, ONE, TENTH = Tolerance(percent=5), Tolerance(percent=1), Tolerance(percent=0.1)
ARITHMETIC = "Arithmetic, and right."
PRINTED_DENSE = 29  # table 4.2, where 24 follows
LARGE_RING, LARGE_GROUP = 65536, 1024
OTHER_SCENE = "Another tessellation and view."


def arithmetic(where, what, published, value, by, unit="", tolerance=TENTH, because=ARITHMETIC):
    """A number that the thesis works out by hand; `value` is what its equation gives."""
    return Claim(where, what, published, None, unit, tolerance, because, value, by)


def a_pass(emulator):
    stage = counts(emulator, TEAPOT)["stages"][0]
    return stage["instructions"] / stage["passes"]


def dense_pixel(emulator):
    """Instructions a pixel and processor that dense sort-last communicates."""
    return composite_of(emulator, 1) / (formula.Q * (1 - 1 / formula.N))


CHAPTER_4 = [
    Claim("table 4.2", "C, sort-middle", 156, a_pass, "instructions", EXACT, "", formula.C["sort-middle"], "3 x 42 + 30"),
    Claim("table 4.2", "C, dense sort-last", PRINTED_DENSE, dense_pixel, "instructions", ONE, "", formula.C["dense sort-last"], "3 x 3 + 15"),
    arithmetic("table 4.2", "C, sort-first", 102, formula.C["sort-first"], "3 x 24 + 30", "instructions", EXACT),
    arithmetic("table 4.2", "C, sparse sort-last", 45, formula.C["sparse sort-last"], "3 x 5 + 30", "instructions", EXACT),
    arithmetic("4.4.1", "f o above which sort-middle is faster than sort-first", 32.9, formula.overlap_for_sort_middle(), "equation 4.10", "",
               Tolerance(margin=0.05)),
    arithmetic("4.4.1", "f o of the teapot", 16.7, formula.F * formula.O, "4.4 x 3.8", "", Tolerance(margin=0.05)),
    Claim("table 4.3", "f of the teapot: fullest over mean", 4.4, lambda e: received(e, TEAPOT)[0] / received(e, TEAPOT)[1], "", FIVE, OTHER_SCENE,
          394 / 23.3, "figure 4-1, 394 over 23.3"),
    Claim("figure 4-1", "polygons on the fullest processor, teapot", 394, lambda e: received(e, TEAPOT)[0], "", FIVE, OTHER_SCENE),
    Claim("figure 4-1", "polygons a processor on the mean, teapot", 23.3, lambda e: received(e, TEAPOT)[1], "", Tolerance(percent=10), OTHER_SCENE,
          note="The view was chosen for it."),
    arithmetic("4.4.2", "polygons from which dense sort-last is faster than sparse", 2534, formula.dense_from(),
               "equation 4.11 with the 24 of its formula (the printed 29 gives 2534)", because=""),
    arithmetic("4.4.3", "polygons from which dense sort-last is faster than sort-middle", 60123, formula.sort_last_from(PRINTED_DENSE),
               "equation 4.12 with the printed 29, which 2534 and 11.4 million take (24 gives 59,903)", because=""),
    Claim("4.4.3", "dense sort-last composite", 11.4, lambda e: composite_of(e, 1) / 1e6, "million instructions", ONE, "",
          formula.Q * formula.C["dense sort-last"] / 1e6, "24 a pixel (the printed 29 gives 11.4)"),
    *(Claim("figure 4-2", f"shifts a visible polygon, teapot, {n} processors", 1, lambda e, n=n: shifts(e, TEAPOT, n), "", Tolerance(percent=20),
            note="About 1; evenly spread destinations take half of that." if n == RING_SIZES[0] else "")
      for n in RING_SIZES),
    arithmetic("5, equation 5.1", "share of communication in all", 75, 100 * formula.communication_share(), "equation 5.1 with tables 4.2 and 4.3",
               "%", FIVE, ""),
]

CHAPTER_5 = [
    Claim("figure 5-3", "sparse over dense: up to, teapot and 2000 to 40 000 random polygons", 2,
          lambda e: max(sparse_over_dense(e, scene) for scene in (TEAPOT, *map(random_scene, (2000, 5000, 10_000, 20_000, 40_000)))), "times",
          Tolerance(percent=10)),
    arithmetic("5.3, equation 5.2", "greatest speed-up of a long pass", 3.7, formula.greatest_speedup(), "3 + 30/42", "times",
               Tolerance(margin=0.05)),
    arithmetic("5.3, equation 5.6", "best stride by formula", 27.36, formula.best_stride(), "equation 5.6", "", TENTH),
    arithmetic("5.3", "speed-up by formula", 3.10, formula.one_stride() / formula.best_two_strides(), "half a shift a polygon, and equation 5.7",
               "times", Tolerance(margin=0.005)),
    Claim("figure 5-5", "best stride, simulated: 8 or 16", (8, 16), lambda e: formula.least(distribution(e, TEAPOT))),
    Claim("figure 5-5", "speed-up at the best stride, simulated, three scenes", (1.96, 2.40), lambda e: stride_speedup(e, TEAPOT), "times"),
    arithmetic("5.4, equation 5.9", "best duplication by formula", 6.32, formula.best_duplication(), "equation 5.9"),
    Claim("figure 5-6", "instructions a visible polygon without duplication", 153, lambda e: duplication(e, TEAPOT)[1], "instructions", FIVE),
    Claim("figure 5-6", "instructions a visible polygon at the best duplication", 132, lambda e: min(duplication(e, TEAPOT).values()), "instructions",
          FIVE, OTHER_SCENE + " Its 16 copies cost 125 here, the head's best is 1 copy (scripts/eldridge.py)."),
    Claim("figure 5-6", "best duplication, simulated", 16, lambda e: formula.least(duplication(e, TEAPOT)), "", EXACT,
          OTHER_SCENE + " The formula has 6.3; how much copies help depends on how a scene is spread over the columns."),
    arithmetic("5.4", "saving at the best duplication", 20, 100 * (1 - 132 / 153), "132 against 153", "%", Tolerance(margin=1), ""),
    Claim("figure 5-8", "both together: best duplication", 1, lambda e: best_pair(e, TEAPOT)[0]),
    Claim("figure 5-8", "both together: best stride", 16, lambda e: best_pair(e, TEAPOT)[1], "", EXACT,
          "His scene is the crocodile; strides of 8 and 16 differ by 7 %."),
    Claim("figure 5-9", "temporal locality: polygons of the busiest processor, teapot", 176, lambda e: busiest_with_locality(e, TEAPOT), "", FIVE,
          OTHER_SCENE + " Beethoven's is 182 here."),
    Claim("5.5", "temporal locality: instructions a visible polygon above an even share", 167.8, lambda e: locality_penalty(e, TEAPOT),
          "instructions", FIVE, "", 166 * (formula.GI + formula.GF) / 4100,
          "166 polygons too many of table 8.1's 4100 visible (5936 visible ones would give it)"),
    Claim("5.5", "temporal locality costs more than a naive sort-middle", (156, None), lambda e: locality_penalty(e, TEAPOT), "instructions", EXACT,
          OTHER_SCENE),
]

CHAPTER_6 = [
    Claim("6.4", "compositing a pixel in groups of 1", 24, dense_pixel, "instructions", ONE, "", formula.pass_cost(1, 3, 15), "equation 6.4"),
    Claim("6.4, 6.7", "factor of large groups over groups of 1, n >> g >> 21", 8,
          lambda e: composite_of(e, 1, LARGE_RING) / composite_of(e, LARGE_GROUP, LARGE_RING), "times", FIVE, "", 24 / 3, "24 over 3",
          note=f"Groups of {LARGE_GROUP} on {LARGE_RING:,} processors."),
    arithmetic("6.6", "least instructions to composite a screen", 1.17, 3 * formula.Q / 1e6, "3 a pixel", "million instructions", ONE),
    arithmetic("6.6", "time for them at 14 MHz", 0.084, 3 * formula.Q / 14e6, "14 MHz", "s", ONE),
    arithmetic("6.6", "frames/s that only composite", 11.9, 14e6 / (3 * formula.Q), "14 MHz", "1/s", ONE),
    arithmetic("6.6, equation 6.5", "instructions a polygon, processor of a group and 1/n", 84, formula.pass_cost(1) / 2, "((2 + 1) 42 + 30)/2",
               "instructions", TENTH, ""),
    arithmetic("6.6, equation 6.8", "factor of P p/n under the root", 441, 4 * 84 * 21, "6.5 and 6.6 at 6.7's group: twice the root of 84 x 21",
               "", EXACT, ""),
    arithmetic("6.6, figure 6-5", "visible polygons from which sort-twice is faster, by 6.8 and 6.9 as printed", 50503, formula.overtaken_at(),
               "6.8 as printed and 6.9"),
    Claim("6.6, figure 6-5", "the same, simulated, communication and compositing", 50503, lambda e: overtaken_at(e, sorting_instructions) / 2,
          "visible polygons", FIVE, "", formula.overtaken_at(formula.sort_twice_derived), "6.8 as it follows from 6.5 to 6.7"),
    Claim("6.6, figure 6-7", "polygons beyond which sort-twice takes less in all", (None, 64000), lambda e: overtaken_at(e, all_instructions),
          "polygons"),
    Claim("6.6, figure 6-6", "sort-twice by 6.8, 320 000 visible polygons: simulated", formula.sort_twice(320_000) / 1e6,
          lambda e: sorting_instructions(sort_twice(e, random_scene(640_000), formula.group_of(320_000))) / 1e6, "million instructions", FIVE, "",
          formula.sort_twice_derived(320_000) / 1e6, "6.5 to 6.7"),
]

HAND = "Assembly by hand, packed into bundles; his was a compiler's but for the pass."
RECIPROCAL = HAND + " One reciprocal of the area serves all slopes, where he divides 32 bits by 32 twice a parameter."
NO_BEETHOVEN = "The model is no part of the project: scripts/princeton.py table."
CHEAPER = "Geometry, normalising and pixels are cheaper here, so that two pictures' time is enough."


def costs(item, textured=False):
    return lambda emulator: getattr(stage_costs(emulator, SMALL, textured), item)


def a_line(item, textured=False):
    return lambda emulator: getattr(line_figures(emulator, SMALL, textured), item)


def lines_a_polygon(textured):
    """To keep it, and to light it."""
    return lambda emulator: 1 / a_line("transformed", textured)(emulator) + 1 / a_line("lit", textured)(emulator)


def frame(scene, value, textured=False):
    """The first of table 8.1's frames."""
    return lambda emulator: value(frame_figures(emulator, scene, textured)[0])


def faster(emulator):
    first = frame_figures(emulator, LARGE, False, stride=BEST_STRIDE)[0]
    return first.visible * first.a_second()


STAGES = [
    Claim("2", "operations an instruction", (2, 3), lambda e: array(e, SMALL)["operations_per_bundle"], "", EXACT,
          "Five of six bundles are passes: a word takes five operations, three of them the communication slot's. Other stages have 1.8."),
    Claim("5.4", "to keep or reject a polygon", 1000, costs("transform"), "instructions", FIVE, HAND),
    Claim("5.4", "more for a visible one, shaded", 5000, costs("light"), "instructions", FIVE, RECIPROCAL),
    Claim("4.4, 7.4", "a pass of one place", 156, costs("a_pass"), "instructions", FIVE,
          "126 for the words as his; what to pass and to keep is decided beside them."),
    Claim("7.4", "a pass of 16 places", 786, lambda e: far_pass(e, SMALL, 16), "instructions", FIVE),
    Claim("7.5.1", "normalise a polygon", 350, costs("normalise"), "instructions", FIVE, HAND + " 16 x 16 products where they are enough."),
    Claim("8.1.3", "a shaded pixel", 80, costs("sample"), "instructions", FIVE, HAND + " Slopes and depth stay in registers."),
    Claim("8.1.3", "a textured pixel", 202, costs("sample", True), "instructions", FIVE, HAND),
    Claim("7.2", "instructions of a scanline left to the program", 850, lambda e: 910 - dispatching(e, SMALL), "", FIVE),
    Claim("8.1.1", "scanlines a shaded polygon", 7, lines_a_polygon(False), "", EXACT, RECIPROCAL + " Four are kept or rejected a line, one is lit."),
    Claim("8.1.1", "scanlines a textured polygon", 11, lines_a_polygon(True), "", EXACT, RECIPROCAL),
    Claim("8.1.2", "passes a scanline", 5, a_line("passes")),
    Claim("8.2", "polygons normalised a scanline", 2, a_line("normalised", True), "", EXACT, HAND),
    Claim("8.1.3", "shaded pixels a scanline", 8, a_line("samples"), "", EXACT, "Three rounds of 8 fit, with a look for the next polygon each."),
    Claim("8.1.3", "textured pixels a scanline", 4, a_line("samples", True), "", EXACT, "Two rounds of 4 fit."),
    Claim("7.3.3", "geometry, share of all instructions: less than", (None, 15), lambda e: 100 * share_of(e, SMALL, "geometry"), "%"),
]

ON_THE_MACHINE = [
    Claim("figure 4-2", "on the machine: passes a visible polygon, teapot", 1, lambda e: passes_a_polygon(e, SMALL), "", Tolerance(percent=20)),
    Claim("8.2", "on the machine: passes a visible polygon, crocodile", 0.6, lambda e: passes_a_polygon(e, LARGE), "", FIVE,
          "Another model: a teapot is in the middle of the screen, where the ring is fullest."),
    Claim("figure 5-3", "on the machine: sparse over dense, teapot", (1, 2),
          lambda e: passes_a_polygon(e, SMALL, dense=0) / passes_a_polygon(e, SMALL), "times"),
    Claim("figure 5-5", "on the machine: best stride", (8, 16), lambda e: formula.least(strides_on_machine(e, SMALL))),
    Claim("figure 5-5", "on the machine: speed-up at the best stride", (1.96, 2.40),
          lambda e: strides_on_machine(e, SMALL)[1] / min(strides_on_machine(e, SMALL).values()), "times", EXACT,
          OTHER_SCENE + " The model has 2.50 on the polygons of this one, at his costs (scripts/princeton.py strides)."),
    Claim("figure 5-6", "on the machine: instructions a visible polygon without duplication", 153, lambda e: geometry_and_communication(e, SMALL, 1),
          "instructions", FIVE, "A pass costs less and there are fewer of them."),
    Claim("figure 5-6", "on the machine: the same with 16 copies", 132, lambda e: geometry_and_communication(e, SMALL, 16), "instructions", FIVE,
          "Copies cost geometry, which is a fifth to a tenth of his."),
]

FRAMES = [
    *(Claim("table 8.1", f"beethoven, {what}", published, unit=unit, because=NO_BEETHOVEN)
      for what, published, unit in (("frames/s", 10, "1/s"), ("visible polygons/s", (32000, 36000), "1/s"), ("geometry", (8, 9), "%"),
                                    ("communication", (42, 46), "%"), ("rasterising", (45, 50), "%"))),
    *(Claim("table 8.1", f"{name}, frames/s", rate, frame(scene, lambda f: f.a_second()), "1/s", FIVE, because)
      for name, scene, rate, because in (("teapot", SMALL, 10, CHEAPER), ("crocodile", LARGE, 6, "Another model; four pictures' time instead of five."))),
    Claim("table 8.1", "teapot, visible polygons/s", (43000, 44000), frame(SMALL, lambda f: f.visible * f.a_second()), "1/s", FIVE, CHEAPER),
    Claim("table 8.1", "crocodile, visible polygons/s", (49800, 62400), frame(LARGE, lambda f: f.visible * f.a_second()), "1/s", FIVE,
          "Another model, of which more is visible, and four pictures' time instead of five."),
    *(Claim("table 8.1", f"{name}, share of {part}", published, frame(scene, lambda f, part=part: 100 * getattr(f, part)), "%", FIVE, because)
      for name, scene, shares, because in (
          ("teapot", SMALL, {"geometry": (10, 12), "communicate": (52, 55), "rasterise": (35, 36)},
           "As he counts: waiting for the next picture is rasterising. Geometry is ten times cheaper, communication is not."),
          ("crocodile", LARGE, {"geometry": 13, "communicate": (57, 69), "rasterise": (18, 30)},
           "Another model. Geometry is ten times cheaper, communication is not."))
      for part, published in shares.items()),
    Claim("9.1", "crocodile with distribution, expected: visible polygons/s", (95000, None),
          faster, "1/s", EXACT, "Another model."),
    Claim("figure 7-4", "polygons on the fullest processor, teapot", 260, frame(SMALL, lambda f: f.slices), "", FIVE,
          "Smaller on the screen: his view is not known. Figure 4-1 has 394."),
]

LINES = 15750
ACCOUNTS = [
    arithmetic("8.1.1", "shaded polygons/s", 2304000, 1024 / 7 * LINES, "equation 8.1", "1/s"),
    arithmetic("8.1.1", "textured polygons/s", 1466182, 1024 / 11 * LINES, "equation 8.2", "1/s"),
    arithmetic("8.1.2", "passes/s", 80640000, 1024 * 5 * LINES, "equation 8.3", "1/s"),
    arithmetic("8.1.3", "textured pixels/s", 48384000, 768 * 4 * LINES, "equation 8.5", "1/s"),
    arithmetic("8.1.3", "shaded pixels/s", 96768000, 768 * 8 * LINES, "equation 8.6", "1/s"),
    arithmetic("8.1.3", "textured pixels/s, not line-locked", 70970297, 1024 * 14e6 / 202, "equation 8.7", "1/s"),
    arithmetic("8.1.3", "shaded pixels/s, not line-locked", 179200000, 1024 * 14e6 / 80, "equation 8.8", "1/s"),
    arithmetic("8.2", "geometry", 2.07, 34404 * 910 * 11 * 6 / 1e9, "equation 8.12", "thousand million/s", ONE),
    arithmetic("8.2", "communication", 6.98, 10400 * 910 / 5 * 1024 * 0.6 * 6 / 1e9, "equation 8.15", "thousand million/s", ONE),
    arithmetic("8.2", "rasterising", 3.02, 360 * 1365 * 1024 * 6 / 1e9, "equation 8.17", "thousand million/s", ONE),
    arithmetic("8.2", "polygons on the worst processor, textured crocodile", 460, 360, "equation 8.17 and the sentence before", "", EXACT, ""),
    arithmetic("8.2", "frames/s, textured crocodile", 6, 5, "figure 7-3 of the same scene", "1/s", EXACT, ""),
]

CLAIMS = [*CHAPTER_4, *CHAPTER_5, *CHAPTER_6, *STAGES, *ON_THE_MACHINE, *FRAMES, *ACCOUNTS]
