# SPDX-License-Identifier: MIT
"""Who wins at 4, 16, 64 and 256 processors, what an interlace processor spends on overhead, and how far a small move of the viewer swings them."""

from measuring import plot_figure, setting, table
from parks_machines import FIGURES, IDEAL, SCENES, SIZES, appendix_c, frame_cycles, scene_arguments

PATH = 120  # frames along the approach


def kinds_of(size):
    return ["splitter", "interlace", *(["hybrid"] if size in (16, 64) else [])]


def by_formula(emulator, machine, *arguments):
    """Of every frame: the thesis' formula on the counts of the processor for which it gives most."""
    return [max(node["formula_u"] for node in frame.values()) for frame in appendix_c(emulator, machine, *arguments, *IDEAL)]


def on_ideal_fabric(emulator, machine, *arguments):
    return frame_cycles(emulator, machine, *arguments, *IDEAL)


def winner_of(emulator, figure, size=16, ideal=True, formula=True):
    """"s" if the splitter takes less time for a figure of the thesis than the interlace, "i" if not."""
    scene, frame = next(place for place, name in FIGURES.items() if name == figure)
    arguments = scene_arguments(scene, dict(SCENES)[scene])
    cycles_of = by_formula if formula else on_ideal_fabric if ideal else frame_cycles
    times = {kind: cycles_of(emulator, f"{kind}{size}", *arguments)[frame] for kind in ("splitter", "interlace")}
    return "s" if times["splitter"] < times["interlace"] else "i"


def winners(emulator, _arguments):
    for title, cycles_of in (("real fabric", frame_cycles), ("ideal fabric", on_ideal_fabric),
                             ("by the thesis' formula, which leaves the fabric out", by_formula)):
        print(f"Frame time in millions of cycles, {title}; the least in bold.\n")
        rows = []
        for scene, frames in SCENES:
            times = {(kind, size): cycles_of(emulator, f"{kind}{size}", *scene_arguments(scene, frames))
                     for size in SIZES for kind in kinds_of(size)}
            rows += [[FIGURES.get((scene, frame), scene), *(least_in_bold([times[kind, size][frame] for kind in kinds_of(size)])
                                                            for size in SIZES)] for frame in range(frames)]
        table(["figure or scene", *(f"{size}: {', '.join(kinds_of(size))}" for size in SIZES)], rows)


def least_in_bold(cycles):
    return ", ".join(f"**{c / 1e6:.3f}**" if c == min(cycles) else f"{c / 1e6:.3f}" for c in cycles)


def overhead_of(emulator, machine, scene, frames):
    """Of the slowest processor of every frame: per cent of polygon and vertex time, by the thesis' formula and emulated."""
    counted, emulated = [], []
    for frame in appendix_c(emulator, machine, *scene_arguments(scene, frames), *IDEAL):
        slowest = max(frame.values(), key=lambda node: node["formula_u"])
        counted.append(100 * (139 * slowest["polygons"] + 319.3 * slowest["vertices"]) / slowest["formula_u"])
        slowest = max(frame.values(), key=lambda node: node["scene_u"])
        emulated.append(100 * (slowest["cycles_u"]["polygon"] + slowest["cycles_u"]["vertex"]) / slowest["scene_u"])
    return counted, emulated


def overhead(emulator, _arguments):
    """Of the slowest interlace processor: polygon and vertex time, by the thesis' formula and emulated."""
    table(["interlace of", "scene", "polygon and vertex time by the formula, %, a frame", "emulated, %"],
          [[size, scene, *(" ".join(f"{share:.0f}" for share in found) for found in overhead_of(emulator, f"interlace{size}", scene, frames))]
           for size in SIZES for scene, frames in SCENES])


def greatest_change(values, width):
    """In per cent, between places `width` apart."""
    return max(100 * (max(a, b) / min(a, b) - 1) for a, b in zip(values, values[width:]))


def swing(emulator, arguments):
    """Frame time along the approach, and by how much it changes from one frame to the next."""
    curves = {}
    for machine in ("uniprocessor", "splitter16", "interlace16", "hybrid16"):
        for name, settings in (("ideal", IDEAL), ("real", [])):
            curves[machine, name] = frame_cycles(emulator, machine, *scene_arguments("airport", PATH), *settings)
    rows = []
    for (machine, name), cycles in curves.items():
        share = [a / b for a, b in zip(cycles, curves["uniprocessor", name])]
        rows.append([machine, name, f"{min(cycles) / 1e6:.3f} to {max(cycles) / 1e6:.3f}",
                     *(f"{greatest_change(values, width):.1f}" for width in (1, PATH // 24, PATH // 5) for values in (cycles, share))])
    table(["machine", "fabric", "frame time, millions of cycles",
           *(f"greatest change over 1/{PATH // width} of the path, %: of the {what}" for width in (1, PATH // 24, PATH // 5)
             for what in ("frame time", "share of the uniprocessor's"))], rows)
    if arguments.plots:
        def times(axes):
            for (machine, name), cycles in curves.items():
                if machine != "uniprocessor" and name == "ideal":
                    axes.plot([frame / (PATH - 1) for frame in range(PATH)], [c * 3e-7 for c in cycles], label=machine)
        plot_figure(arguments.plots / "parks-approach.png", times, "Frame time along the approach (compare Parks 1982, figures 28 and 31)",
                    "place on the path", "seconds at 300 ns a cycle")

        def shares(axes):
            whole = curves["uniprocessor", "ideal"]
            for machine in ("splitter16", "interlace16", "hybrid16"):
                axes.plot([frame / (PATH - 1) for frame in range(PATH)],
                          [100 * a / b for a, b in zip(curves[machine, "ideal"], whole)], label=machine)
        plot_figure(arguments.plots / "parks-approach-share.png", shares,
                    "Frame time as a share of the uniprocessor's (compare Parks 1982, figures 29 and 30)", "place on the path", "%")


WINNERS_TABLES = {"winners": winners, "overhead": overhead, "swing": swing}
