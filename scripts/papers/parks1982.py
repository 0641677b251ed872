# SPDX-License-Identifier: MIT
"""J. K. Parks, A Comparison of Two Multiprocessor Graphics Machine Designs, M.Sc. thesis, University of North Carolina, 1982: splitters,
interlaces, a hybrid and one processor."""

from statistics import mean

from claims import EXACT, Claim, Tolerance
from measuring import setting
from parks_fabric import bus_ratio, close_up, order_ratio, variant_changes
from parks_figures import NUMBERED, figure15_of, slowest_by_formula
from parks_formula import formula_errors
from parks_forms import differing_forms, points_for_a_block, small_triangles_for_a_block
from parks_implied import POLYGONS, bounds, published
from parks_machines import FIGURE_15, PUBLISHED
from parks_measures import (counted, frames_won, greatest_pair, hybrid_over_best, landscape_shares, millions, of_whole, over_end, own_cost,
                            pair_of_published, pixel, random_scene, runways_take_longer, share, step, winners)
from parks_winners import overhead_of

TITLE = "Parks 1982: splitter, interlace, hybrid, one processor"
NOTES = [
    "`configs/uniprocessor.yaml`, `splitter4`, `splitter16`, `splitter256`, `interlace4`, `interlace16`, `interlace256`, `hybrid16`. Parks counted "
    "polygons, vertices, segments and pixels of each processor and applied a formula; so do these rows, on the counts of the emulated run, unless "
    "they say \"emulated\": cycles that the program executes. The formula is 139 a polygon, 319.3 a vertex, 158 a segment, 21 a pixel, on ideal "
    "fabric; a cycle is 300 ns.",
    "His scenes are lost. Figure 15 is a reconstruction from his statistics, the others are scenes of the same kind whose viewpoints were chosen so "
    "that the uniprocessor's polygons and cycles come near his: those two agree because they were made to, what is tested is how the work spreads "
    "over processors. What the thesis puts in (512 x 512 pixels, 16-bit words, polygons of 1 to 10 vertices) is not listed, nor are numbers that "
    "cannot be read in the scan: eight of the table of figures 16 to 25, and the graphs of figures 27 to 31."]

FIVE, ONE = Tolerance(percent=5), Tolerance(percent=1)
ROUNDING = Tolerance(margin=0.006)  # million cycles: half of the last digit of the number itself and of what bounds it
AFRESH = "The program is written afresh; docs/tiler-program.md says why each figure is lower than the listing's."
LOST = "The scene is lost, ours is of its kind. "

# 2.2: its sections' costs; what they add up to.
SECTIONS = {"polygon": (139, (42, 97)), "vertex": (319.3, (24.6, 25, 257.2, 12.5)), "segment": (158, (85, 15, 58)), "pixel": (21, (21,))}


def costs():
    claims = [Claim("appendix B", "instruction forms whose cycles differ (parks-costs.csv has 39)", 0, differing_forms, "", EXACT,
                    "MUL and DIV take 10 cycles in all, a branch one.")]
    for item, (cost, parts) in SECTIONS.items():
        claims.append(Claim("2.2", f"a {item} (emulated, thesis' precision)", cost, lambda e, i=item: own_cost(e, i), "cycles", FIVE, AFRESH,
                            sum(parts),
                            "sum of its parts " + ", ".join(map(str, parts))))
        claims += [Claim("2.2", f"part of a {item}", part, None, "cycles", because="A section of the listing; ours has others.")
                   for part in parts if len(parts) > 1]
    for autoincrement, drawn, hidden in ((1, 21, 17), (0, 19, 15)):
        where = "appendix B" if autoincrement else "appendix B, a real PDP-11"
        claims += [Claim(where, f"a pixel, {kind} (emulated, thesis' precision)", cost, lambda e, k=kind, a=autoincrement: pixel(e, k, a), "cycles",
                         FIVE, AFRESH)
                   for kind, cost in (("drawn", drawn), ("hidden", hidden))]
    return claims


