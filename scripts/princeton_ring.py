# SPDX-License-Identifier: MIT
"""Communication of the emulated Princeton Engine beside the model of its ring."""

from eldridge_formula import least
from measuring import EmulatorError, table
from princeton_machine import BEST_STRIDE, CROWDED, STRIDES, array, is_crowded, machine_scenes, model, passes, phase

COPIES = (1, 2, 4, 8, 16)
LANES = (768, 1024, 2048, 4096)
HEAD = ["passes by d: machine, model", "passes by 1: machine, model", "communication, cycles a visible polygon: machine, model"]


def model_arguments(stride, dense=True, copies=1):
    return ("--strides", f"{stride},1" if stride > 1 else "1", *(() if dense else ("--sparse",)), "--duplicate", str(copies))


def communication(emulator, scene, stride, dense=True, copies=1):
    """Passes by the stride and by one, cycles a visible polygon: on the machine that is not line-locked, and in the model."""
    found = array(emulator, scene, stride=stride, dense=int(dense), duplication=copies)
    counted = model(emulator, scene, *model_arguments(stride, dense, copies))
    by_stage = {stage["stride"]: stage["passes"] for stage in counted["stages"]}
    far, near = passes(found, stride)
    return {"far": (far, by_stage[stride] if stride > 1 else 0), "near": (near, by_stage[1]),
            "cycles": (phase(found, "communicate")["cycles_u"] / counted["visible"], counted["instructions"]["communicating"] / counted["visible"]),
            "frame": found["cycles_u"] / counted["visible"], "geometry": phase(found, "geometry")["cycles_u"] / counted["visible"]}


def where_it_fits(emulator, scene, *arguments, **options):
    """The same, or None where the descriptors are too many for a lane's memory."""
    try:
        return communication(emulator, scene, *arguments, **options)
    except EmulatorError as error:
        if not is_crowded(error):
            raise
        return None


def cells(row, *further):
    if row is None:
        return [CROWDED, *("" for _ in range(2 + len(further)))]
    return [*("{:,}, {:,}".format(*row[key]) for key in ("far", "near")), "{:.1f}, {:.1f}".format(*row["cycles"]),
            *(f"{sum(of(row)):.1f}" for of in further)]


def best(rows, side):
    """The best stride and how much faster it is than none: 0 the machine, 1 the model."""
    costs = {d: row["cycles"][side] for d, row in rows.items() if row}
    return f"{least(costs)}, {costs[1] / min(costs.values()):.2f}"


def strides(emulator, arguments):
    """Not line-locked: a pass of 32 places does not fit a scanline. Shaded."""
    summary = []
    for name, scene in machine_scenes(arguments).items():
        for kind, dense in (("dense", True), ("sparse", False)):
            rows = {d: where_it_fits(emulator, scene, d, dense) for d in STRIDES}
            table([f"{name}, {kind}: stride", *HEAD, "whole frame, cycles a visible polygon"],
                  [[d, *cells(row, lambda row: [row["frame"]])] for d, row in rows.items()])
            if all(rows.values()):
                summary.append([f"{name}, {kind}", best(rows, 0), best(rows, 1)])
    table(["best stride, speed-up by it (published: 8 or 16; 1.96, 2.40, 1.96)", "machine", "model"], summary)


def copies(emulator, arguments):
    """5.4: polygons on several lanes each; alone and with the stride that is best alone."""
    rows = []
    for name, scene in machine_scenes(arguments).items():
        for stride in (1, BEST_STRIDE):
            for m in COPIES:
                row = where_it_fits(emulator, scene, stride, copies=m)
                rows.append([f"{name}, d = {stride}", m, *cells(row, lambda row: [row["geometry"], row["cycles"][0]], lambda row: [row["frame"]])])
    table(["model, stride", "copies m", *HEAD, "geometry and communication, cycles a visible polygon", "whole frame"], rows)
    print("Published: 153 with one copy, 132 with 16 at stride 1; with both, stride 16 and one copy.\n")


def lanes(emulator, _arguments):
    """A lane draws a column, or none: fewer than 768 would show less of the screen."""
    rows = []
    for n in LANES:
        scene = (("topology.nodes", str(n)),)
        found, counted = array(emulator, scene), model(emulator, scene, "--processors", str(n))
        rows.append([n, "{:,}, {:,}".format(passes(found)[1], counted["stages"][0]["passes"]), f"{passes(found)[1] / counted['visible']:.2f}",
                     f"{100 * phase(found, 'communicate')['cycles_u'] / found['cycles_u']:.1f} %"])
    table(["lanes, teapot 9408", "passes: machine, model", "a visible polygon (published: about 1)", "share of the cycles"], rows)
