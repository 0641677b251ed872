# SPDX-License-Identifier: MIT
"""The thesis' formula against emulated cycles: he calls it nearly identical to the strict simulation."""

from collections import defaultdict
from statistics import mean, pstdev

from measuring import plot_figure, table
from parks_machines import IDEAL, MACHINES, SCENES, THESIS, appendix_c, scene_arguments


def formula(emulator, arguments):
    """Formula against emulation, every scene, frame and processor with work."""
    own = appendix_c(emulator, "uniprocessor", *scene_arguments("runway", 1))[0]["P0"]["own_costs_u"]
    errors = {"thesis' costs, thesis' precision": defaultdict(list), "own costs, full precision": defaultdict(list)}
    for machine in MACHINES:
        for scene, frames in SCENES:
            for precision, kinds in ((THESIS, "thesis' costs, thesis' precision"), ([], "own costs, full precision")):
                for frame in appendix_c(emulator, machine, *scene_arguments(scene, frames), *IDEAL, *precision):
                    for node in frame.values():
                        if node["polygons"] == 0:
                            continue
                        counts = [node[key] for key in ("polygons", "vertices", "charged_segments", "pixels")]
                        expected = node["formula_u"] if precision else sum(
                            count * cost for count, cost in zip(counts, own.values()))
                        errors[kinds][machine].append(expected / node["scene_u"] - 1)
    rows = []
    for kind, machines in errors.items():
        for machine, found in machines.items():
            found = sorted(found)
            rows.append([kind, machine, len(found), f"{100 * mean(found):+.1f}", f"{100 * pstdev(found):.1f}", f"{100 * found[0]:+.1f}",
                         f"{100 * found[len(found) // 2]:+.1f}", f"{100 * found[-1]:+.1f}"])
    table(["formula with", "machine", "processors x frames", "mean error, %", "deviation, %", "least", "median", "greatest"], rows)
    if arguments.plots:
        def draw(axes):
            for kind, machines in errors.items():
                axes.hist([100 * error for found in machines.values() for error in found], bins=80, alpha=0.6, label=kind)
        plot_figure(arguments.plots / "parks-formula.png", draw, "Parks' formula against emulated cycles, every processor of every machine and scene",
                    "error of the formula, %", "processors")
