# SPDX-License-Identifier: MIT
"""What the measuring scripts share: running the command, reading what it writes, printing Markdown tables."""

import argparse
import atexit
import csv
import json
import subprocess
import sys
import tempfile
from functools import lru_cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


@lru_cache(maxsize=None)
def scratch_folder():
    """For files that are there as long as the script runs."""
    made = tempfile.TemporaryDirectory()
    atexit.register(made.cleanup)
    return Path(made.name)


class EmulatorError(Exception):
    """The command failed; the text is what it said."""


class Emulator:
    """The command, run from the project's root."""

    def __init__(self, binary):
        self.binary = Path(binary)
        if not self.binary.is_absolute():
            self.binary = ROOT / self.binary
        if not self.binary.exists():
            sys.exit(f"{Path(sys.argv[0]).name}: {self.binary} is not there: build it with scripts/demo.sh")

    def text(self, *arguments):
        done = subprocess.run([self.binary, *arguments], cwd=ROOT, capture_output=True, text=True)
        if done.returncode != 0:
            raise EmulatorError(done.stderr.strip() or f"rasterloom {' '.join(arguments)}: exit status {done.returncode}")
        return done.stdout

    def run_into(self, out, config, *arguments):
        """One run, its files in the folder `out`; `config` is a name in configs/ or a file. Returns the printed summary."""
        file = config if str(config).endswith((".yaml", ".yml")) else f"configs/{config}.yaml"
        return self.text("run", str(file), "--out", str(out), *arguments)

    def run(self, config, *arguments, records=None):
        """One run: its statistics and its printed summary; the rows of the CSV files ("nodes") and the JSON files ("statistics.json") go to the
        dict `records`."""
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            return read_run(out, self.run_into(out, config, *arguments), records)


class CachedEmulator(Emulator):
    """Runs nothing twice: what a run wrote stays until the object goes."""

    def __init__(self, binary):
        super().__init__(binary)
        self.folder = tempfile.TemporaryDirectory()
        self.summaries = {}

    def run(self, config, *arguments, records=None):
        key = (str(config), *map(str, arguments))
        if key not in self.summaries:
            out = Path(self.folder.name) / str(len(self.summaries))
            self.summaries[key] = (out, self.run_into(out, config, *arguments))
        return read_run(*self.summaries[key], records)


def read_run(out, summary, records):
    if records is not None:
        for path in out.glob("*.csv"):
            with open(path, newline="") as file:
                records[path.stem] = list(csv.DictReader(file))
        for path in out.glob("*.json"):
            records[path.name] = json.loads(path.read_text())
    return json.loads((out / "statistics.json").read_text()), summary


def setting(**values):
    return [part for name, value in values.items() for part in ("--set", f"{name.replace('__', '.')}={value}")]


def table(head, rows):
    print("| " + " | ".join(str(cell) for cell in head) + " |")
    print("|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print()


def plot_figure(path, draw, title, x_label, y_label):
    """Draws one figure: `draw(axes)` puts the curves in."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    path.parent.mkdir(parents=True, exist_ok=True)
    figure, axes = pyplot.subplots(figsize=(7, 4))
    draw(axes)
    axes.set_xlabel(x_label)
    axes.set_ylabel(y_label)
    axes.set_title(title, fontsize=9)
    axes.grid(alpha=0.3)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize=8)
    figure.savefig(path, dpi=110, bbox_inches="tight")
    pyplot.close(figure)


def plot_pictures(path, pictures):
    """Pictures side by side: grey, arrays of 0 to 255, or in colour."""
    import matplotlib.image
    import numpy
    path.parent.mkdir(parents=True, exist_ok=True)
    matplotlib.image.imsave(path, numpy.hstack(pictures), cmap="gray", vmin=0, vmax=255)


def print_tables(description, tables):
    """The command line of a measuring script: which of its tables to print."""
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("table", choices=[*tables, "all"])
    parser.add_argument("--rasterloom", default="build/release/rasterloom")
    parser.add_argument("--models", default="../shared/models", help="folder of mesh files; those that are not there are left out")
    parser.add_argument("--plots", type=Path, help="folder for plots")
    arguments = parser.parse_args()
    emulator = Emulator(arguments.rasterloom)
    for name in tables if arguments.table == "all" else [arguments.table]:
        print(f"## {name}\n")
        try:
            tables[name](emulator, arguments)
        except EmulatorError as error:
            sys.exit(f"{Path(sys.argv[0]).name}: {name}: {error}")
