#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Prints and draws what Chen's paper on tiles says and what the emulated bucket tiler does, as Markdown tables.

    scripts/chen.py analytic | overlap | hardware | fifo | parallel | software | sort | pictures | all
        [--rasterloom build/release/rasterloom] [--models ../shared/models] [--plots DIR]

`analytic`: what the formulas give for figures 2, 4 and 5 and the numbers of the text; `overlap`: overlap factors as in figure 6, on synthetic scenes with
the paper's statistics and on meshes, beside the formula of Molnar and Eyles; `hardware`: figures 9 and 10 on emulated hardware rasterizers; `fifo`: how much
buffering pays; `parallel`: many rasterizers, tiles assigned in several ways; `software`: figures 7 and 8 on an emulated processor; `sort`: a sorter that is
not free; `pictures`: that nothing of this changes the picture. The paper's graphs cannot be read: published numbers are those that its text names. Models
that are not there are left out. Tables of a kind share a file, chen_<kind>.py.
"""

from chen_analytic import analytic
from chen_fifo import fifo
from chen_hardware import hardware
from chen_overlap import overlap
from chen_parallel import parallel
from chen_pictures import pictures
from chen_software import software
from chen_sort import sort
from measuring import print_tables

if __name__ == "__main__":
    print_tables(__doc__, {"analytic": analytic, "overlap": overlap, "hardware": hardware, "fifo": fifo, "parallel": parallel, "software": software, "sort": sort,
                           "pictures": pictures})
