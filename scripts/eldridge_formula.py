# SPDX-License-Identifier: MIT
"""The formulas of Eldridge 1995, chapters 4 to 6, in instructions. Numbers in brackets are its equations; p counts visible polygons."""

from math import inf, sqrt

N = 1024  # processors
WIDTH, HEIGHT = 768, 512
Q = WIDTH * HEIGHT  # pixels of the screen; P in chapter 6
G, A, R = 5000, 100, 100  # table 4.3: geometry a polygon, pixels a polygon, rasterising a pixel
F, O = 4.4, 3.8  # table 4.3: asymmetry and overlap of its teapot
GI, GF = 1000, 5000  # 5.4: to keep or reject a polygon, to light a visible one
WORDS, OVERHEAD = 42, 30  # a polygon descriptor
DATA = {"sort-first": (24, 30), "sort-middle": (WORDS, OVERHEAD), "dense sort-last": (3, 15), "sparse sort-last": (5, 30)}  # table 4.2


def pass_cost(distance, words=WORDS, overhead=OVERHEAD):  # 5.3; (4.6) at distance 1
    return (2 + distance) * words + overhead


C = {name: pass_cost(1, *datum) for name, datum in DATA.items()}


def sort_first(p, n=N, f=F, o=O):  # (4.2)
    return p / n * f * (o * G + R * A / o)


def sort_middle(p, n=N, f=F, o=O):  # (4.3)
    return p / n * (G + f * R * A / o) + p * C["sort-middle"]


def sort_last_dense(p, n=N, cost=C["dense sort-last"]):  # (4.4)
    return p / n * (G + A * R) + Q * cost


def sort_last_sparse(p, n=N):  # (4.5)
    return p / n * (G + A * R) + A * p * C["sparse sort-last"]


def overlap_for_sort_middle(n=N):  # (4.10): f o above which sort-middle is faster than sort-first
    return 1 + n * C["sort-middle"] / G


def dense_from(cost=C["dense sort-last"]):  # (4.11): polygons
    return Q * cost / (A * C["sparse sort-last"])


def sort_last_from(cost=C["dense sort-last"], n=N):  # (4.12): polygons
    return Q * cost / (C["sort-middle"] + (F / O - 1) * A * R / n)


def communication_share(n=N):  # (5.1)
    return n * C["sort-middle"] / (G + n * C["sort-middle"] + F * A * R / O)


def greatest_speedup(a=WORDS, b=OVERHEAD):  # (5.2)
    return 3 + b / a


def one_stride(n=N):  # 5.3: half of the ring at stride 1, a polygon
    return n / 2 * pass_cost(1) / n


def two_strides(d, n=N):  # (5.5), a polygon
    return (n / 2 / d * pass_cost(d) + d / 2 * pass_cost(1)) / n


def best_stride(n=N, a=WORDS, b=OVERHEAD):  # (5.6)
    return sqrt((2 * a + b) * n / (3 * a + b))


def best_two_strides(n=N, a=WORDS, b=OVERHEAD):  # (5.7), a polygon
    return sqrt((3 * a + b) * (2 * a + b) / n) + a / 2


def duplicated(m, n=N, visible=0.5):  # (5.8), a visible polygon; the thesis takes half of them to be visible
    return m / n * GI / visible + GF / n + pass_cost(1) / (2 * m)


def best_duplication(n=N):  # (5.9)
    return sqrt(n * pass_cost(1) / (4 * GI))


def composite_shifts(g, n=N):  # (6.2)
    return Q * (1 / g - 1 / n)


def composite(g, n=N):  # (6.3)
    return composite_shifts(g, n) * pass_cost(g, *DATA["dense sort-last"])


def best_group(p, n=N):  # (6.7)
    return sqrt(21 * Q * n / (84 * p))


def sort_twice(p, n=N):  # (6.8) as it is printed
    return 3 * Q + sqrt(441 * Q * p / n)


def sort_twice_derived(p, n=N):
    """(6.5) and (6.6) at the group size of (6.7): 84 g p / n + 21 P / g is least at twice the root of their product."""
    return 3 * Q + 2 * sqrt(84 * 21 * Q * p / n)


def crossing(rising, flat, low=1, high=1e7):
    """Where `rising` overtakes `flat`, by halving."""
    while high - low > 0.5:
        middle = (low + high) / 2
        low, high = (middle, high) if rising(middle) < flat(middle) else (low, middle)
    return high


def overtaken_at(times=sort_twice, n=N):  # 6.6: polygons from which sort-twice is faster; (6.9) is best_two_strides
    return crossing(lambda p: p * best_two_strides(n), lambda p: times(p, n))


def group_of(p, n=N):
    """6.6: the largest factor of n below the best group."""
    return max((g for g in range(1, n + 1) if n % g == 0 and g <= best_group(p, n)), default=1)


def least(values):
    """The key of the least value, the first of equals."""
    best, found = inf, None
    for key, value in values.items():
        if value < best:
            best, found = value, key
    return found
