# SPDX-License-Identifier: MIT
"""Eldridge's figures 4-2 to 6-7: simulated by the model, by formula, as published."""

import sys
from pathlib import Path

import eldridge_formula as formula
from eldridge_formula import N, Q
from eldridge_ring import (COUNTS, DUPLICATIONS, RING_SIZES, STRIDES, TEAPOT, all_instructions, best_pair, busiest_with_locality, communicating,
                           composite_of, counts, distribution, duplication, mesh_scene, random_scene, received, shifts, sort_middle,
                           sort_twice_at_best, sorting_instructions, sparse_over_dense)
from measuring import ROOT, plot_figure, table

GROUPS = tuple(2 ** k for k in range(11))


def scenes_here(arguments):
    """The thesis' three, or what stands for them: teapot (9408 polygons), Beethoven (5030), crocodile (34 404)."""
    found = {"teapot": TEAPOT}
    for name, file in (("beethoven", "beethoven.ply"), ("head", "head.obj")):
        path = (ROOT / arguments.models / file).resolve()
        if path.exists():
            found[name] = mesh_scene(path)
        else:
            print(f"{Path(sys.argv[0]).name}: {path} is not there: left out", file=sys.stderr)
    return found


def scenes(emulator, arguments):
    rows = []
    for name, scene in {**scenes_here(arguments), "random 10 000": random_scene(10_000)}.items():
        found = counts(emulator, scene)
        most, mean = received(emulator, scene)
        rows.append([name, found["polygons"], found["visible"], f"{found['deliveries'] / found['visible']:.2f}", most, f"{mean:.1f}",
                     busiest_with_locality(emulator, scene)])
    table(["scene", "polygons", "visible", "columns a polygon", "polygons on the fullest processor", "on the mean",
           "fullest, each on its first column only"], rows)


def title(number, text):
    print(f"### Figure {number}: {text}\n")
    return f"Eldridge 1995, figure {number}: {text}"


def save(arguments, number, draw, name, x_label, y_label):
    if arguments.plots:
        plot_figure(arguments.plots / f"eldridge-{number}.png", draw, name, x_label, y_label)


def figure_4_2(emulator, arguments):
    name = title("4-2", "shifts a polygon, sort-middle, dense")
    curves = {scene: [shifts(emulator, what, n) for n in RING_SIZES] for scene, what in scenes_here(arguments).items()}
    curves["random 10 000"] = [shifts(emulator, random_scene(10_000), n) for n in RING_SIZES]
    table(["processors", *RING_SIZES], [[scene, *(f"{y:.2f}" for y in ys)] for scene, ys in curves.items()])

    def draw(axes):
        for scene, ys in curves.items():
            axes.semilogx(RING_SIZES, ys, "o-", base=2, label=scene)
        axes.axhline(1, color="black", linestyle=":", label="published: about 1")
        axes.set_ylim(0, 1.6)

    save(arguments, "4-2", draw, name, "processors", "shifts a visible polygon")


def figure_5_3(emulator, arguments):
    name = title("5-3", "sparse against dense rings")
    scenes_there = {**scenes_here(arguments), **{f"random {count}": random_scene(count) for count in (2000, 5000, 10_000, 20_000, 40_000)}}
    rows, points = [], []
    for scene, what in scenes_there.items():
        sparse, dense = counts(emulator, what, "--sparse"), counts(emulator, what)
        points.append((dense["visible"], communicating(sparse) / 1e6, communicating(dense) / 1e6))
        rows.append([scene, dense["visible"], f"{points[-1][1]:.2f}", f"{points[-1][2]:.2f}", f"{sparse_over_dense(emulator, what):.2f}"])
    table(["scene", "visible polygons", "sparse, million instructions", "dense", "sparse over dense (published: up to 2)"], rows)
    points.sort()

    def draw(axes):
        x, sparse, dense = zip(*points)
        axes.plot(x, sparse, "s", label="sparse, simulated")
        axes.plot(x, dense, "o", label="dense, simulated")
        axes.plot(x, [p * formula.pass_cost(1) / 1e6 for p in x], ":", label="one shift a polygon")

    save(arguments, "5-3", draw, name, "visible polygons", "million instructions to communicate")


def figure_5_5(emulator, arguments):
    name = title("5-5", "distribution: instructions to communicate, a visible polygon, by stride")
    curves = {scene: distribution(emulator, what) for scene, what in scenes_here(arguments).items()}
    curves["formula"] = {d: formula.two_strides(d) if d > 1 else formula.one_stride() for d in STRIDES}
    table(["stride", *STRIDES, "best", "speed-up"],
          [[scene, *(f"{y:.1f}" for y in ys.values()), formula.least(ys), f"{ys[1] / min(ys.values()):.2f}"] for scene, ys in curves.items()])
    print("Published: best at 8 or 16, speed-ups 1.96, 2.40 and 1.96; by formula 27.4 and 3.10.\n")

    def draw(axes):
        for scene, ys in curves.items():
            axes.semilogx(STRIDES, ys.values(), "k:" if scene == "formula" else "o-", base=2, label=scene)
        axes.axvspan(8, 16, alpha=0.1, label="published: best stride")

    save(arguments, "5-5", draw, name, "stride d of the first stage", "instructions a visible polygon")


