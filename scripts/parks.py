#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures what docs/results.md reports about Parks' machines and prints it as Markdown tables.

    scripts/parks.py costs | all
        [--rasterloom build/release/rasterloom] [--models ../shared/models] [--plots DIR]

Each table runs `rasterloom` on the shipped configurations; nothing is computed here but ratios and fits. One file a table: parks_<table>.py.
"""

from measuring import print_tables
from parks_costs import costs

if __name__ == "__main__":
    print_tables(__doc__, {"costs": costs})
