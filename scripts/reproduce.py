#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Puts every published number of the papers beside the emulator's, with a verdict, on one Markdown and one HTML page.

    scripts/reproduce.py --out DIR [--paper NAME ...] [--papers DIR] [--rasterloom build/release/rasterloom]

A file in scripts/papers/ is a paper: TITLE, NOTES (paragraphs) and CLAIMS (claims.py); it is found by itself. Exit status 1 if something could
not be measured.
"""

import argparse
import importlib.util
import sys
from collections import Counter
from pathlib import Path

import pages
from claims import DIFFERS, FAILED, INCONSISTENT, NOT_EMULATED, REPRODUCED, VERDICTS, examine, shown
from measuring import ROOT, CachedEmulator

HEAD = ["where", "what", "published", "emulated", "unit", "tolerance", "verdict", "why"]
CLASSES = {REPRODUCED: "good", DIFFERS: "bad", INCONSISTENT: "odd", NOT_EMULATED: "none", FAILED: "bad"}
INTRODUCTION = [
    "Written by `scripts/reproduce.py --out DIR`; every row comes from a run of `rasterloom`. The verdict is computed: \"reproduced\" if the "
    "emulated value lies within the tolerance of the published one, else \"differs\"; \"the paper is inconsistent\" if other numbers of the same "
    "paper give something else, by the tolerance or what rounding leaves open; \"not emulated\" if there is nothing to measure. The last column is "
    "only text. "
    "A tolerance is a share of the published value, or a number in its unit, often half of its last digit."]


def load_paper(path):
    specification = importlib.util.spec_from_file_location(f"papers.{path.stem}", path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def load_papers(folder, names):
    """In the order of their years, which end the names."""
    paths = sorted(Path(folder).glob("*.py"), key=lambda path: (path.stem[-4:], path.stem))
    unknown = set(names) - {path.stem for path in paths}
    if unknown:
        print(f"reproduce.py: {folder} has no paper {', '.join(sorted(unknown))}; expected {', '.join(path.stem for path in paths)}", file=sys.stderr)
        sys.exit(2)
    return [load_paper(path) for path in paths if not names or path.stem in names]


def row_of(finding):
    claim = finding.claim
    return [claim.source, claim.what, shown(claim.published), shown(finding.measured), claim.unit, str(claim.tolerance), finding.verdict,
            finding.because]


def summary(found):
    rows = [[paper.TITLE, *(Counter(finding.verdict for finding in findings)[verdict] for verdict in VERDICTS), len(findings)]
            for paper, findings in found]
    return pages.Table(["paper", *VERDICTS, "rows"], rows)


def page_of(found):
    parts = [*INTRODUCTION, summary(found)]
    for paper, findings in found:
        parts += [pages.Heading(paper.TITLE), *paper.NOTES, pages.Table(HEAD, [row_of(finding) for finding in findings], CLASSES)]
    return parts


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, required=True, help="folder for reproduction.md and reproduction.html")
    parser.add_argument("--paper", action="append", default=[], help="only this one, such as parks1982; may be given several times")
    parser.add_argument("--papers", type=Path, default=ROOT / "scripts/papers", help="folder of papers")
    parser.add_argument("--rasterloom", default="build/release/rasterloom")
    arguments = parser.parse_args()
    emulator = CachedEmulator(arguments.rasterloom)
    found = [(paper, [examine(claim, emulator) for claim in paper.CLAIMS])
             for paper in load_papers(arguments.papers, arguments.paper)]
    parts = page_of(found)
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name, write in (("reproduction.md", pages.markdown), ("reproduction.html", pages.html)):
        (arguments.out / name).write_text(write("Published numbers, reproduced", parts))
    print(pages.markdown("Rows by verdict", [summary(found)]))
    sys.exit(1 if any(finding.verdict == FAILED for _, findings in found for finding in findings) else 0)


if __name__ == "__main__":
    main()
