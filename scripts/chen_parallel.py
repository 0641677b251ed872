# SPDX-License-Identifier: MIT
"""Many hardware rasterizers: speed-up over one that draws untiled, against the tile's side and the way in which tiles are assigned."""

from chen_machine import UNTILED, draw_cycles, inefficiency, save, size_axis, sweep
from chen_scenes import TILES, overlap_factor, stand_ins, synthetics
from measuring import table

COUNTS = (1, 2, 4, 8, 16, 32, 64)
WAYS = {"interleaved": {}, "blocks": {"sorter.assignment": "blocks"}, "next free": {"sorter.assignment": "next_free"},
        "largest first, triangles": {"sorter.assignment": "largest_first"},
        "largest first, work": {"sorter.assignment": "largest_first", "sorter.largest_by": "work"}}
IN_FULL = ("Quake", "game level")


class Study:
    """Speed-up and imbalance by scene, way, side of the tile and count of rasterizers."""

    def __init__(self, emulator, scenes):
        self.untiled = {name: draw_cycles(emulator, scene, UNTILED) for name, scene in scenes.items()}
        vary = {"topology.tile": TILES, "topology.rasterizers": COUNTS}
        self.points = {way: sweep(emulator, scenes, vary | {key: [value] for key, value in changes.items()}) for way, changes in WAYS.items()}

    def point(self, name, way, tile, count):
        return self.points[way](name, tile, count, *WAYS[way].values())

    def speed_up(self, name, way, tile, count):
        return self.untiled[name] / int(self.point(name, way, tile, count)["draw_u"])

    def imbalance(self, name, way, tile, count):
        return float(self.point(name, way, tile, count)["imbalance"])

    def best(self, name, way, count):
        """Side of the tile; of equals the smallest."""
        return max(TILES, key=lambda tile: self.speed_up(name, way, tile, count))


def in_full(study, emulator, name, scene):
    print(f"### {name}: speed-up (busiest rasterizer over the mean)\n")
    rows = [[way, tile, f"{overlap_factor(emulator, scene, tile):.1f}", f"{inefficiency(emulator, scene, tile):.3f}",
             *(f"{study.speed_up(name, way, tile, count):.2f} ({study.imbalance(name, way, tile, count):.2f})" for count in COUNTS)]
            for way in WAYS for tile in TILES]
    table(["assignment", "tile", "overlap", "R", *COUNTS], rows)


def best_tiles(study, scenes):
    print("### Best tile: its side (speed-up)\n")
    rows = []
    for name in scenes:
        for way in WAYS:
            best = {count: study.best(name, way, count) for count in COUNTS}
            rows.append([name, way, *(f"{tile} ({study.speed_up(name, way, tile, count):.2f})" for count, tile in best.items())])
    table(["scene", "assignment; rasterizers", *COUNTS], rows)


def draw_trade(study, emulator, name, scene, axes):
    most = COUNTS[-1]
    for way in WAYS:
        axes.plot(TILES, [study.speed_up(name, way, tile, most) for tile in TILES], "o-", label=way)
    axes.plot(TILES, [most / inefficiency(emulator, scene, tile) for tile in TILES], "k:", label=f"{most} / R: perfect balance")
    size_axis(axes, TILES)
    axes.set_ylim(0, 1.6 * most)  # for the legend


def parallel(emulator, arguments):
    scenes = synthetics() | stand_ins(arguments.models)
    study = Study(emulator, scenes)
    best_tiles(study, scenes)
    for name in IN_FULL:
        if name in scenes:
            in_full(study, emulator, name, scenes[name])
    for name, file in zip(IN_FULL, ("parallel", "parallel-level")):
        if name in scenes:
            save(arguments, file, lambda axes: draw_trade(study, emulator, name, scenes[name], axes), f"{name} on {COUNTS[-1]} hardware rasterizers, FIFO 1",
                 "side of a tile, pixels", "speed-up over one, untiled")
