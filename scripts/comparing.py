# SPDX-License-Identifier: MIT
"""One machine of a comparison: finding its configuration and scene, running it, the figures of its row."""

import difflib
import re
import sys
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

from limits import limit_of
from measuring import ROOT, EmulatorError, setting

PICOSECONDS = {"ps": 1, "ns": 10 ** 3, "us": 10 ** 6, "ms": 10 ** 9, "s": 10 ** 12}
HERTZ = {"Hz": 1, "kHz": 10 ** 3, "MHz": 10 ** 6, "GHz": 10 ** 9}
NO_SCENE = ("is made of screen polygons", "cannot hold a scene's object", "bucket tiles draw triangles", "are drawn by bucket tiles only")


@dataclass
class Row:
    machine: str
    figures: dict = field(default_factory=dict)
    error: str = ""


@dataclass(frozen=True)
class Machine:
    path: Path
    processors: int
    period: Fraction  # picoseconds a cycle
    screen: str


def find(what, name, folder):
    """A file, or the name of one in a folder of configs/; ends the script with the nearest name if there is none."""
    for path in (Path(name), folder / name, folder / f"{name}.yaml"):
        if path.is_file():
            return path.resolve()
    known = sorted(path.stem for path in folder.glob("*.yaml"))
    nearest = difflib.get_close_matches(Path(name).stem, known, 1)
    hint = f"; did you mean {nearest[0]}?" if nearest else "."
    print(f"compare.py: there is no {what} '{name}'{hint} Expected a file or one of {', '.join(known)}", file=sys.stderr)
    sys.exit(2)


def own_scene(path):
    """The scene file that a configuration names; None where it has none or describes its scene itself."""
    named = re.search(r"^scene: *([^\s{#]+\.ya?ml)", path.read_text(), re.MULTILINE)
    return next((found.resolve() for found in (path.parent / named[1], ROOT / "configs" / named[1]) if found.is_file()), None) if named else None


def period_of(text):
    """Picoseconds of "300ns", "14MHz"."""
    number, unit = re.fullmatch(r"([0-9.]+) *([A-Za-z]+)", text).groups()
    return Fraction(number) * PICOSECONDS[unit] if unit in PICOSECONDS else Fraction(10 ** 12) / (Fraction(number) * HERTZ[unit])


def describe(emulator, path, settings):
    text = emulator.text("describe", str(path), *settings)
    values = emulator.text("describe", str(path), "--config", *settings)
    width, height = (re.search(rf"^  {side}: (\d+)$", values, re.MULTILINE)[1] for side in ("width", "height"))
    return Machine(path, int(re.search(r"^(?:Nodes|Processors) +(\d+)", text, re.MULTILINE)[1]),
                   period_of(re.search(r"^  clock: (\S+)", values, re.MULTILINE)[1]), f"{width} x {height}")


def same_clock(machine, first):
    """Settings with which the machine has the first one's total clock: processors over period."""
    return setting(nodes__clock=f"{max(1, round(first.period * machine.processors / first.processors))}ps")


def measure(emulator, machine, settings, runs):
    """The figures of a row. Everything but the real-time factor is the same on every host."""
    records = {}
    statistics, _ = emulator.run(machine.path, "--bottlenecks", *settings, records=records)
    busy = [int(node["busy_ps"]) for node in records["nodes"]]
    frames = [frame["duration_ps"] for frame in statistics["frames"]]
    node_time = len(busy) * statistics["end_ps"]
    waiting = sum(int(node["waiting_input_ps"]) + int(node["waiting_output_ps"]) for node in records["nodes"])
    limit, communication = limit_of(statistics, records["nodes"])
    return {"processors": len(busy), "clock_mhz": 1e6 / statistics["u_ps"], "screen": machine.screen,
            "frame_ms": sum(frames) / len(frames) / 1e9, "real_time_factor": best_factor(emulator, machine, settings, runs),
            "utilisation": sum(busy) / node_time, "imbalance": max(busy) * len(busy) / max(1, sum(busy)), "waiting": waiting / node_time,
            "communication": communication, "bytes": bytes_moved(statistics) / len(frames), "limit": limit}


def bytes_moved(statistics):
    """Lanes exchange no messages: a sequencer counts the words of two bytes that went to the next lane."""
    words = sum(part["words"] for part in statistics.get("fabric", []) if part["kind"] == "sequencer")
    return statistics["bytes"] + 2 * words


def best_factor(emulator, machine, settings, runs):
    """Machine time over wall time, the best of some runs; depends on the host and on what else it does."""
    summaries = (emulator.text("run", str(machine.path), "--no-files", *settings) for _ in range(runs))
    return max((float(re.search(r"real-time factor ([0-9.e+-]+)", summary)[1]) for summary in summaries), default=0.0)


def row_of(emulator, path, settings, scene, options, first):
    """A row, whatever happens; and the machine as described, if it can be."""
    row = Row(path.stem)
    settings = [*(setting(scene=scene) if scene else []), *settings]
    machine = None
    try:
        machine = describe(emulator, path, settings)
        first = first or machine
        if options.same == "processors" and machine.processors != first.processors:
            raise EmulatorError(f"processors: {machine.processors}, {first.path.stem} has {first.processors}")
        if options.same == "clock":
            settings += same_clock(machine, first)
        row.figures = measure(emulator, machine, [*settings, "--frames", str(options.frames)], options.runs)
    except EmulatorError as error:
        row.error = readable(str(error))
    return row, machine


def readable(error):
    """One line, without the command's name and the folder; says first if the machine cannot draw this scene."""
    text = " ".join(error.removeprefix("rasterloom: ").replace(f"{ROOT}/", "").split())
    return f"cannot draw this scene: {text}" if any(reason in text for reason in NO_SCENE) else text
