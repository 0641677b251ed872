# SPDX-License-Identifier: MIT
"""What the thesis could not see: where the real tree and bus fall behind the ideal."""

from measuring import plot_figure, setting, table
from parks_machines import IDEAL, frame_cycles, scene_arguments

FRAMES = 6
CLOSE = 4  # the frame that stands for figure 20
DEPTHS = (1, 2, 4, 8, 16, 32, 64, 128, 256)
VERTEX_TIMES = ("0ns", "300ns", "600ns", "1200ns", "2400ns", "5us", "10us", "20us", "50us", "100us")
MACHINES = ("splitter16", "splitter64", "splitter256", "interlace16", "interlace64", "interlace256", "hybrid64")


def close_up(emulator, machine, *settings):
    """Cycles of figure 20's scene."""
    return frame_cycles(emulator, machine, *scene_arguments("airport", FRAMES), *settings)[CLOSE]


def fifo_settings(depth):
    return setting(fabric__processor_fifo=depth, fabric__splitter__input_fifo=depth, fabric__splitter__output_fifo=depth,
                   fabric__polygon_bus__input_fifo=depth)


def depth(emulator, arguments):
    ideal = {machine: close_up(emulator, machine, *IDEAL) for machine in MACHINES}
    curves = {machine: [close_up(emulator, machine, *fifo_settings(places)) / ideal[machine] for places in DEPTHS]
              for machine in MACHINES}
    table(["frame time over the ideal machine's; FIFO of", *DEPTHS],
          [[machine, *(f"{ratio:.2f}" for ratio in ratios)] for machine, ratios in curves.items()])
    if arguments.plots:
        def draw(axes):
            for machine, ratios in curves.items():
                axes.plot(DEPTHS, ratios, marker=".", label=machine)
            axes.set_xscale("log", base=2)
        plot_figure(arguments.plots / "parks-fifo.png", draw, "Frame time against FIFO depth, close to the runway (figure 20)",
                    "places in every FIFO, polygons", "times the ideal machine's")


def splitter(emulator, arguments):
    machines = [machine for machine in MACHINES if not machine.startswith("interlace")]
    ideal = {machine: close_up(emulator, machine, *IDEAL) for machine in machines}
    curves = {machine: [close_up(emulator, machine, *setting(fabric__splitter__time_per_vertex=time)) / ideal[machine]
                        for time in VERTEX_TIMES] for machine in machines}
    table(["frame time over the ideal machine's; splitter's time a vertex", *VERTEX_TIMES],
          [[machine, *(f"{ratio:.2f}" for ratio in ratios)] for machine, ratios in curves.items()])
    if arguments.plots:
        def draw(axes):
            for machine, ratios in curves.items():
                axes.plot(range(len(VERTEX_TIMES)), ratios, marker=".", label=machine)
            axes.set_xticks(range(len(VERTEX_TIMES)), VERTEX_TIMES, fontsize=7)
        plot_figure(arguments.plots / "parks-splitter.png", draw, "Frame time against the splitters' speed, close to the runway (figure 20)",
                    "time a vertex", "times the ideal machine's")


def order(emulator, arguments):
    orders = ("mesh", "sorted", "shuffled")
    rows = []
    bars = {}
    for machine in MACHINES:
        ideal = close_up(emulator, machine, *IDEAL)
        bars[machine] = [close_up(emulator, machine, *setting(host__order=name)) / ideal for name in orders]
        rows.append([machine, *(f"{ratio:.3f}" for ratio in bars[machine])])
    table(["frame time over the ideal machine's; polygons in order", *orders], rows)
    if arguments.plots:
        def draw(axes):
            for i, name in enumerate(orders):
                axes.bar([place + 0.27 * i for place in range(len(bars))], [ratios[i] for ratios in bars.values()], 0.25, label=name)
            axes.set_xticks([place + 0.27 for place in range(len(bars))], bars, fontsize=7)
        plot_figure(arguments.plots / "parks-order.png", draw, "Frame time against the order of polygons, close to the runway (figure 20)",
                    "machine", "times the ideal machine's")


def bus(emulator, _arguments):
    """The frame-buffer bus, which the thesis takes as free."""
    rows = []
    for machine in ("uniprocessor", "splitter16", "interlace16", "interlace64"):
        local = close_up(emulator, machine)
        rows.append([machine, f"{local / 1e6:.3f}",
                     *(f"{close_up(emulator, machine, *setting(fabric__frame_buffer='bus', fabric__frame_buffer_bus__time_per_pixel=time)) / local:.2f}"
                       for time in ("50ns", "100ns", "300ns", "1us"))])
    table(["machine", "local frame buffers, millions of cycles", *(f"times as long over a bus, {time} a pixel" for time in
                                                              ("50ns", "100ns", "300ns", "1us"))], rows)


def variants(emulator, _arguments):
    """The thesis' further research: half-digested broadcast, and no delta divisions that nobody needs."""
    rows = []
    for machine in ("interlace4", "interlace16", "interlace64", "interlace256"):
        for scene, frames, frame in (("runway", 1, 0), ("airport", 6, 2)):  # figures 15 and 18
            def cycles(*settings):
                return frame_cycles(emulator, machine, *scene_arguments(scene, frames), *settings)[frame]
            plain = cycles()
            skipping = cycles(*setting(nodes__symbols="{skip_deltas: 1}"))
            digested = cycles(*setting(fabric__half_digested="true"))
            rows.append([machine, "15" if scene == "runway" else "18", f"{plain / 1e6:.3f}", f"{100 * (skipping / plain - 1):+.1f}",
                         f"{100 * (digested / plain - 1):+.1f}"])
    table(["machine", "figure", "millions of cycles", "skipping divisions, %", "half-digested broadcast, %"], rows)


FABRIC_TABLES = {"depth": depth, "splitter": splitter, "order": order, "bus": bus, "variants": variants}
