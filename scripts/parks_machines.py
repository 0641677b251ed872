# SPDX-License-Identifier: MIT
"""Machines, scenes and published figures that the tables about Parks' machines share, and how they are run."""

from measuring import setting

SIZES = (4, 16, 64, 256)
MACHINES = ["uniprocessor", *(f"{kind}{size}" for size in SIZES for kind in ("splitter", "interlace")), "hybrid16", "hybrid64"]
# Scene, frames along its path; Parks' figures 15, 16 to 21, 22 and 23, 24 and 25, and Parke's assumption.
SCENES = [("runway", 1), ("airport", 6), ("shuttle_profile", 2), ("cargo_bay", 2), ("random_polygons", 1)]
FIGURES = {("runway", 0): "15", **{("airport", i): str(16 + i) for i in range(6)},
           ("shuttle_profile", 0): "22", ("shuttle_profile", 1): "23", ("cargo_bay", 0): "24", ("cargo_bay", 1): "25"}
# Parks 1982, figure 15 and appendix C: machine, processor there, name here, polygons, segments, mean area, cycles.
FIGURE_15 = [
    ("uniprocessor", "", "P0", 248, 1411, 1013.00, 5766526.5),
    ("splitter4", "no. 1, slowest", "P1", 72, 668, 1571.31, 2543412.5),
    ("interlace4", "no. 2, slowest", "P2", 248, 738, 253.00, 1702129.0),
    ("splitter16", "no. 1, slowest", "P1", 2, 256, 16384.00, 731408.4),
    ("splitter16", "no. 7, shuttle's", "P7", 51, 312, 411.18, 541457.1),
    ("interlace16", "no. 3, slowest", "P3", 248, 442, 63.97, 670881.3),
    ("interlace16", "no. 8, fastest", "P8", 248, 434, 62.85, 663800.3),
    ("hybrid16", "lower right no. 3, slowest", "P7", 72, 360, 392.99, 713129.1),
]
# Legible cycles of figures 16 to 25, in millions.
PUBLISHED = {
    "uniprocessor": [3.95, 3.19, 3.91, 3.75, 5.49, 5.83, 3.32, 3.17, 6.80, 6.71],
    "interlace4": [1.32, 1.30, 1.42, None, 1.99, 1.95, 1.24, 1.18, 2.01, 2.02],
    "splitter4": [1.69, 1.80, 1.85, None, 2.87, None, 2.10, 2.21, 1.97, 1.83],
    "interlace16": [.653, None, .791, .761, None, None, .620, .569, .703, .720],
    "splitter16": [.592, .749, .629, 1.06, .905, 1.14, 1.07, .743, .658, .653],
    "hybrid16": [.594, .681, .658, .94, .992, None, None, .528, .634, .587],
}
THESIS = setting(nodes__symbols="{full: 0, skip_deltas: 0}")
IDEAL = setting(fabric__ideal="true")


def scene_arguments(scene, frames):
    return [*setting(scene__object=scene), "--frames", str(frames)]


def appendix_c(emulator, machine, *arguments):
    """Of every frame, of every processor by name: the statistics of appendix C."""
    records = {}
    emulator.run(machine, "--appendix-c", *arguments, records=records)
    report = records["appendix-c.json"]
    return [{node["name"]: node["frames"][frame] for node in report["nodes"]} for frame in range(report["frames"])]


def frame_cycles(emulator, machine, *arguments):
    """Of every frame: its time in cycles."""
    statistics, _ = emulator.run(machine, *arguments)
    return [frame["duration_u"] for frame in statistics["frames"]]
