#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""princeton.py: what is read out of the emulated Princeton Engine's statistics."""

import unittest

from folders import RASTERLOOM, script

from eldridge_ring import counts, random_scene
from measuring import CachedEmulator
from princeton_figures import beside, greatest_that_fits, in_strips, on_machine
from princeton_machine import PICTURE, array, frame_figures, line_figures, model, passes, phase, rounds, stage_costs
from princeton_ring import best, cells, communication, where_it_fits
from princeton_schemes import frame

CUBE = (("scene.object", "cube"),)


class Passes(unittest.TestCase):
    def test_by_the_stride_and_by_one_are_told_apart_by_how_far_words_went(self):
        self.assertEqual(passes({"shifts": 42 * (7 + 20), "places": 42 * (7 * 16 + 20)}, 16), (7, 20))
        self.assertEqual(passes({"shifts": 42 * 20, "places": 42 * 20}), (0, 20))


class Machine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.emulator = CachedEmulator(RASTERLOOM)

    def test_passes_what_the_model_counts(self):
        for stride in (1, 8):
            row = communication(self.emulator, (), stride)
            for machine, counted in (row["far"], row["near"]):
                self.assertLess(abs(machine - counted), 40, stride)
            self.assertGreater(row["near"][0], 100)

    def test_costs_are_those_of_a_scanline_taken_apart(self):
        for textured in (False, True):
            costs, line = stage_costs(self.emulator, CUBE, textured), line_figures(self.emulator, CUBE, textured)
            self.assertLess(line.samples * costs.sample, 910)
            self.assertGreater(costs.light, costs.transform)
        self.assertLess(stage_costs(self.emulator, CUBE, False).sample, costs.sample)

    def test_rounds_fill_the_rasterising(self):
        found = array(self.emulator, CUBE)
        a_round = stage_costs(self.emulator, CUBE, False)
        spent = rounds(self.emulator, found, False) * (a_round.look + 8 * a_round.sample)
        self.assertAlmostEqual(spent / phase(found, "rasterise")["cycles_u"], 1, 2)

    def test_frames_are_whole_pictures_of_the_turned_object(self):
        frames = frame_figures(self.emulator, CUBE, False, (0, 45, 90))
        self.assertEqual([frame.degrees for frame in frames], [0, 45, 90])
        self.assertEqual([frame.visible for frame in frames],
                         [model(self.emulator, (*CUBE, ("scene.rotate.start", str(turn))))["visible"] for turn in (0, 45, 90)])
        for frame in frames:
            self.assertAlmostEqual(frame.geometry + frame.communicate + frame.rasterise, 1)
            self.assertGreater(frame.rasterise, frame.waiting)
            self.assertEqual(frame.a_second() * frame.pictures * PICTURE, 14e6)

    def test_what_does_not_fit_is_said_and_left_out(self):
        crowded = (("scene.polygons", "34404"),)
        self.assertIsNone(where_it_fits(self.emulator, crowded, 1, copies=64))
        self.assertEqual(cells(None, lambda row: [])[0], "does not fit a lane's memory")
        self.assertEqual(best({1: {"cycles": (9, 8)}, 8: {"cycles": (3, 8)}, 16: None}, 0), "8, 3.00")

    def test_boxes_are_passed_on_any_ring_as_the_model_counts(self):
        scene = random_scene(2000)
        for n in (64, 1024):
            found, counted = on_machine(self.emulator, scene, n=n), counts(self.emulator, scene, "--processors", n)
            self.assertAlmostEqual(passes(found)[1] / counted["stages"][0]["passes"], 1, 1)
        self.assertEqual(in_strips(self.emulator, scene, 64).read_text().count("\n"), 2001)

    def test_boxes_without_room_are_told(self):
        self.assertIsNone(on_machine(self.emulator, random_scene(40_000), n=64))
        self.assertEqual(beside(None, 1.5), "no room, 1.50")
        fitting = greatest_that_fits(self.emulator, "sort-middle", n=64)
        self.assertIsNotNone(on_machine(self.emulator, random_scene(1000 * fitting), n=64))

    def test_a_frame_is_its_stages(self):
        found = frame(self.emulator, "sort-twice", CUBE)
        self.assertGreater(found["composite"], 1_000_000)
        self.assertLess(found["all"] - sum(cycles for name, cycles in found.items() if name != "all"), 1)

    def test_stages_are_printed(self):
        done = script("princeton.py", "stages")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| passes | 5 | 5 | 5 |", done.stdout)


if __name__ == "__main__":
    unittest.main()
