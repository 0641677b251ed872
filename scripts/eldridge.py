#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Prints and draws what the model of Eldridge's ring gives for the figures of his chapters 4 to 6, beside formulas and published points.

    scripts/eldridge.py scenes | figures | all
        [--rasterloom build/release/rasterloom] [--models ../shared/models] [--plots DIR]

`figures` prints a table a figure (4-2, 5-3, 5-5, 5-6, 5-8, 6-4, 6-6, 6-7) and, with --plots, draws it into that folder. The thesis' graphs cannot
be read: published points are those that its text names. Models that are not there are left out. Each number comes from `rasterloom communicate`.
"""

from eldridge_figures import figures, scenes
from measuring import print_tables

if __name__ == "__main__":
    print_tables(__doc__, {"scenes": scenes, "figures": figures})
