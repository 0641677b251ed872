#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures what docs/results.md reports about Parks' machines and prints it as Markdown tables.

    scripts/parks.py costs | figure15 | figures | implied | nearby | blocks | formula | winners | overhead | swing | depth | splitter | order | bus
        | variants | pictures | speed | all
        [--rasterloom build/release/rasterloom] [--models ../shared/models] [--plots DIR]

Each table runs `rasterloom` on the shipped configurations; nothing is computed here but ratios and fits. Tables of a kind
share a file, parks_<kind>.py.
"""

from measuring import print_tables
from parks_costs import costs
from parks_fabric import FABRIC_TABLES
from parks_figures import figure15, figures
from parks_formula import formula
from parks_implied import IMPLIED_TABLES
from parks_pictures import pictures
from parks_speed import speed
from parks_winners import WINNERS_TABLES

if __name__ == "__main__":
    print_tables(__doc__, {"costs": costs, "figure15": figure15, "figures": figures, **IMPLIED_TABLES, "formula": formula, **WINNERS_TABLES,
                           **FABRIC_TABLES,
                           "pictures": pictures, "speed": speed})
