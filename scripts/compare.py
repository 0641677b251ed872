#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the same scene on several machines and compares them: table, plots, CSV, HTML.

    scripts/compare.py CONFIG... [--scene NAME] [--same processors|clock] [--frames N] [--set KEY=VALUE]
        [--plots DIR] [--csv FILE] [--html FILE] [--markdown FILE] [--runs N] [--rasterloom build/release/rasterloom]

CONFIG and NAME are files, or names in configs/ and configs/scenes/. docs/compare.md says what the columns mean. Exit status 1 if a machine
failed, its row says why; 2 for wrong usage.
"""

import argparse
import csv
import sys
from pathlib import Path

import pages
from compare_plots import plot
from comparing import find, own_scene, row_of
from measuring import ROOT, Emulator

COLUMNS = {
    "processors": ("processors", "{}"), "clock_mhz": ("clock, MHz", "{:.4g}"), "frame_ms": ("frame time, ms", "{:.4g}"),
    "real_time_factor": ("real-time factor", "{:.3g}"), "utilisation": ("utilisation", "{:.1%}"), "imbalance": ("imbalance", "{:.2f}"),
    "waiting": ("waiting", "{:.1%}"), "communication": ("communication", "{:.1%}"), "bytes": ("bytes a frame", "{:,.0f}"),
    "limit": ("limited by (share of the critical path)", "{}")}


def cells(row):
    if row.error:
        return [row.machine, *["-"] * (len(COLUMNS) - 1), row.error]
    return [row.machine, *(form.format(row.figures[name]) for name, (_, form) in COLUMNS.items())]


def notes(rows, scene, options):
    """What a reader must know beside the table."""
    said = [f"Scene: {scene.stem if scene else 'of each machine'}; frames: {options.frames}; figures are means a frame."]
    if options.same == "clock":
        said.append(f"Clocks are scaled so that processors x clock are {rows[0].machine}'s.")
    if len({row.figures["screen"] for row in rows if row.figures}) > 1:
        screens = ", ".join(f"{row.machine} {row.figures['screen']}" for row in rows if row.figures)
        said.append(f"The screens differ ({screens}): for the same one add `--set screen.width=256 --set screen.height=256`.")
    said.append(f"The real-time factor is the best of {options.runs} runs on this host; it depends on the host, nothing else does.")
    return said


def plot_title(scene, options):
    same = {"clock": ", the same total clock", "processors": ", the same number of processors"}.get(options.same, "")
    return f"Scene {scene.stem if scene else 'of each machine'}{same}"


def write_csv(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        names = [*COLUMNS, "screen"]
        writer.writerow(["machine", *names, "error"])
        writer.writerows([row.machine, *(row.figures.get(name, "") for name in names), row.error] for row in rows)


def compared(options):
    """A row for each machine, and the scene."""
    paths = [find("machine", name, ROOT / "configs") for name in options.configs]
    scene = find("scene", options.scene, ROOT / "configs/scenes") if options.scene else own_scene(paths[0])
    emulator = Emulator(options.rasterloom)
    settings = [word for pair in options.set for word in ("--set", pair)]
    rows, first = [], None
    for path in paths:
        row, machine = row_of(emulator, path, settings, scene, options, first)
        rows.append(row)
        first = first or machine
    return rows, scene


def options_of(words):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("configs", nargs="+", metavar="CONFIG", help="machines: files, or names in configs/")
    parser.add_argument("--scene", help="a file, or a name in configs/scenes/; default: the first machine's")
    parser.add_argument("--same", choices=["processors", "clock"],
                        help="processors: only machines with as many as the first; clock: scale nodes.clock to the first machine's total clock")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="passed on for every machine")
    parser.add_argument("--frames", type=int, default=1)
    parser.add_argument("--runs", type=int, default=3, help="runs of which the best real-time factor is shown")
    parser.add_argument("--plots", type=Path, help="folder for compare-SCENE.png")
    for name in ("csv", "html", "markdown"):
        parser.add_argument(f"--{name}", type=Path, metavar="FILE")
    parser.add_argument("--rasterloom", default="build/release/rasterloom")
    options = parser.parse_args(words)
    if options.frames < 1 or options.runs < 1:
        parser.error("--frames and --runs: expected a number of at least 1")
    return options


def main(words=None):
    options = options_of(words)
    rows, scene = compared(options)
    table = pages.Table(["machine", *(head for head, _ in COLUMNS.values())], [cells(row) for row in rows])
    parts = [*notes(rows, scene, options), table]
    title = f"{', '.join(row.machine for row in rows)}{': the same total clock' if options.same == 'clock' else ''}"
    print(pages.markdown(title, parts))
    if options.plots and any(row.figures for row in rows):
        name = f"compare-{scene.stem if scene else 'own'}{'-' + options.same if options.same else ''}.png"
        plot(options.plots / name, [row for row in rows if row.figures], plot_title(scene, options))
        parts.append(pages.Picture(options.plots / name, title))
    if options.csv:
        write_csv(options.csv, rows)
    if options.html:
        options.html.write_text(pages.html(title, parts))
    if options.markdown:
        options.markdown.write_text(pages.markdown(title, parts, options.markdown.parent))
    sys.exit(1 if any(row.error for row in rows) else 0)


if __name__ == "__main__":
    main()
