# SPDX-License-Identifier: MIT
"""Stages and frames of the emulated Princeton Engine beside Eldridge's chapter 8."""

from itertools import product

from measuring import EmulatorError, table
from princeton_machine import BEST_STRIDE, CROWDED, SMALL, array, frame_figures, is_crowded, line_figures, machine_scenes, phase, stage_costs

PUBLISHED = {  # table 8.1: frames/s, polygons/s, shares of geometry, communication, rasterising
    "beethoven 5030": "10; 32,000 to 36,000; 8 to 9, 42 to 46, 45 to 50",
    "teapot 9408": "10; 43,000 to 44,000; 10 to 12, 52 to 55, 35 to 36",
    "teapot 34 440": "crocodile: 6; 49,800 to 62,400; 13, 57 to 69, 18 to 30",
    "head 37 629": "crocodile"}


def stages(emulator, _arguments):
    """The teapot's frame."""
    shaded, textured = (stage_costs(emulator, SMALL, kind) for kind in (False, True))
    print("### Cycles of an item\n")
    table(["item", "shaded", "textured", "Eldridge"],
          [["keep or reject a polygon", f"{shaded.transform:.0f}", f"{textured.transform:.0f}", "1000"],
           ["light a visible one, its linear equations", f"{shaded.light:.0f}", f"{textured.light:.0f}", "5000"],
           ["a pass of one place", f"{shaded.a_pass:.0f}", f"{textured.a_pass:.0f}", "(2 + 1) 42 + 30 = 156"],
           ["normalise a polygon", f"{shaded.normalise:.0f}", f"{textured.normalise:.0f}", "350"],
           ["look for the next polygon", shaded.look, textured.look, "in the next line"],
           ["a pixel", f"{shaded.sample:.1f}", f"{textured.sample:.1f}", "80 shaded, 202 textured"],
           ["a pixel with its share of looking", f"{shaded.sample + shaded.look / 8:.1f}", f"{textured.sample + textured.look / 4:.1f}", ""]])
    print("### Of a scanline of 910 cycles, line-locked\n")
    shaded, textured = (line_figures(emulator, SMALL, kind) for kind in (False, True))
    table(["items a scanline", "shaded", "textured", "Eldridge"],
          [["polygons kept or rejected", shaded.transformed, textured.transformed, "every polygon lit: 1/7 shaded, 1/11 textured"],
           ["visible ones lit", shaded.lit, textured.lit, ""],
           ["passes", shaded.passes, textured.passes, "5"],
           ["polygons normalised", shaded.normalised, textured.normalised, "2"],
           ["pixels", shaded.samples, textured.samples, "8 shaded, 4 textured"]])
    print("### Operations a bundle, lanes awake\n")
    found = array(emulator, SMALL)
    rows = [[name, phase(found, name)["cycles_u"], f"{phase(found, name)['operations_per_bundle']:.2f}", f"{100 * phase(found, name)['awake']:.1f} %"]
            for name in ("geometry", "communicate", "normalise", "rasterise")]
    table(["phase, shaded, not line-locked", "cycles", "operations a bundle", "lanes awake"],
          [*rows, ["all", found["cycles_u"], f"{found['operations_per_bundle']:.2f}", f"{100 * found['awake']:.1f} %"]])
    print("### Rasterising without the optimisations of 7.5\n")
    rows = []
    for title, options in (("as it is", {}), ("without early abort", {"early_abort": 0}), ("lanes wait for each other's polygons", {"decoupled": 0})):
        rows.append([title, phase(array(emulator, SMALL, **options), "rasterise")["cycles_u"]])
    table(["teapot, shaded", "cycles", "times"], [[title, cycles, f"{cycles / rows[0][1]:.2f}"] for title, cycles in rows])


def spread(values, shown="{:,}"):
    low, high = shown.format(min(values)), shown.format(max(values))
    return low if low == high else f"{low} to {high}"


def table_8_1(emulator, arguments):
    """From the least to the greatest of three sides; with the best stride, too, which his machine had not."""
    rows = []
    for name, scene in machine_scenes(arguments).items():
        for textured, stride in product((False, True), (1, BEST_STRIDE)):
            title = f"{name}, {'textured' if textured else 'shaded'}, stride {stride}"
            try:
                frames = frame_figures(emulator, scene, textured, stride=stride)
            except EmulatorError as error:
                if not is_crowded(error):
                    raise
                rows.append([title, CROWDED, *[""] * 9])
                continue
            rows.append([title, spread([frame.visible for frame in frames]),
                         spread([frame.slices for frame in frames]), spread([frame.pictures for frame in frames]),
                         spread([frame.a_second() for frame in frames], "{:.1f}"),
                         spread([frame.visible * frame.a_second() for frame in frames], "{:,.0f}"),
                         *(spread([100 * getattr(frame, part) for frame in frames], "{:.1f}")
                           for part in ("geometry", "communicate", "rasterise", "waiting")),
                         PUBLISHED[name] if stride == 1 else ""])
    table(["model", "visible", "most on a column", "pictures a frame", "frames/s", "visible polygons/s", "geometry %", "communication %",
           "rasterising %, waiting included", "waiting %", "published: frames/s, polygons/s, %"], rows)
