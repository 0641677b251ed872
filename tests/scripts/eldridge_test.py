#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Eldridge's formulas give his numbers; the model gives his formulas where nothing is left to chance."""

import unittest

from folders import RASTERLOOM, script

import eldridge_formula as formula
from eldridge_ring import TEAPOT, communicating, composite_of, counts, random_scene, zero_between
from measuring import CachedEmulator


class Formulas(unittest.TestCase):
    def test_give_what_the_thesis_says(self):
        for value, published, places in ((formula.overlap_for_sort_middle(), 32.9, 1), (formula.dense_from(29), 2534, 0),
                                         (formula.best_stride(), 27.36, 2), (formula.best_duplication(), 6.32, 2), (formula.greatest_speedup(), 3.7, 1)):
            self.assertAlmostEqual(value, published, places)
        self.assertAlmostEqual(formula.overtaken_at(), 50503, delta=50)  # he rounds 133.36 to 133.4

    def test_best_values_are_where_the_costs_are_least(self):
        self.assertEqual(formula.least({d: formula.two_strides(d) for d in range(1, 200)}), round(formula.best_stride()))
        self.assertEqual(formula.least({m: formula.duplicated(m) for m in range(1, 200)}), round(formula.best_duplication()))
        self.assertAlmostEqual(formula.two_strides(formula.best_stride()), formula.best_two_strides())

    def test_groups_are_the_largest_factor_below_the_best(self):
        self.assertEqual([formula.group_of(p) for p in (500, 32_000, 640_000, 1e9)], [256, 32, 8, 1])


class Model(unittest.TestCase):
    def setUp(self):
        self.emulator = CachedEmulator(RASTERLOOM)

    def test_composites_as_equation_6_3(self):
        for group in (1, 4, 64, 512):
            self.assertAlmostEqual(composite_of(self.emulator, group) / formula.composite(group), 1, 3)
        self.assertEqual(composite_of(self.emulator, formula.N), 0)

    def test_passes_cost_what_equation_5_3_says(self):
        found = counts(self.emulator, TEAPOT, "--strides", "16,1")
        self.assertEqual(communicating(found), sum(stage["passes"] * formula.pass_cost(stage["stride"]) for stage in found["stages"]))

    def test_scenes_are_made_once(self):
        self.assertIs(counts(self.emulator, random_scene(1000)), counts(self.emulator, random_scene(1000)))

    def test_scenes_are_printed_and_absent_models_named(self):
        done = script("eldridge.py", "scenes", "--models", "nowhere")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| teapot | 9312 |", done.stdout)
        self.assertIn("beethoven.ply is not there: left out", done.stderr)


class Crossing(unittest.TestCase):
    def test_lies_on_the_line_between_the_values_around_it(self):
        self.assertEqual(zero_between({10_000: -3, 20_000: -1, 40_000: 3}), 25_000)

    def test_may_be_nowhere(self):
        self.assertIsNone(zero_between({1: -3, 2: -1}))


if __name__ == "__main__":
    unittest.main()
