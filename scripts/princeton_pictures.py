# SPDX-License-Identifier: MIT
"""Pictures of the emulated Princeton Engine beside the reference renderer's."""

import re
import tempfile
from pathlib import Path

from measuring import plot_pictures, table
from princeton_machine import CONFIG, SMALL, changes_of, machine_scenes, textured_scene


def compared(emulator, out, scene):
    """Shares of all pixels, and of the object's, that are within two levels of the reference's."""
    text = emulator.run_into(out, CONFIG, "--compare", *changes_of(scene))
    return re.search(r"Frame 0 +([0-9.]+) % of all pixels and ([0-9.]+) % of the object's", text).groups()


def pictures(emulator, arguments):
    """With --plots DIR: the teapot, shaded and textured, side by side as princeton-teapot.png."""
    import matplotlib.image
    rows, drawn = [], []
    for name, scene in machine_scenes(arguments).items():
        for textured in (False, True):
            with tempfile.TemporaryDirectory() as folder:
                out = Path(folder) / "out"
                rows.append([f"{name}, {'textured' if textured else 'shaded'}", *compared(emulator, out, textured_scene(scene, textured))])
                if scene == SMALL:
                    drawn.append(matplotlib.image.imread(out / "frame-000.png"))
    table(["first frame", "% of all pixels within 2 levels of the reference", "% of the object's"], rows)
    if arguments.plots:
        plot_pictures(arguments.plots / "princeton-teapot.png", drawn)
