# SPDX-License-Identifier: MIT
"""What papers/parks1982.py compares, as numbers."""

from parks_costs import profile
from parks_figures import NUMBERED, figure15_of, slowest_by_formula
from parks_implied import PAIRS, published
from parks_machines import IDEAL, THESIS, appendix_c, scene_arguments
from parks_winners import overhead_of, winner_of

SHARE_OF = {"vertices": ("vertices", 319.3), "segments": ("charged_segments", 158), "pixels": ("pixels", 21)}


def own_cost(emulator, item):
    return profile(emulator, "uniprocessor", 0, 0)[0]["own_costs_u"][item]


def pixel(emulator, kind, autoincrement):
    return profile(emulator, "uniprocessor", 0, 0, nodes__cost__autoincrement=autoincrement)[0]["pixel_costs_u"][kind]


def counted(emulator, machine):
    """In thesis' precision, whose splitters cut polygons at whole pixels as his do."""
    return figure15_of(emulator, machine, *THESIS)


def over_end(emulator, machine, which, name):
    """Cycles of a processor over the slowest or fastest one's, by the formula."""
    cycles = {node: found["formula_u"] for node, found in counted(emulator, machine).items()}
    return cycles[name] / (max if which == "slowest" else min)(cycles.values())


def share(emulator, machine, name, item):
    node = counted(emulator, machine)[name]
    key, cost = SHARE_OF[item]
    return 100 * cost * node[key] / node["formula_u"]


def millions(emulator, machine, figure):
    return slowest_by_formula(emulator, machine)[figure]["formula_u"] / 1e6


def step(emulator, machine, first, second):
    """By how much per cent more the slower of two figures takes."""
    times = millions(emulator, machine, first), millions(emulator, machine, second)
    return 100 * (max(times) / min(times) - 1)


def of_whole(emulator, machine, figure):
    return 100 * millions(emulator, machine, figure) / millions(emulator, "uniprocessor", figure)


def greatest_pair(emulator, change):
    return max(change(emulator, first, second) for second, first in PAIRS.items())


def pair_of_published():
    """Of the uniprocessor, per cent, from the published figures."""
    return max(100 * abs(published("uniprocessor", b) / published("uniprocessor", a) - 1) for b, a in PAIRS.items())


def winners(emulator, figures_of):
    return " ".join(winner_of(emulator, figure) for figure in figures_of)


def frames_won(emulator, size, which, ideal=True, formula=True):
    """Figures, of 15 to 25, where the splitter takes less time than the interlace or the other way round."""
    return sum(winner_of(emulator, figure, size, ideal, formula) == which for figure in ("15", *NUMBERED))


def hybrid_over_best(emulator):
    return min(millions(emulator, "hybrid16", f) / min(millions(emulator, "splitter16", f), millions(emulator, "interlace16", f)) for f in NUMBERED)


def landscape_shares(emulator, size, emulated):
    return [share for scene, frames in (("runway", 1), ("airport", 6)) for share in overhead_of(emulator, f"interlace{size}", scene,
                                                                                                frames)[emulated]]


def random_scene(emulator, machine):
    return max(node["formula_u"] for node in appendix_c(emulator, machine, *scene_arguments("random_polygons", 1), *IDEAL)[0].values())


def runways_take_longer(emulator):
    """Figure 15: sections (1, 0) and (2, 0) against the shuttle's, (3, 2)."""
    cycles = {name: node["formula_u"] for name, node in figure15_of(emulator, "splitter16").items()}
    return "yes" if min(cycles["P1"], cycles["P2"]) > cycles["P11"] else "no"
