#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Chen's formulas give the paper's numbers and are what they say; the synthetic scenes have the paper's statistics; emulated tilers do what is simple to
foretell."""

import unittest
from math import inf

from folders import RASTERLOOM, script

import chen_formula as formula
import chen_hardware as hardware
import chen_software as software
from chen_fifo import DEPTHS
from chen_machine import HARDWARE, SOFTWARE, UNLIMITED, UNTILED, counted, draw_cycles, sweep, tiler
from chen_pictures import picture
from chen_scenes import PUBLISHED, TILES, overlap_factor, overlaps, synthetic
from measuring import CachedEmulator


class Formulas(unittest.TestCase):
    def test_give_what_the_paper_says(self):
        self.assertAlmostEqual(formula.balance_printed(25, 8), 3670, delta=1)
        self.assertAlmostEqual(formula.worst_area(25, 8), 70.4, 1)
        self.assertAlmostEqual(formula.worst_area(9.3, 8), 17.8, 1)

    def test_software_is_worst_at_the_worst_area(self):
        for k, S in ((25, 32), (9.3, 8), (3.6, 16)):
            worst = formula.worst_area(k, S)
            r = [formula.r_software(a, k, formula.overlap(a, S)) for a in (0.98 * worst, worst, 1.02 * worst)]
            self.assertEqual(max(r), r[1])

    def test_hardware_is_worst_where_it_is_balanced_without_tiles(self):
        r = [formula.r_hardware(a, 25, formula.overlap(a, 32)) for a in (24, 25, 26)]
        self.assertEqual(max(r), r[1])
        self.assertEqual(r[1], formula.overlap(25, 32))

    def test_balance_is_where_triangles_cost_as_much_as_pixels(self):
        for S in (16, 32, 64):
            a = formula.balance(25, S)
            self.assertAlmostEqual(25 * formula.overlap(a, S), a)
            self.assertAlmostEqual(formula.balance_printed(25, S), a)

    def test_small_tiles_are_never_balanced(self):
        self.assertEqual(formula.balance(25, 8), inf)
        self.assertGreater(25 * formula.overlap(1e12, 8), 1e12)

    def test_limits_are_those_of_large_triangles(self):
        self.assertAlmostEqual(formula.r_software(1e14, 25, formula.overlap(1e14, 8)), formula.software_limit(25, 8), 4)
        self.assertAlmostEqual(formula.r_hardware(1e14, 25, formula.overlap(1e14, 8)), formula.hardware_limit(25, 8), 4)


class Scenes(unittest.TestCase):
    def setUp(self):
        self.emulator = CachedEmulator(RASTERLOOM)

    def test_have_the_papers_statistics(self):
        for name, row in PUBLISHED.items():
            found = overlaps(self.emulator, synthetic(name))
            self.assertEqual(found["visible"], row.visible)
            self.assertAlmostEqual(found["mean_area"] / row.area, 1, delta=0.01)
            self.assertAlmostEqual(found["depth_complexity"], row.complexity, delta=0.01)
            if row.overlap:
                self.assertAlmostEqual(overlap_factor(self.emulator, synthetic(name), 8) / row.overlap, 1, delta=0.03)

    def test_overlap_less_the_larger_the_tile_and_the_exacter_the_rule(self):
        for scene in map(synthetic, PUBLISHED):
            for rule in ("bounding_box", "exact", "covered"):
                factors = [overlap_factor(self.emulator, scene, S, rule) for S in TILES]
                self.assertEqual(factors, sorted(factors, reverse=True))
            for S in TILES:
                self.assertLessEqual(overlap_factor(self.emulator, scene, S, "exact"), overlap_factor(self.emulator, scene, S))


class Tilers(unittest.TestCase):
    def setUp(self):
        self.emulator = CachedEmulator(RASTERLOOM)
        self.scene = synthetic("Cylhead")

    def pairs(self, tile):
        return round(overlap_factor(self.emulator, self.scene, tile) * PUBLISHED["Cylhead"].visible)

    def test_hardware_without_a_fifo_takes_the_time_of_both_units(self):
        for tile in (8, 32):
            frame, = tiler(self.emulator, self.scene, tile, 0)["frames"]
            self.assertEqual(frame["pairs"], self.pairs(tile))
            self.assertEqual(frame["draw_u"], formula.K * frame["pairs"] + frame["pixels"])

    def test_hardware_with_an_unlimited_fifo_is_what_the_formula_says(self):
        for tile in TILES:
            self.assertAlmostEqual(hardware.CURVES["FIFO unlimited"](self.emulator, self.scene, tile), hardware.by_formula(self.emulator, self.scene, tile), 2)

    def test_hardware_is_faster_with_a_deeper_fifo(self):
        times = [draw_cycles(self.emulator, self.scene, UNTILED, depth) for depth in DEPTHS]
        self.assertEqual(times, sorted(times, reverse=True))
        self.assertLess(times[-1], times[0])

    def test_sweep_and_run_agree(self):
        points = sweep(self.emulator, {"a scene": self.scene}, {"topology.tile": [32, UNTILED], "rasterizer.fifo": [1, UNLIMITED]})
        for tile in (32, UNTILED):
            for fifo in (1, UNLIMITED):
                self.assertEqual(int(points("a scene", tile, fifo)["draw_u"]), draw_cycles(self.emulator, self.scene, tile, fifo))

    def test_sorting_takes_its_time_a_triangle_and_a_pair(self):
        points = sweep(self.emulator, {"a scene": self.scene}, {"topology.tile": [32], "sorter.time_per_triangle": ["50ns"], "sorter.time_per_pair": ["10ns"]})
        self.assertEqual(int(points("a scene", 32, "50ns", "10ns")["sort_u"]), 5 * PUBLISHED["Cylhead"].visible + self.pairs(32))

    def test_software_draws_a_triangle_in_every_tile_and_no_pixel_twice(self):
        tiled, untiled = (counted(self.emulator, self.scene, tile) for tile in (32, UNTILED))
        self.assertEqual(tiled["polygons"], self.pairs(32))
        self.assertEqual(untiled["polygons"], PUBLISHED["Cylhead"].visible)
        self.assertEqual(tiled["pixels"], untiled["pixels"])
        self.assertEqual(software.work(self.emulator, self.scene, 32, "plain").all(), tiled["scene_u"])
        self.assertLess(software.k_of(self.emulator, self.scene, "textured"), software.k_of(self.emulator, self.scene, "plain"))

    def test_pictures_are_the_same_with_and_without_tiles(self):
        untiled = picture(self.emulator, self.scene, HARDWARE, UNTILED)
        self.assertEqual(picture(self.emulator, self.scene, HARDWARE, 16, topology__rasterizers=4), untiled)
        self.assertEqual(picture(self.emulator, self.scene, SOFTWARE, 64), untiled)
        self.assertNotEqual(picture(self.emulator, synthetic("Quake"), HARDWARE, UNTILED), untiled)


class Tables(unittest.TestCase):
    def test_formulas_are_printed(self):
        done = script("chen.py", "analytic")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| 8 | 4.337 | 70.4 | 17.8 |", done.stdout)

    def test_overlaps_are_printed_and_absent_models_named(self):
        done = script("chen.py", "overlap", "--models", "nowhere")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| teapot | exact |", done.stdout)
        self.assertIn("head.obj is not there: left out", done.stderr)

    def test_measurements_are_printed(self):
        done = script("chen.py", "sort")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| Head | 32 x 32 | 1.", done.stdout)


if __name__ == "__main__":
    unittest.main()
