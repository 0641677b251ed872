# SPDX-License-Identifier: MIT
"""Parks' figures 15 to 25: what he published beside the same formula on these scenes, and beside emulated cycles."""

from measuring import table
from parks_machines import (FIGURE_15, FIGURES, IDEAL, PUBLISHED, SCENES, THESIS, appendix_c, scene_arguments)

NUMBERED = [FIGURES[scene, frame] for scene, frames in SCENES[1:4] for frame in range(frames)]  # "16" to "25"


def figure15_of(emulator, machine, *precision):
    """Appendix C of all processors of a machine by name, on figure 15's scene."""
    return appendix_c(emulator, machine, *scene_arguments("runway", 1), *precision)[0]


def slowest_by_formula(emulator, machine):
    """For every figure from 16 to 25: appendix C of the processor for which the thesis' formula gives most."""
    found = []
    for scene, frames in SCENES[1:4]:
        found += [max(frame.values(), key=lambda node: node["formula_u"])
                  for frame in appendix_c(emulator, machine, *scene_arguments(scene, frames), *IDEAL)]
    return dict(zip(NUMBERED, found))


def figure15(emulator, _arguments):
    rows = []
    for machine, which, name, polygons, segments, area, cycles in FIGURE_15:
        thesis, full = (figure15_of(emulator, machine, *precision)[name] for precision in (THESIS, []))
        rows.append([f"{machine} {which}".strip(), polygons, full["polygons"], segments, full["charged_segments"], f"{area:.2f}",
                     f"{full['pixels'] / max(1, full['polygons']):.2f}", f"{cycles:,.0f}", f"{full['formula_u']:,.0f}",
                     f"{100 * (full['formula_u'] / cycles - 1):+.2f} %", f"{thesis['scene_u']:,}", f"{full['scene_u']:,}"])
    table(["processor", "polygons: published", "here", "segments: published", "here", "mean area: published", "here",
           "cycles: published", "formula here", "difference", "emulated, thesis' precision", "emulated, full"], rows)


def figures(emulator, _arguments):
    """The slowest processor by the thesis' formula, beside figures 16 to 25."""
    rows = []
    for machine, published in PUBLISHED.items():
        here = slowest_by_formula(emulator, machine)
        rows.append([machine, *(f"{here[figure]['formula_u'] / 1e6:.2f} ({'-' if there is None else there})"
                                for figure, there in zip(NUMBERED, published))])
    table(["millions of cycles: here (published)", *(f"figure {figure}" for figure in NUMBERED)], rows)