# Appendix C: vertices, v average times polygons; where the slowest and the fastest processor is.
VERTICES = (731, 163, 731, 8, 140, 731, 731, 163)
NAMED = [("C.2", "splitter4", "slowest", "P1"), ("C.3", "interlace4", "slowest", "P2"), ("C.4", "splitter16", "slowest", "P1"),
         ("C.6", "interlace16", "slowest", "P3"), ("C.7", "interlace16", "fastest", "P8"), ("C.8", "hybrid16", "slowest", "P7")]
# Shares of the average polygon's cycles: vertices, segments, pixels, per cent.
SHARES = ((4.047641, 3.866071, 91.488503), (2.046302, 4.149701, 93.410507), (13.712728, 6.850480, 77.411568), (0.349244, 5.530153, 94.082603),
          (8.255873, 9.104323, 81.330566), (34.791298, 10.40959, 49.660797), (None, None, 49.314236), (7.296244, 7.976115, 83.322250))


CUTS = "The statistics do not say how the shuttle's polygons are cut: ours is a reconstruction."


def figure15_row(number, where, row, vertices, shares):
    machine, which, name, polygons, segments, area, cycles = row
    what = f"{machine} {which}".strip()

    def of(key):
        return lambda e: counted(e, machine)[name][key]

    by_formula = 139 * polygons + 319.3 * vertices + 158 * segments + 21 * area * polygons
    return [
        Claim(where, f"{what}: polygons", polygons, of("polygons")),
        Claim(where, f"{what}: vertices (mean x polygons)", vertices, of("vertices"), "", ONE, CUTS),
        Claim(where, f"{what}: segments", segments, of("charged_segments"), "", ONE),
        Claim(where, f"{what}: mean area", area, lambda e: of("pixels")(e) / of("polygons")(e), "pixels", ONE,
              "Cut at whole pixels, polygons cover a few pixels more; uncut (full precision) it is 411.18." if machine == "splitter16" else ""),
        *(Claim(where, f"{what}: share of {item}", percent, lambda e, i=item: share(e, machine, name, i), "%", ONE, CUTS)
          for item, percent in zip(("vertices", "segments", "pixels"), shares) if percent),
        Claim(where, f"{what}: cycles", cycles, of("formula_u"), "cycles", ONE if number == 0 else FIVE, "", by_formula, "the formula on its counts"),
        Claim(where, f"{what}: cycles, emulated, full precision", cycles, lambda e: figure15_of(e, machine)[name]["scene_u"], "cycles", FIVE,
              AFRESH + " Correct slopes cost 58 % more than his cut ones; "
              "polygons without an assigned line and splitters' cuts at the left are charged otherwise.")]


def figure15():
    claims = [claim for i, row in enumerate(FIGURE_15) for claim in figure15_row(i, f"figure 15, C.{i + 1}", row, VERTICES[i], SHARES[i])]
    claims += [Claim(f"figure 15, {where}", f"{machine}: {name} is the {which}: its cycles over the {which}'s", 1,
                     lambda e, m=machine, w=which, n=name: over_end(e, m, w, n), "", Tolerance(percent=0.1),
                     "Others are as slow but for some cycles.")
               for where, machine, which, name in NAMED]

    def whole(emulator):
        return figure15_of(emulator, "uniprocessor")["P0"]

    claims += [Claim("figure 15, C.1", "pixels", 251224, lambda e: whole(e)["pixels"]),
               Claim("figure 15, C.1", "depth complexity", 0.958344, lambda e: whole(e)["D"]["mean"], "", Tolerance(margin=1e-6), "",
                     251224 / 512 ** 2, "pixels of 512 x 512")]
    for data, name, published_counts in (
            ("y", "polygons {} lines high", {1: 31, 2: 95, 3: 68, 4: 23, 5: 7, 6: 11, 11: 2, 14: 4, 15: 4, 73: 1, 280: 1, 302: 1}),
            ("v", "polygons of {} vertices", {1: 2, 2: 54, 3: 153, 4: 34, 5: 4, 6: 1}),
            ("D", "pixels under {} polygons", {0: 107520, 1: 59386, 2: 94945})):
        claims += [Claim("figure 15, C.1", name.format(value), count, lambda e, d=data, v=value: dict(whole(e)[d]["counts"]).get(v, 0))
                   for value, count in published_counts.items()]
    return claims


