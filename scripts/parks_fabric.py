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


def order_ratio(emulator, machine, name):
    """Frame time with the polygons in an order over the ideal machine's."""
    return close_up(emulator, machine, *setting(host__order=name)) / close_up(emulator, machine, *IDEAL)


def order(emulator, arguments):
    orders = ("mesh", "sorted", "shuffled")
    bars = {machine: [order_ratio(emulator, machine, name) for name in orders] for machine in MACHINES}
    table(["frame time over the ideal machine's; polygons in order", *orders],
          [[machine, *(f"{ratio:.3f}" for ratio in ratios)] for machine, ratios in bars.items()])
    if arguments.plots:
        def draw(axes):
            for i, name in enumerate(orders):
                axes.bar([place + 0.27 * i for place in range(len(bars))], [ratios[i] for ratios in bars.values()], 0.25, label=name)
            axes.set_xticks([place + 0.27 for place in range(len(bars))], bars, fontsize=7)
        plot_figure(arguments.plots / "parks-order.png", draw, "Frame time against the order of polygons, close to the runway (figure 20)",
                    "machine", "times the ideal machine's")


def bus_ratio(emulator, machine, time):
    """Frame time with all pixels over one bus, so long a pixel, over that with local frame buffers."""
    return close_up(emulator, machine, *setting(fabric__frame_buffer="bus", fabric__frame_buffer_bus__time_per_pixel=time)) / close_up(
        emulator, machine)


def bus(emulator, _arguments):
    """The frame-buffer bus, which the thesis takes as free."""
    times = ("50ns", "100ns", "300ns", "1us")
    table(["machine", "local frame buffers, millions of cycles", *(f"times as long over a bus, {time} a pixel" for time in times)],
          [[machine, f"{close_up(emulator, machine) / 1e6:.3f}", *(f"{bus_ratio(emulator, machine, time):.2f}" for time in times)]
           for machine in ("uniprocessor", "splitter16", "interlace16", "interlace64")])


VARIED = {"15": ("runway", 1, 0), "18": ("airport", 6, 2)}  # figure: scene, frames, frame


def variant_changes(emulator, machine, figure):
    """Cycles of a frame, and by how much per cent skipping divisions and half-digested broadcast change them."""
    scene, frames, frame = VARIED[figure]

    def cycles(*settings):
        return frame_cycles(emulator, machine, *scene_arguments(scene, frames), *settings)[frame]

    plain = cycles()
    return plain, *(100 * (cycles(*changed) / plain - 1) for changed in (setting(nodes__symbols="{skip_deltas: 1}"),
                                                                         setting(fabric__half_digested="true")))


def variants(emulator, _arguments):
    """The thesis' further research: half-digested broadcast, and no delta divisions that nobody needs."""
    rows = []
    for machine in ("interlace4", "interlace16", "interlace64", "interlace256"):
        for figure in VARIED:
            plain, skipping, digested = variant_changes(emulator, machine, figure)
            rows.append([machine, figure, f"{plain / 1e6:.3f}", f"{skipping:+.1f}", f"{digested:+.1f}"])
    table(["machine", "figure", "millions of cycles", "skipping divisions, %", "half-digested broadcast, %"], rows)


FABRIC_TABLES = {"depth": depth, "splitter": splitter, "order": order, "bus": bus, "variants": variants}
