# SPDX-License-Identifier: MIT
"""What a polygon, a vertex, a segment and a pixel cost the tiler, beside the thesis' figures: by profile of the runway scene, and by regression
over random scenes. The thesis has one program for all machines; here a processor whose pixels lie side by side does without the corrections
of an interlace, so that machines differ."""

import math
import tempfile
from pathlib import Path

import numpy

from measuring import setting, table

THESIS = {"polygon": 139, "vertex": 319.3, "segment": 158, "pixel": 21}
PROGRAMS = [(f"{precision}{', skipping deltas' if skip else ''}", full, skip)
            for full, precision in enumerate(("thesis", "full")) for skip in (0, 1)]
PROFILED = ("uniprocessor", "splitter16", "interlace4", "interlace16", "hybrid16")
FITTED = ("uniprocessor", "interlace16")

# Scenes for the regression: each mixes polygons up to its own number of corners and its own radius, or vertices, segments and pixels could not
# be told apart.
SCENES = 60
SCREEN = 512
LEAST_RADIUS, GREATEST_RADIUS = 6, 64


def program(full, skip, **values):
    return setting(nodes__symbols=f"{{full: {full}, skip_deltas: {skip}}}", **values)


def appendix_c(emulator, config, *arguments):
    records = {}
    emulator.run(config, "--appendix-c", *arguments, records=records)
    return records["appendix-c.json"]["all_nodes"], records["appendix-c"]


def against(cost, thesis):
    return f"{cost:.1f} ({100 * (cost / thesis - 1):+.0f} %)"


def by_profile(emulator):
    rows = []
    for name, full, skip in PROGRAMS:
        for machine in PROFILED:
            found, processors = profile(emulator, machine, full, skip)
            errors = [100 * float(row["formula_error"]) for row in processors if int(row["scene_u"]) > 0]
            rows.append([name, machine, *(against(found["own_costs_u"][item], THESIS[item]) for item in THESIS), found["scene_u"],
                         f"{100 * found['formula_error']:+.1f}", f"{min(errors):+.1f} to {max(errors):+.1f}"])
    table(["program", "machine", *(f"a {item}" for item in THESIS), "all processors' cycles", "formula's error, %", "one processor's, %"],
          rows)


def profile(emulator, machine, full, skip, **values):
    """Appendix C of the runway scene: of all processors together, and a row a processor."""
    return appendix_c(emulator, machine, *program(full, skip, scene__object="runway", **values))


def by_pixel(emulator):
    rows = []
    for name, full, skip in PROGRAMS:
        for autoincrement in (1, 0):
            costs_of_pixels = profile(emulator, "uniprocessor", full, skip, nodes__cost__autoincrement=autoincrement)[0]["pixel_costs_u"]
            rows.append([name, autoincrement, *(f"{costs_of_pixels[kind]:.2f}" for kind in ("drawn", "hidden", "run"))])
    rows += [["thesis' listing", 1, 21, 17, "-"], ["thesis' listing", 0, 19, 15, "-"]]
    table(["program", "an auto-increment costs", "a pixel drawn", "hidden", "a run of pixels"], rows)


def write_scene(path, random):
    """Polygons with corners on circles, anywhere; rounding may divide a few of them."""
    most = random.integers(3, 11)
    scale = math.exp(random.uniform(math.log(LEAST_RADIUS), math.log(GREATEST_RADIUS)))
    lines = []
    for _ in range(random.integers(20, 200)):
        corners = random.integers(1, most + 1)
        radius = max(2, int(scale * random.uniform(0.1, 1)))
        x, y = random.integers(radius, SCREEN - radius, 2)
        z, grey, turn = random.integers(0, 30000), random.integers(0, 256), random.uniform(0, 2 * math.pi)
        lines.append("polygon")
        for corner in range(corners):
            angle = turn + 2 * math.pi * corner / corners
            lines.append(f"{round(x + (radius - 1) * math.cos(angle))} {round(y + (radius - 1) * math.sin(angle))} {z + corner} {grey}")
    path.write_text("\n".join(lines) + "\n")


def column(equations, name):
    return numpy.array([float(row[name]) for row in equations])


def regression(equations):
    """A vertex, a segment and a pixel by least squares of the relative error, and the errors left. A polygon's own cost, below 1 % of the
    cycles, is lost in theirs: it is taken as the profile has it."""
    cycles = column(equations, "scene_u")
    polygon = column(equations, "polygon_u").sum() / column(equations, "polygons").sum()
    rest = cycles - polygon * column(equations, "polygons")
    counts = numpy.column_stack([column(equations, name) for name in ("vertices", "segments", "pixels")])
    found, _, _, _ = numpy.linalg.lstsq(counts / cycles[:, None], rest / cycles, rcond=None)
    return [polygon, *found], (counts @ found - rest) / cycles


def by_section(equations):
    return [column(equations, f"{item}_u").sum() / column(equations, items).sum()
            for item, items in zip(THESIS, ("polygons", "vertices", "segments", "pixels"))]


def by_regression(emulator):
    rows = []
    random = numpy.random.default_rng(1)
    with tempfile.TemporaryDirectory() as folder:
        scenes = [Path(folder) / f"{number}.polygons" for number in range(SCENES)]
        for scene in scenes:
            write_scene(scene, random)
        for name, full, skip in PROGRAMS:
            for machine in FITTED:
                equations = [row for scene in scenes
                             for row in appendix_c(emulator, machine, *program(full, skip, scene__object=scene))[1]]
                found, errors = regression(equations)
                rows.append([name, machine, *(f"{fit:.1f} ({profile:.1f})" for fit, profile in zip(found, by_section(equations))), len(equations),
                             f"{100 * numpy.sqrt(numpy.mean(errors ** 2)):.2f}", f"{100 * numpy.abs(errors).max():.2f}"])
    table(["program", "machine", *(f"a {item} (by profile)" for item in THESIS), "equations", "error left, % rms", "greatest, %"], rows)


def costs(emulator, _arguments):
    print("Cycles by profile, runway scene (thesis: 139, 319.3, 158, 21):\n")
    by_profile(emulator)
    print("The pixel loop, runway scene, uniprocessor:\n")
    by_pixel(emulator)
    print(f"Cycles by regression over {SCENES} random scenes of 20 to 200 polygons with 1 to 10 corners and radii to {GREATEST_RADIUS} pixels; a "
          f"processor of a scene is an equation:\n")
    by_regression(emulator)
