#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures what docs/results.md reports about the emulated Princeton Engine, sort-middle, and prints it as Markdown tables.

    scripts/princeton.py stages | table | strides | copies | lanes | figures | schemes | pictures | speed | all
        [--rasterloom build/release/rasterloom] [--models ../shared/models] [--plots DIR]

`stages`: what an item costs and what fits a scanline; `table`: frames as in Eldridge's table 8.1; `strides`, `copies`: passes and cycles of the
communication beside the model's (`rasterloom communicate` on the boxes of the same polygons); `lanes`: rings of other sizes; `figures`: Eldridge's
figures 4-2 to 6-7 on bounding boxes, beside the model; `schemes`: a frame of each model where the sort stands elsewhere; `pictures`: against the
reference renderer; `speed`: of the emulation, which alone depends on the host. Models that are not there are left out. Tables of a kind share a file, princeton_<kind>.py.
"""

from measuring import print_tables
from princeton_figures import figures
from princeton_pictures import pictures
from princeton_ring import copies, lanes, strides
from princeton_schemes import schemes
from princeton_speed import speed
from princeton_stages import stages, table_8_1

if __name__ == "__main__":
    print_tables(__doc__, {"stages": stages, "table": table_8_1, "strides": strides, "copies": copies, "lanes": lanes, "figures": figures, "schemes": schemes,
                           "pictures": pictures, "speed": speed})
