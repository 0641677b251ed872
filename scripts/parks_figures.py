# SPDX-License-Identifier: MIT
"""Parks' figures 15 to 25: what he published beside the same formula on these scenes, and beside emulated cycles."""

from collections import defaultdict

from measuring import table
from parks_machines import FIGURE_15, FIGURES, IDEAL, PUBLISHED, SCENES, THESIS, appendix_c, scene_arguments


def figure15(emulator, _arguments):
    rows = []
    runs = {}
    for machine, which, name, polygons, segments, area, cycles in FIGURE_15:
        if machine not in runs:
            runs[machine] = (appendix_c(emulator, machine, *scene_arguments("runway", 1), *THESIS)[0],
                             appendix_c(emulator, machine, *scene_arguments("runway", 1))[0])
        thesis, full = (run[name] for run in runs[machine])
        rows.append([f"{machine} {which}".strip(), polygons, full["polygons"], segments, full["charged_segments"], f"{area:.2f}",
                     f"{full['pixels'] / max(1, full['polygons']):.2f}", f"{cycles:,.0f}", f"{full['formula_u']:,.0f}",
                     f"{100 * (full['formula_u'] / cycles - 1):+.2f} %", f"{thesis['scene_u']:,}", f"{full['scene_u']:,}"])
    table(["processor", "polygons: published", "here", "segments: published", "here", "mean area: published", "here",
           "cycles: published", "formula here", "difference", "emulated, thesis' precision", "emulated, full"], rows)


def figures(emulator, _arguments):
    """The slowest processor by the thesis' formula, beside figures 16 to 25."""
    rows = defaultdict(list)
    for machine, published in PUBLISHED.items():
        ours = []
        for scene, frames in SCENES[1:4]:
            for frame in appendix_c(emulator, machine, *scene_arguments(scene, frames), *IDEAL):
                ours.append(max(node["formula_u"] for node in frame.values()) / 1e6)
        for there, here in zip(published, ours):
            rows[machine].append(f"{here:.2f} ({'-' if there is None else there})")
    names = [f"figure {FIGURES[scene, frame]}" for scene, frames in SCENES[1:4] for frame in range(frames)]
    table(["millions of cycles: here (published)", *names], [[machine, *cells] for machine, cells in rows.items()])
