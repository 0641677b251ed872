# SPDX-License-Identifier: MIT
"""What the measuring scripts share: running the command, reading what it writes, printing Markdown tables."""

import argparse
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


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
            sys.exit(f"{Path(sys.argv[0]).name}: rasterloom {' '.join(arguments)} failed:\n{done.stderr}")
        return done.stdout

    def run(self, config, *arguments, records=None):
        """One run: its statistics and its printed summary; the rows of the CSV files ("nodes") and the JSON files ("statistics.json") go to the
        dict `records`."""
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            summary = self.text("run", f"configs/{config}.yaml", "--out", str(out), *arguments)
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
    """Grey pictures, arrays of 0 to 255, side by side."""
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
        tables[name](emulator, arguments)
