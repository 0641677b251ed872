# SPDX-License-Identifier: MIT
"""Eldridge's figures 4-2 to 6-7 on the emulated machine, beside the model of its ring: both from the same bounding boxes, the machine with its checks
of every communication. Not line-locked, shaded, one frame."""

from functools import lru_cache

import eldridge_figures
import eldridge_formula as formula
from eldridge_formula import N, Q, WIDTH, least
from eldridge_ring import COUNTS, RING_SIZES, STRIDES, boxes_of, communicating, composite_of, counts, random_scene
from eldridge_ring import SHADED, strides as by_strides
from measuring import EmulatorError, scratch_folder, table
from princeton_machine import SMALL, array, changes_of, is_crowded, model, passes, phase, symbols

COPIES = (1, 2, 4, 8, 16)
GROUPS = (1, 2, 4, 8, 16, 32, 64, 128, 256, 512)
FEW = 1000  # polygons: compositing takes the same time for any number
PRINTED = "machine, model"
NO_ROOM = "no room"  # for all descriptors in some lane's memory


@lru_cache(maxsize=None)
def in_strips(emulator, scene, n):
    """The file of boxes with strips of columns in place of columns where there are fewer lanes than columns: lane i draws column i."""
    path = boxes_of(emulator, scene)
    if n >= WIDTH:
        return path
    strip = [next(k for k in range(n) if x < (k + 1) * WIDTH // n) for x in range(WIDTH)]
    narrow = scratch_folder() / f"{path.stem}-{n}.boxes"
    with open(path) as wide, open(narrow, "w") as file:
        for line in wide:
            words = line.replace("(", " ").replace(")", " ").replace(",", " ").split()
            if len(words) == 5:
                seen, x0, y0, x1, y1 = map(int, words)
                line = f"{seen} ({strip[x0]},{y0}) ({strip[x1]},{y1})\n"
            file.write(line)
    return narrow


@lru_cache(maxsize=None)
def on_machine(emulator, scene, config="sort-middle", n=N, **options):
    """The array's part of the statistics of one frame; None where there is no room for all descriptors."""
    if n < WIDTH:
        options["screen_columns"] = n
    changes = (("scene", f"{{object: {in_strips(emulator, scene, n)}}}"), ("topology.nodes", str(n)), ("screen.width", str(min(n, WIDTH))),
               ("array.line_locked", "false"), *(symbols(**options) if options else ()))
    try:
        return emulator.run(f"princeton1024-{config}", *changes_of(changes), "--check-communication")[0]["array"]
    except EmulatorError as error:
        if is_crowded(error):
            return None
        raise


def cycles(found, *stages):
    return sum(part["cycles_u"] for part in found["phases"] if not stages or part["name"] in stages)


def beside(machine, counted, form="{:.2f}"):
    return (form.format(machine) if machine is not None else NO_ROOM) + ", " + form.format(counted)


def visible(emulator, scene):
    return counts(emulator, scene)["visible"]


def communication(emulator, scene, **options):
    """Cycles of it, a visible polygon, or None."""
    found = on_machine(emulator, scene, **options)
    return cycles(found, "communicate") / visible(emulator, scene) if found else None


def scenes_of(arguments):
    return {**eldridge_figures.scenes_here(arguments), "random 10 000": random_scene(10_000)}


def figure_4_2(emulator, arguments):
    rows = []
    for name, scene in scenes_of(arguments).items():
        cells = []
        for n in RING_SIZES:
            found = on_machine(emulator, scene, n=n)
            counted = counts(emulator, scene, "--processors", n)["stages"][0]["passes"]
            cells.append(beside(passes(found)[1] / visible(emulator, scene) if found else None, counted / visible(emulator, scene)))
        rows.append([name, *cells])
    table([f"figure 4-2, shifts a visible polygon, dense ({PRINTED}): lanes", *RING_SIZES], rows)


def figure_5_3(emulator, arguments):
    rows = []
    for name, scene in {**scenes_of(arguments), "random 2000": random_scene(2000), "random 40 000": random_scene(40_000)}.items():
        sparse, dense = communication(emulator, scene, dense=0), communication(emulator, scene)
        model_sparse, model_dense = (communicating(counts(emulator, scene, *how)) / visible(emulator, scene) for how in (("--sparse",), ()))
        rows.append([name, visible(emulator, scene), beside(sparse, model_sparse, "{:.1f}"), beside(dense, model_dense, "{:.1f}"),
                     beside(sparse / dense if sparse and dense else None, model_sparse / model_dense)])
    table([f"figure 5-3 ({PRINTED})", "visible", "sparse, cycles a visible polygon", "dense", "sparse over dense (published: up to 2)"], rows)


def figure_5_5(emulator, arguments):
    rows = []
    for name, scene in scenes_of(arguments).items():
        machine = {d: communication(emulator, scene, stride=d) for d in STRIDES}
        counted = {d: communicating(counts(emulator, scene, *by_strides(d))) / visible(emulator, scene) for d in STRIDES}
        all_fit = None not in machine.values()
        rows.append([name, *(beside(machine[d], counted[d], "{:.1f}") for d in STRIDES), f"{least(machine) if all_fit else NO_ROOM}, {least(counted)}",
                     beside(machine[1] / min(machine.values()) if all_fit else None, counted[1] / min(counted.values()))])
    table([f"figure 5-5, cycles to communicate a visible polygon ({PRINTED}): stride", *STRIDES, "best", "speed-up by it"], rows)


def with_copies(emulator, stride, copies):
    """5.4 and 5.6 need geometry, so polygons: the configuration's own teapot. Cycles for geometry and communication, a visible polygon."""
    try:
        found = array(emulator, SMALL, stride=stride, duplication=copies)
    except EmulatorError as error:
        if is_crowded(error):
            return None
        raise
    return (phase(found, "geometry")["cycles_u"] + phase(found, "communicate")["cycles_u"]) / model(emulator, SMALL)["visible"]


def figures_5_6_and_5_8(emulator, _arguments):
    rows = []
    for d in STRIDES[:6]:
        cells = []
        for m in COPIES:
            counted = model(emulator, SMALL, *by_strides(d), "--duplicate", str(m))
            spent = sum(counted["instructions"][stage] for stage in ("rejecting", "lighting", "communicating")) / counted["visible"]
            cells.append(beside(with_copies(emulator, d, m), spent, "{:.1f}"))
        rows.append([d, *cells])
    table([f"figures 5-6 (first row), 5-8, teapot 9408, geometry and communication, cycles a visible polygon ({PRINTED}): stride",
           *(f"m = {m}" for m in COPIES)], rows)


def figure_6_4(emulator, _arguments):
    cells = []
    for g in GROUPS:
        config, options = ("sort-twice", {"group": g, "deferred": 0}) if g > 1 else ("sort-last-dense", {})
        found = on_machine(emulator, random_scene(FEW), config, **options)
        cells.append(beside(cycles(found, "composite") / Q, composite_of(emulator, g) / Q))
    table([f"figure 6-4, cycles to composite a pixel ({PRINTED}): group", *GROUPS], [["", *cells]])


def sort_twice_at(emulator, count):
    """With the group that the model takes: the machine's phases and what the model counts."""
    group = max(2, formula.group_of(visible(emulator, random_scene(count))))
    found = on_machine(emulator, random_scene(count), "sort-twice", group=group)
    return group, found, counts(emulator, random_scene(count), "--group", group, "--pixel-cost", SHADED)["instructions"]


def figures_6_6_and_6_7(emulator, _arguments):
    def cell(found, counted, *stages):
        in_model = ("communicating", "compositing") if stages else ("communicating", "rasterising", "compositing")
        return beside(cycles(found, *stages) / 1e6 if found else None, sum(counted[stage] for stage in in_model) / 1e6)

    rows = []
    for count in COUNTS:
        scene = random_scene(count)
        middle = on_machine(emulator, scene, stride=16)
        middle_model = counts(emulator, scene, *by_strides(16), "--pixel-cost", SHADED)["instructions"]
        group, twice, twice_model = sort_twice_at(emulator, count)
        sorting = ("communicate", "composite")
        rows.append([f"{count:,}", visible(emulator, scene), group, cell(middle, middle_model, *sorting), cell(twice, twice_model, *sorting),
                     cell(middle, middle_model), cell(twice, twice_model)])
        if middle is None and twice is None:
            break
    table([f"figures 6-6, 6-7, random polygons, million cycles ({PRINTED})", "visible", "group", "6-6, communication and compositing: sort-middle, d = 16",
           "sort-twice", "6-7, and rasterising: sort-middle", "sort-twice"], rows)


def greatest_that_fits(emulator, config, **options):
    """Random polygons, in thousands: by doubling, then halving."""
    def fits(thousands):
        return on_machine(emulator, random_scene(1000 * thousands), config, **options) is not None

    low, high = 1, 2
    while fits(high):
        low, high = high, 2 * high
    while high - low > max(1, low // 50):
        middle = (low + high) // 2
        low, high = (middle, high) if fits(middle) else (low, middle)
    return low


def what_fits(emulator, _arguments):
    schemes = {"sort-middle, d = 1": ("sort-middle", {}), "sort-middle, d = 16": ("sort-middle", {"stride": 16}),
               **{f"sort-twice, g = {g}": ("sort-twice", {"group": g}) for g in (64, 32, 16)}}
    table(["random polygons, half of them visible, that fit into 1024 lanes", "thousands"],
          [[name, greatest_that_fits(emulator, config, **options)] for name, (config, options) in schemes.items()])


def figures(emulator, arguments):
    for draw in (figure_4_2, figure_5_3, figure_5_5, figures_5_6_and_5_8, figure_6_4, figures_6_6_and_6_7, what_fits):
        draw(emulator, arguments)
