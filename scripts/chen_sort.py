# SPDX-License-Identifier: MIT
"""What the sorter's own time adds to R, which Chen's paper takes as nothing: it sorts a frame before anything of it is drawn."""

from chen_machine import UNTILED, draw_cycles, save, sweep
from chen_scenes import synthetics
from measuring import table

CYCLES = (0, 1, 5, 25)
CYCLE = 10  # ns, of bucket-hardware
SIDES = (8, 32)
OF_WHAT = {"triangle": "sorter.time_per_triangle", "pair": "sorter.time_per_pair"}


def sort(emulator, arguments):
    scenes = synthetics()
    times = {cycles: f"{CYCLE * cycles}ns" for cycles in CYCLES}
    points = {what: sweep(emulator, scenes, {"topology.tile": SIDES, key: list(times.values())}) for what, key in OF_WHAT.items()}

    def with_sorting(name, tile, what, cycles):
        """Over the untiled frame, which needs no sorter."""
        tiled = points[what](name, tile, times[cycles])
        return (int(tiled["sort_u"]) + int(tiled["draw_u"])) / draw_cycles(emulator, scenes[name], UNTILED)

    table(["scene", "R with sorting: tile", *(f"{cycles} cycles a {what}" for what in OF_WHAT for cycles in CYCLES)],
          [[name, f"{tile} x {tile}", *(f"{with_sorting(name, tile, what, cycles):.3f}" for what in OF_WHAT for cycles in CYCLES)]
           for name in scenes for tile in SIDES])

    def draw(axes):
        for i, name in enumerate(scenes):
            for tile, line, label in zip(SIDES, ("o-", "s:"), (name, None)):
                axes.plot(CYCLES, [with_sorting(name, tile, "pair", cycles) for cycles in CYCLES], line, color=f"C{i}", label=label)
        axes.plot([], [], "ks:", label=f"{SIDES[1]} x {SIDES[1]}")

    save(arguments, "sort", draw, f"R with a sorter that takes its time, tiles of {SIDES[0]} x {SIDES[0]} and {SIDES[1]} x {SIDES[1]}",
         "cycles a (triangle, tile) pair", "R, sorting included")
