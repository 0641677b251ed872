# SPDX-License-Identifier: MIT
"""What Parks' published cycles say about one another. By his formula a machine's cycles are those of polygons and vertices (o), of segments (s) and
of pixels (p):

    uniprocessor = o + s + p,  interlace4 = o + s/2 + p/4,  interlace16 = o + s/4 + p/16

so three machines give o, s and p of a scene. (Polygons that touch no line of a processor are charged a segment: o comes out somewhat high.) And a
machine whose processors share what one processor of another machine does can't be more times faster than they are: whatever is cut or
repeated, the sum of their cycles is not less."""

from measuring import table
from parks_figures import NUMBERED, slowest_by_formula
from parks_machines import FIGURES, IDEAL, PUBLISHED, SCENES, appendix_c, scene_arguments

# machine: (whose processor's work so many of it share)
SHARED = {"interlace4": [("uniprocessor", 4)], "splitter4": [("uniprocessor", 4)], "interlace16": [("interlace4", 4), ("uniprocessor", 16)],
          "splitter16": [("splitter4", 4), ("uniprocessor", 16)], "hybrid16": [("splitter4", 4), ("uniprocessor", 16)]}
VERTEX, SEGMENT, PIXEL, POLYGON = 319.3, 158, 21, 139
# Text of 4.4: from one figure of a pair to the other the uniprocessor's time changes by 4.5 % at most.
PAIRS = {"17": "16", "19": "18", "21": "20", "23": "22", "25": "24"}
VARIATION = 0.045
POLYGONS = dict(zip(NUMBERED, (488, 489, 499, 498, 492, 492, 196, 172, 86, 94)))


def published(machine, figure):
    return PUBLISHED[machine][NUMBERED.index(figure)]


def bounds(machine, figure):
    """Millions of cycles that the machine must take at least and at most, by what is published of others; and which these are."""
    if machine == "uniprocessor":
        if figure not in PAIRS:
            return None, ""
        other = published(machine, PAIRS[figure])
        return ((1 - VARIATION) * other, (1 + VARIATION) * other), f"4.4, no more than 4.5 % from figure {PAIRS[figure]}"
    known = [(published(whole, figure) / share, f"{whole} of the same figure, shared by {share}") for whole, share in SHARED[machine]
             if published(whole, figure)]
    low, why = max(known)
    return (low, None), why


def counts(uniprocessor, interlace4, interlace16, polygons):
    """Vertices, segments and pixels of a scene from three machines' cycles."""
    first, second = 4 * interlace4 - uniprocessor, 4 * interlace16 - interlace4  # 3 o + s, 3 o + s/2
    segments = 2 * (first - second)
    overhead = (first - segments) / 3
    return (overhead - POLYGON * polygons) / VERTEX, segments / SEGMENT, (uniprocessor - overhead - segments) / PIXEL


def implied(emulator, _arguments):
    """Vertices, segments and pixels that the published cycles imply, beside ours by the same equations and as they are."""
    machines = ("uniprocessor", "interlace4", "interlace16")
    here = {machine: slowest_by_formula(emulator, machine) for machine in machines}
    rows = []
    for figure in NUMBERED:
        theirs = [published(machine, figure) for machine in machines]
        ours = here["uniprocessor"][figure]
        cells = [f"{ours['vertices']}, {ours['segments']}, {ours['pixels']}"]
        for cycles, polygons in ((theirs, POLYGONS[figure]), ([here[machine][figure]["formula_u"] / 1e6 for machine in machines], ours["polygons"])):
            known = None not in cycles
            cells.append(", ".join(f"{count:.0f}" for count in counts(*(1e6 * c for c in cycles), polygons)) if known else "-")
        rows.append([figure, POLYGONS[figure], ours["polygons"], cells[1], cells[2], cells[0]])
    table(["figure", "polygons: published", "here", "vertices, segments, pixels: implied", "here, by the same equations", "here, counted"], rows)


BETWEEN = 24  # frames between two figures along the approach


def nearby(emulator, _arguments):
    """The slowest processor by the formula a little off the frames that stand for figures 17 and 18."""
    frames = 5 * BETWEEN + 1
    machines = list(PUBLISHED)
    along = {machine: [max(node["formula_u"] for node in frame.values()) / 1e6
                       for frame in appendix_c(emulator, machine, *scene_arguments("airport", frames), *IDEAL)] for machine in machines}
    rows = []
    for figure, at in (("17", (0, 2, 3, 4, 24)), ("18", (46, 47, 48, 49, 50))):
        rows.append([figure, "published", *(published(machine, figure) or "-" for machine in machines)])
        rows += [[figure, f"here, at {place} of {5 * BETWEEN}", *(f"{along[machine][place]:.3f}" for machine in machines)] for place in at]
    table(["figure", "place on the approach", *machines], rows)


def blocks(emulator, _arguments):
    """The two slowest processors of splitter16 by the formula: how many of a scene's polygons each block of the screen has."""
    rows = []
    for figure in NUMBERED:
        scene, frame = next(place for place, name in FIGURES.items() if name == figure)
        nodes = appendix_c(emulator, "splitter16", *scene_arguments(scene, dict(SCENES)[scene]), *IDEAL)[frame]
        slowest = sorted(nodes.items(), key=lambda item: -item[1]["formula_u"])[:2]
        rows.append([figure, slowest_by_formula(emulator, "uniprocessor")[figure]["polygons"], published("splitter16", figure),
                     *(f"{name}: {node['formula_u'] / 1e6:.3f}, {node['polygons']} polygons" for name, node in slowest),
                     f"{sum(node['formula_u'] for _, node in slowest) / 2e6:.3f}"])
    table(["figure", "polygons", "splitter16: published, millions of cycles", "slowest here", "second", "their mean"], rows)


IMPLIED_TABLES = {"implied": implied, "nearby": nearby, "blocks": blocks}
