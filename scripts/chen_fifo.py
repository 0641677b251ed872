# SPDX-License-Identifier: MIT
"""Where buffering between the units of a hardware rasterizer pays."""

from chen_machine import UNLIMITED, UNTILED, save, sweep
from chen_scenes import synthetics
from measuring import table

DEPTHS = (0, 1, 2, 4, 8, 16, 64, 256, UNLIMITED)
SIDES = (8, 16, 32)
NEAR = 1.05  # of the time with an unlimited FIFO


def shown(tile):
    return "untiled" if tile == UNTILED else f"{tile} x {tile}"


def fifo(emulator, arguments):
    scenes, tiles = synthetics(), (*SIDES, UNTILED)
    points = sweep(emulator, scenes, {"topology.tile": tiles, "rasterizer.fifo": DEPTHS})

    def cycles(name, tile, depth):
        return int(points(name, tile, depth)["draw_u"])

    def over_unlimited(name, tile):
        return [cycles(name, tile, depth) / cycles(name, tile, UNLIMITED) for depth in DEPTHS]

    def enough(name, tile):
        return next(depth for depth, times in zip(DEPTHS, over_unlimited(name, tile)) if times <= NEAR)

    table(["scene", "time over that with an unlimited FIFO; tile", *DEPTHS, f"enough for {NEAR:g}"],
          [[name, shown(tile), *(f"{times:.3f}" for times in over_unlimited(name, tile)), enough(name, tile)] for name in scenes for tile in tiles])
    table(["scene", "R, both with the same FIFO; tile", *DEPTHS],
          [[name, shown(tile), *(f"{cycles(name, tile, depth) / cycles(name, UNTILED, depth):.3f}" for depth in DEPTHS)] for name in scenes for tile in SIDES])

    def draw(axes):
        for i, name in enumerate(scenes):
            for tile, line in zip((SIDES[0], UNTILED), ("o-", "s:")):
                axes.plot(range(len(DEPTHS)), over_unlimited(name, tile), line, color=f"C{i}", label=f"{name}, {shown(tile)}")
        axes.set_xticks(range(len(DEPTHS)), map(str, DEPTHS))

    save(arguments, "fifo", draw, "Hardware rasterizer: time over that with an unlimited FIFO", "triangles in the FIFO", "times")