BUILT_AFTER = "Our scene was built after the uniprocessor's 3.19, which seems to be 3.79 (docs/results.md)."
TALLER = LOST + "His has {} segments by its own cycles, ours {}, and fewer pixels (docs/results.md)."
WHY = {
    ("17", "uniprocessor"): "A misreading, it seems: 3.79 would fit the text, and ours has the other figures of 17 a little after figure 16, at "
                            "3.89 (docs/results.md). Our scene was built to have 3.19.",
    **{("17", machine): BUILT_AFTER for machine in ("interlace4", "splitter16", "hybrid16")},
    **{("22", machine): TALLER.format(5063, 3650) for machine in ("interlace4", "interlace16")},
    **{("23", machine): TALLER.format(5747, 3298) for machine in ("interlace4", "interlace16")},
    **{(figure, "splitter16"): LOST + "Each of its shuttles falls into one block, the best that two blocks can do; less needs a third one with a "
                                      "part of them, which his must have had (docs/results.md)." for figure in ("18", "20")},
    ("21", "uniprocessor"): "A misreading, it seems: 5.63 would fit.",
    ("23", "hybrid16"): "A misreading, it seems: one of four processors can't do with less. The first digit is not legible in the scan; .728 "
                        "would fit, and ours is 4 % above it.",
    ("25", "uniprocessor"): LOST + "Its viewpoint was chosen to come near.",
}


def figures():
    claims = [Claim(f"figure {figure}", "polygons", count, lambda e, f=figure: slowest_by_formula(e, "uniprocessor")[f]["polygons"], "", FIVE)
              for figure, count in POLYGONS.items()]
    for machine in PUBLISHED:
        for figure in NUMBERED:
            if published(machine, figure) is None:
                continue
            implied, by = bounds(machine, figure)
            claims.append(Claim(f"figure {figure}", machine, published(machine, figure),
                                lambda e, m=machine, f=figure: slowest_by_formula(e, m)[f]["formula_u"] / 1e6,
                                "million cycles", FIVE if machine != "uniprocessor" else ONE, WHY.get((figure, machine), ""), implied, by, ROUNDING))
    return claims


LEGIBLE_16 = ("15", "16", "18", "19", "22", "23", "24", "25")  # both interlace16 and splitter16


TIMED = [("splitter16", "18", .189), ("splitter16", "19", .318), ("interlace16", "18", .237), ("interlace16", "19", .228)]
FRAMES = [("splitter16", "18", 5), ("splitter16", "19", 3), ("interlace16", "18", 4), ("interlace16", "19", 4)]
SCENE_19 = LOST + "Our 18 splits less well than his: each shuttle falls into one block (docs/results.md)."
SENSITIVITY = [
    *(Claim("4.4", f"figure {figure}, {machine}: time", seconds, lambda e, m=machine, f=figure: 0.3 * millions(e, m, f), "s", FIVE, SCENE_19,
            0.3 * published(machine, figure), "its cycles x 300 ns") for machine, figure, seconds in TIMED),
    *(Claim("4.4", f"figure {figure}, {machine}: frames/s", rate, lambda e, m=machine, f=figure: 1 / (0.3 * millions(e, m, f)), "1/s",
            Tolerance(margin=0.5), "",
            1 / (0.3 * published(machine, figure)), "its cycles x 300 ns") for machine, figure, rate in FRAMES),
    Claim("4.4", "splitter16, figure 18 to 19: change", 68, lambda e: step(e, "splitter16", "18", "19"), "%", FIVE,
          SCENE_19 + " Over a fifth of the approach its share of the uniprocessor's time changes by up to 50 %.", 100 * (1.06 / .629 - 1),
          "its cycles"),
    Claim("4.4", "interlace16, figure 18 to 19: change, at most", (None, 4), lambda e: step(e, "interlace16", "18", "19"), "%", EXACT, "",
          100 * (.791 / .761 - 1), "its cycles"),
    Claim("4.4, figure 29", "splitter16 of the uniprocessor's time, figure 18", 16, lambda e: of_whole(e, "splitter16", "18"), "%",
          Tolerance(margin=0.5), SCENE_19,
          100 * .629 / 3.91, "its cycles"),
    Claim("4.4, figure 29", "splitter16 of the uniprocessor's time, figure 19", 28, lambda e: of_whole(e, "splitter16", "19"), "%",
          Tolerance(margin=0.5), "",
          100 * 1.06 / 3.75, "its cycles"),
    Claim("4.4, figure 29", "interlace16 of the uniprocessor's time: greatest change within a pair, points", (None, 1),
          lambda e: greatest_pair(e, lambda e, a, b: abs(of_whole(e, "interlace16", a) - of_whole(e, "interlace16", b))), "%", EXACT,
          "Figures 16 and 17 of ours, since 17 was built after a misread 3.19; the other pairs change by 0.6 at most."),
    Claim("4.4, figure 29", "uniprocessor: greatest change within a pair", 4.5,
          lambda e: greatest_pair(e, lambda e, a, b: step(e, "uniprocessor", a, b)), "%", FIVE,
          "Read 3.79 for 17's 3.19 and 5.63 for 21's 5.83, and 4.5 % (22 to 23) is the greatest.", pair_of_published(), "figures 16 and 17"),
]


