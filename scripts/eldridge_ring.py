# SPDX-License-Identifier: MIT
"""What the model of Eldridge's ring counts (`rasterloom boxes`, `rasterloom communicate`; docs/ring-model.md), as numbers: eldridge.py draws
them, papers/eldridge1995.py compares them."""

import json
from functools import lru_cache

from eldridge_formula import GF, GI, N, group_of, least
from measuring import scratch_folder

# At 72 degrees the teapot's polygons are on 5.7 columns each, as the thesis' are (figure 4-1: 23.3 polygons on the mean of 1024 processors).
LENS = ("--field-of-view", "72")
TEAPOT = ("--object", "teapot", *LENS)
RING_SIZES = (64, 128, 256, 512, 1024, 2048)
STRIDES = (1, 2, 4, 8, 16, 32, 64, 128, 256)
DUPLICATIONS = (1, 2, 4, 8, 16, 32, 64, 128)
SHADED, TEXTURED, DEFERRED = 80, 202, 98  # instructions a pixel, chapter 8 and 6.5
COUNTS = (10_000, 20_000, 40_000, 64_000, 80_000, 160_000, 320_000, 640_000, 1_280_000)  # of random polygons, to those of figure 6-7


def random_scene(count):
    return ("--random", str(count))


def mesh_scene(file):
    return ("--mesh", str(file), *LENS)


@lru_cache(maxsize=None)
def boxes_of(emulator, scene):
    path = scratch_folder() / f"{boxes_of.cache_info().currsize}.boxes"
    emulator.text("boxes", *scene, "--out", str(path))
    return path


@lru_cache(maxsize=None)
def counts(emulator, scene, *arguments):
    return json.loads(emulator.text("communicate", str(boxes_of(emulator, scene)), "--json", *map(str, arguments)))


def strides(d):
    return ("--strides", f"{d},1" if d > 1 else "1")


def communicating(found):
    return found["instructions"]["communicating"]


def per_visible(found, *stages):
    return sum(found["instructions"][stage] for stage in stages) / found["visible"]


def shifts(emulator, scene, n=N):
    """Shifts a visible polygon, dense ring."""
    found = counts(emulator, scene, "--processors", n)
    return sum(stage["shifts"] for stage in found["stages"]) / found["visible"]


def sparse_over_dense(emulator, scene):
    return communicating(counts(emulator, scene, "--sparse")) / communicating(counts(emulator, scene))


def distribution(emulator, scene):
    """Instructions to communicate, a visible polygon, by the first stage's stride."""
    return {d: per_visible(counts(emulator, scene, *strides(d)), "communicating") for d in STRIDES}


def duplication(emulator, scene, d=1):
    """Instructions for geometry and communication, a visible polygon, by the duplication."""
    return {m: per_visible(counts(emulator, scene, "--duplicate", m, *strides(d)), "rejecting", "lighting", "communicating") for m in DUPLICATIONS}


def stride_speedup(emulator, scene):
    found = distribution(emulator, scene)
    return found[1] / min(found.values())


def best_pair(emulator, scene):
    """Duplication and stride that take least together."""
    return least({(m, d): cost for d in STRIDES for m, cost in duplication(emulator, scene, d).items()})


def busiest_with_locality(emulator, scene):
    """5.5: polygons on the first column that each meets, which is duplication on all processors."""
    return max(counts(emulator, scene, "--duplicate", N)["sourced"])


def locality_penalty(emulator, scene):
    """5.5: instructions a visible polygon that the busiest processor spends beyond an even share."""
    found = counts(emulator, scene)
    even = -(-found["polygons"] // N)
    return (busiest_with_locality(emulator, scene) - even) * (GI + GF) / found["visible"]


def received(emulator, scene):
    """Figure 4-1: polygons on the fullest processor and on the mean."""
    found = counts(emulator, scene)["stages"][-1]["received"]
    return max(found), sum(found) / len(found)


def sort_middle(emulator, scene):
    """With both stages of the best distribution, textured."""
    return counts(emulator, scene, *strides(16), "--pixel-cost", TEXTURED)


def sort_twice(emulator, scene, group):
    return counts(emulator, scene, "--group", group, "--pixel-cost", DEFERRED)


def sort_twice_at_best(emulator, scene):
    return sort_twice(emulator, scene, group_of(counts(emulator, scene)["visible"]))


def all_instructions(found):
    return found["instructions"]["total"]


def sorting_instructions(found):
    return found["instructions"]["communicating"] + found["instructions"]["compositing"]


def zero_between(values):
    """Where `values`, numbers by ascending keys, first rise above zero: a straight line between two of them; None if they do not."""
    points = list(values.items())
    for (below, less), (above, more) in zip(points, points[1:]):
        if less < 0 <= more:
            return below + (above - below) * -less / (more - less)
    return None


def overtaken_at(emulator, cost):
    """Random polygons, half of them visible, from which sort-twice takes less of `cost`."""
    return zero_between({count: cost(sort_middle(emulator, random_scene(count))) - cost(sort_twice_at_best(emulator, random_scene(count)))
                         for count in COUNTS})


def composite_of(emulator, group, n=N):
    """Instructions to composite a screen, whatever the scene."""
    return counts(emulator, random_scene(1000), "--group", group, "--processors", n)["instructions"]["compositing"]