def figure_5_6(emulator, arguments):
    name = title("5-6", "duplication: instructions for geometry and communication, a visible polygon")
    curves = {scene: duplication(emulator, what) for scene, what in scenes_here(arguments).items()}
    curves["formula"] = {m: formula.duplicated(m) for m in DUPLICATIONS}
    table(["copies", *DUPLICATIONS, "best"], [[scene, *(f"{y:.1f}" for y in ys.values()), formula.least(ys)] for scene, ys in curves.items()])
    print("Published: 153 without, 132 at best with 16 copies; by formula 6.3 copies.\n")

    def draw(axes):
        for scene, ys in curves.items():
            axes.semilogx(DUPLICATIONS, ys.values(), "k:" if scene == "formula" else "o-", base=2, label=scene)
        axes.plot([1, 16], [153, 132], "k*", markersize=9, label="published")
        axes.set_ylim(0, 400)

    save(arguments, "5-6", draw, name, "copies m of each polygon", "instructions a visible polygon")


def figure_5_8(emulator, arguments):
    name = title("5-8", "distribution and duplication together, instructions a visible polygon")
    scene, what = list(scenes_here(arguments).items())[-1]
    curves = {d: duplication(emulator, what, d) for d in STRIDES[:7]}
    table([f"{scene}: stride", *(f"m = {m}" for m in DUPLICATIONS)], [[d, *(f"{y:.1f}" for y in ys.values())] for d, ys in curves.items()])
    m, d = best_pair(emulator, what)
    print(f"Least: d = {d}, m = {m}. Published: d = 16, m = 1.\n")

    def draw(axes):
        for d, ys in curves.items():
            axes.semilogx(DUPLICATIONS, ys.values(), "o-", base=2, label=f"d = {d}")
        axes.set_ylim(0, 300)

    save(arguments, "5-8", draw, f"{name} ({scene})", "copies m of each polygon", "instructions a visible polygon")


def figure_6_4(emulator, arguments):
    name = title("6-4", "compositing a pixel in groups, instructions")
    simulated = [composite_of(emulator, g) / Q for g in GROUPS]
    limit = [3 + 21 / g for g in GROUPS]
    table(["group", *GROUPS], [["simulated", *(f"{y:.2f}" for y in simulated)], ["formula 6.4, n >> g", *(f"{y:.2f}" for y in limit)]])

    def draw(axes):
        axes.semilogx(GROUPS, simulated, "o-", base=2, label=f"simulated, {N} processors")
        axes.semilogx(GROUPS, limit, "k:", base=2, label="formula 6.4")
        axes.plot([1], [24], "k*", markersize=9, label="published: 24 in groups of 1, 3 at best")

    save(arguments, "6-4", draw, name, "processors a group", "instructions a pixel")


def sort_twice_points(emulator):
    for count in COUNTS:
        middle = sort_middle(emulator, random_scene(count))
        yield count, middle, sort_twice_at_best(emulator, random_scene(count))


def figure_6_6(emulator, arguments):
    name = title("6-6", "sort-middle against sort-twice, communication and compositing")
    points = [(middle["visible"], twice["group"], sorting_instructions(middle) / 1e6, sorting_instructions(twice) / 1e6)
              for _, middle, twice in sort_twice_points(emulator)]
    visible = [point[0] for point in points]
    by_formula = [[p * formula.best_two_strides() / 1e6 for p in visible], [formula.sort_twice(p) / 1e6 for p in visible],
                  [formula.sort_twice_derived(p) / 1e6 for p in visible]]
    table(["visible polygons", "group", "sort-middle, million instructions", "sort-twice", "sort-middle by 6.9", "sort-twice by 6.8 as printed",
           "as it follows from 6.5 to 6.7"],
          [[p, g, f"{m:.2f}", f"{t:.2f}", *(f"{y[k]:.2f}" for y in by_formula)] for k, (p, g, m, t) in enumerate(points)])

    def draw(axes):
        axes.loglog(visible, [point[2] for point in points], "o-", label="sort-middle, simulated")
        axes.loglog(visible, [point[3] for point in points], "s-", label="sort-twice, simulated")
        for ys, text in zip(by_formula, ("sort-middle, 6.9", "sort-twice, 6.8 as printed", "sort-twice, 6.8 as it follows")):
            axes.loglog(visible, ys, ":", label=text)
        axes.axvline(50503, color="black", alpha=0.4, label="published: predicted to cross")

    save(arguments, "6-6", draw, name, "visible polygons", "million instructions")


def figure_6_7(emulator, arguments):
    name = title("6-7", "sort-middle against sort-twice, all stages, textured")
    points = [(count, all_instructions(middle) / 1e6, all_instructions(twice) / 1e6) for count, middle, twice in sort_twice_points(emulator)]
    table(["polygons, half of them visible", "sort-middle, million instructions", "sort-twice"],
          [[count, f"{m:.2f}", f"{t:.2f}"] for count, m, t in points])

    def draw(axes):
        x, middle, twice = zip(*points)
        axes.loglog(x, middle, "o-", label="sort-middle, simulated")
        axes.loglog(x, twice, "s-", label="sort-twice, simulated")
        axes.axvline(64000, color="black", alpha=0.4, label="published: sort-twice faster beyond")

    save(arguments, "6-7", draw, name, "polygons", "million instructions")


def figures(emulator, arguments):
    for draw in (figure_4_2, figure_5_3, figure_5_5, figure_5_6, figure_5_8, figure_6_4, figure_6_6, figure_6_7):
        draw(emulator, arguments)