WITHOUT_LINE = "Here a polygon without an assigned line costs some 70 cycles, not 139 and 319 a vertex."
COMPARISON = [
    Claim("4.3", "figures where the splitter wins with 4 processors", 2, lambda e: frames_won(e, 4, "s"), "of 11"),
    Claim("4.3", "who wins with 16, figures " + ", ".join(LEGIBLE_16), "i s s i i i s s", lambda e: winners(e, LEGIBLE_16)),
    Claim("5.2", "figures where the splitter wins with 256 processors", (6, None), lambda e: frames_won(e, 256, "s"), "of 11"),
    Claim("5.2", "figures where the splitter wins with 256 processors, emulated, ideal fabric", (6, None),
          lambda e: frames_won(e, 256, "s", True, False), "of 11",
          EXACT, WITHOUT_LINE),
    Claim("5.2", "figures where the splitter wins with 256 processors, emulated, real fabric", (6, None),
          lambda e: frames_won(e, 256, "s", False, False), "of 11", EXACT,
          WITHOUT_LINE),
    Claim("4.5", "interlace256: polygon and vertex time, mean of the landscapes", 75, lambda e: mean(landscape_shares(e, 256, 0)), "%",
          Tolerance(percent=10)),
    Claim("4.5", "interlace256: polygon and vertex time, mean of the landscapes, emulated", 75, lambda e: mean(landscape_shares(e, 256, 1)), "%",
          Tolerance(percent=10), WITHOUT_LINE),
    Claim("4.5", "interlace16: landscapes without half of its time in polygons and vertices", 1,
          lambda e: sum(s <= 50 for s in landscape_shares(e, 16, 0)),
          "of 7"),
    Claim("4.5", "interlace16: the same, emulated", 1, lambda e: sum(s <= 50 for s in landscape_shares(e, 16, 1)), "of 7", EXACT, WITHOUT_LINE),
    Claim("4.5", "interlace256: what more processors can improve", 25, lambda e: 100 - mean(landscape_shares(e, 256, 0)), "%", Tolerance(margin=10),
          "", 100 - 75, "75 % overhead"),
    Claim("4.6", "hybrid16 not markedly superior: least of its time over the better of the others", (0.9, None), hybrid_over_best),
    Claim("4.3, figure 27", "splitter16, figure 15: sections (1,0) and (2,0) take longer than the shuttle's (3,2)", "yes",
          runways_take_longer),
    Claim("4.3", "points that take as long as a 128 x 128 polygon", 573, lambda e: points_for_a_block(e)[0], "polygons", ONE, "",
          (139 + 4 * 319.3 + 128 * 158 + 128 ** 2 * 21) / (139 + 319.3 + 158 + 21), "the formula"),
    Claim("4.3", "the same, emulated", 573, lambda e: points_for_a_block(e)[1], "polygons", FIVE, AFRESH),
    Claim("4.3", "triangles of 0.01 of the area that take as long as a 128 x 128 polygon", 55, None, "polygons", Tolerance(percent=2),
          "Of 12.8 x 12.8 pixels on the mean, which no triangle has; the arithmetic is right.",
          (139 + 4 * 319.3 + 128 * 158 + 128 ** 2 * 21) / (139 + 3 * 319.3 + 12.8 * 158 + 12.8 ** 2 * 21), "the formula"),
    Claim("4.3", "the same, emulated: squares of 13 x 13 cut in half", 55, small_triangles_for_a_block, "polygons", FIVE,
          AFRESH + " A right triangle of 13 lines has 91 pixels, not 164."),
    Claim("4.1, figure 13", "random scene, splitter: four times the processors, speed-up from 4 to 16", 4,
          lambda e: random_scene(e, "splitter4") / random_scene(e, "splitter16"), "times", FIVE,
          "The slowest processor decides, and a random scene is not that even; polygons that are cut are set up twice."),
    Claim("4.1, figure 13", "random scene, splitter: speed-up from 64 to 256", 4,
          lambda e: random_scene(e, "splitter64") / random_scene(e, "splitter256"), "times", FIVE,
          "The same, the more the smaller a block is."),
    Claim("4.1, figure 14", "random scene, interlace256: polygon and vertex time, the limit", (50, None),
          lambda e: overhead_of(e, "interlace256", "random_polygons", 1)[0][0], "%"),
    *(Claim("1.2", f"{machine}: formula (own costs, full precision) over emulated cycles, mean error", (-5, 5),
            lambda e, m=machine: 100 * mean(formula_errors(e, m, "own costs, full precision")), "%", EXACT,
            "Most small polygons touch no line of a processor; the program lets go of them after their set-up, where the formula charges every "
            "vertex.")
      for machine in ("uniprocessor", "splitter4", "interlace4", "splitter16", "interlace16")),
    Claim("2.3", "uniprocessor: error of not counting vertices on both sides, at most", 5, None, "%", because="Our program has no such double work."),
]

