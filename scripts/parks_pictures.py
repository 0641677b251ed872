# SPDX-License-Identifier: MIT
"""Whether every machine draws the uniprocessor's picture."""

import tempfile
from pathlib import Path

import numpy

from measuring import plot_pictures, table
from parks_machines import FIGURES, MACHINES, SCENES, scene_arguments

# A pixel's grey may be off by so much more than what the uniprocessor has in the 3 x 3 pixels around.
SHADING = 2


def frames_of(emulator, machine, scene, frames):
    import matplotlib.image
    with tempfile.TemporaryDirectory() as folder:
        emulator.text("run", f"configs/{machine}.yaml", "--quiet", "--out", f"{folder}/out", *scene_arguments(scene, frames))
        pictures = [matplotlib.image.imread(f"{folder}/out/frame-{frame:03}.png") for frame in range(frames)]
    return [numpy.rint(255 * picture).astype(int) for picture in pictures]


def beyond_rounding(picture, whole):
    """Pixels that no pixel of the uniprocessor's picture within one pixel's distance explains."""
    height, width = whole.shape
    padded = numpy.pad(whole, 1, mode="edge")
    around = numpy.stack([padded[dy:dy + height, dx:dx + width] for dy in range(3) for dx in range(3)])
    return int(((picture < around.min(0) - SHADING) | (picture > around.max(0) + SHADING)).sum())


SHEET = [("runway", 0), ("airport", 4), ("shuttle_profile", 0), ("cargo_bay", 0)]


def pictures(emulator, arguments):
    rows = []
    sheet = {}
    for scene, frames in SCENES:
        whole = frames_of(emulator, "uniprocessor", scene, frames)
        found = {machine: frames_of(emulator, machine, scene, frames) for machine in MACHINES[1:]}
        for frame in range(frames):
            sheet[scene, frame] = whole[frame]
            cells = []
            for machine in MACHINES[1:]:
                differing = int((found[machine][frame] != whole[frame]).sum())
                shades = int((abs(found[machine][frame] - whole[frame]) > SHADING).sum())
                beyond = beyond_rounding(found[machine][frame], whole[frame])
                cells.append("same" if differing == 0 else
                             f"{100 * differing / whole[frame].size:.3f} ({100 * shades / whole[frame].size:.3f}), {beyond}")
            rows.append([FIGURES.get((scene, frame), scene), *cells])
    print(f"Pixels that differ, % (by more than {SHADING} grey levels, %), and how many a pixel's distance does not explain.\n")
    table(["figure or scene", *MACHINES[1:]], rows)
    if arguments.plots:
        plot_pictures(arguments.plots / "parks-scenes.png", [sheet[place] for place in SHEET])
