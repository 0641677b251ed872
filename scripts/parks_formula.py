# SPDX-License-Identifier: MIT
"""The thesis' formula against emulated cycles: he calls it nearly identical to the strict simulation."""

from statistics import mean, pstdev

from measuring import plot_figure, table
from parks_machines import IDEAL, MACHINES, SCENES, THESIS, appendix_c, scene_arguments

KINDS = {"thesis' costs, thesis' precision": THESIS, "own costs, full precision": []}
BINS = 80


def formula_errors(emulator, machine, kind):
    """Formula over emulated cycles, less one: every scene, frame and processor with work."""
    own = appendix_c(emulator, "uniprocessor", *scene_arguments("runway", 1))[0]["P0"]["own_costs_u"]

    def expected(node):
        if KINDS[kind]:
            return node["formula_u"]
        return sum(node[key] * cost for key, cost in zip(("polygons", "vertices", "charged_segments", "pixels"), own.values()))

    return [expected(node) / node["scene_u"] - 1 for scene, frames in SCENES
            for frame in appendix_c(emulator, machine, *scene_arguments(scene, frames), *IDEAL, *KINDS[kind])
            for node in frame.values() if node["polygons"] > 0]


def formula(emulator, arguments):
    errors = {kind: {machine: sorted(formula_errors(emulator, machine, kind)) for machine in MACHINES} for kind in KINDS}
    rows = []
    for kind, machines in errors.items():
        for machine, found in machines.items():
            rows.append([kind, machine, len(found), f"{100 * mean(found):+.1f}", f"{100 * pstdev(found):.1f}", f"{100 * found[0]:+.1f}",
                         f"{100 * found[len(found) // 2]:+.1f}", f"{100 * found[-1]:+.1f}"])
    table(["formula with", "machine", "processors x frames", "mean error, %", "deviation, %", "least", "median", "greatest"], rows)
    if arguments.plots:
        together = {kind: [100 * error for found in machines.values() for error in found] for kind, machines in errors.items()}
        least, greatest = min(map(min, together.values())), max(map(max, together.values()))

        def draw(axes):
            for kind, found in together.items():
                axes.hist(found, bins=BINS, range=(least, greatest), alpha=0.6, label=kind)

        plot_figure(arguments.plots / "parks-formula.png", draw, "Parks' formula against emulated cycles, every processor of every machine and scene",
                    f"error of the formula, % ({BINS} bins of the same width)", "processors")