FABRIC = [
    Claim("5.3", "figure 18, interlace16: saved by skipping divisions", 20, lambda e: -variant_changes(e, "interlace16", "18")[1], "%",
          Tolerance(percent=10),
          "Divisions are a smaller part of ours, which lets go of polygons without an assigned line first; interlace64 saves 19 %, "
          "interlace256 23 %."),
    Claim("3.3", "splitting takes much less time than drawing: splitter16, figure 20, over splitters that take none", (None, 1.01),
          lambda e: close_up(e, "splitter16") / close_up(e, "splitter16", *setting(fabric__splitter__time_per_vertex="0ns")), "times"),
    Claim("3.3", "a tree may saturate with contiguous polygons: splitter256, figure 20, mesh order over shuffled", (1, None),
          lambda e: order_ratio(e, "splitter256", "mesh") / order_ratio(e, "splitter256", "shuffled"), "times"),
    *(Claim("3.3", f"the frame buffer's bus is overshadowed: {machine}, 300 ns a pixel, over local ones", (None, 1.05), lambda e,
            m=machine: bus_ratio(e, m, "300ns"), "times", EXACT,
            "Sixty-four processors make pixels faster than such a bus takes them.")
      for machine in ("uniprocessor", "splitter16", "interlace16", "interlace64")),
    Claim("1.1", "pixels of a 512 x 512 screen in 1/15 s", 4, None, "pixels/us", Tolerance(margin=0.5), "Arithmetic, and right.", 512 ** 2 * 15 / 1e6,
          "its screen"),
    Claim("1.2", "polygons of the shuttle's database, about", 450, None, because="NASA's data are lost; ours is a model of our own."),
    Claim("1.2", "polygons of the airport's database, about", 900, None, because="As above."),
    Claim("1.1, 5.3", "cost of hardware, of chips", "-", None, because="The emulator has no prices."),
]

CLAIMS = [*costs(), *figure15(), *figures(), *SENSITIVITY, *COMPARISON, *FABRIC]
