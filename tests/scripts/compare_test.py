#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""compare.py: rows, the same total clock, names that are not there, machines that fail."""

import csv
import re
import unittest
from fractions import Fraction

from folders import FolderTest, script

from comparing import Machine, period_of, same_clock
from limits import limit_of


class Compare(FolderTest):
    def rows(self, *words, status=0):
        """The rows of the CSV file by machine."""
        path = self.folder / "rows.csv"
        done = script("compare.py", *words, "--scene", self.small_scene(), "--runs", 1, "--csv", path)
        self.assertEqual(done.returncode, status, done.stderr)
        with open(path, newline="") as file:
            return {row["machine"]: row for row in csv.DictReader(file)}, done.stdout

    def test_a_row_a_machine_with_all_figures(self):
        rows, printed = self.rows("uniprocessor", "interlace4")
        self.assertEqual(list(rows), ["uniprocessor", "interlace4"])
        self.assertEqual([row["processors"] for row in rows.values()], ["1", "4"])
        for row in rows.values():
            self.assertEqual(row["error"], "")
            self.assertGreater(float(row["frame_ms"]), 0)
            self.assertGreater(float(row["real_time_factor"]), 0)
            self.assertTrue(0 < float(row["utilisation"]) <= 1)
            self.assertGreaterEqual(float(row["imbalance"]), 1)
            self.assertTrue(0 <= float(row["communication"]) < 1)
            self.assertIn(row["machine"], printed)
        self.assertLess(float(rows["interlace4"]["frame_ms"]), float(rows["uniprocessor"]["frame_ms"]))
        self.assertIn("the processor", rows["uniprocessor"]["limit"])

    def test_the_same_clock_scales_to_the_first_machines_total(self):
        rows, _ = self.rows("interlace4", "uniprocessor", "--same", "clock")
        totals = [int(row["processors"]) * float(row["clock_mhz"]) for row in rows.values()]
        self.assertAlmostEqual(totals[0], totals[1], places=3)
        self.assertAlmostEqual(float(rows["uniprocessor"]["clock_mhz"]), 1e3 / 75, places=3)

    def test_the_same_processors_leaves_others_out(self):
        rows, _ = self.rows("interlace4", "splitter4", "uniprocessor", "--same", "processors", status=1)
        self.assertEqual([bool(row["error"]) for row in rows.values()], [False, False, True])
        self.assertIn("processors: 1, interlace4 has 4", rows["uniprocessor"]["error"])

    def test_a_machine_that_cannot_draw_the_scene_says_so_and_others_go_on(self):
        rows, printed = self.rows("geodesic482", "uniprocessor", status=1)
        self.assertIn("cannot draw this scene", rows["geodesic482"]["error"])
        self.assertIn("cannot draw this scene", printed)
        self.assertGreater(float(rows["uniprocessor"]["frame_ms"]), 0)

    def test_a_failing_machine_shows_its_error(self):
        rows, _ = self.rows("uniprocessor", "interlace4", "--set", "run.max_time=1ms", status=1)
        self.assertTrue(all(row["error"] and "\n" not in row["error"] for row in rows.values()))

    def test_plots_and_html_hold_every_machine(self):
        page = self.folder / "page.html"
        self.rows("uniprocessor", "interlace4", "--plots", self.folder / "plots", "--html", page)
        self.assertEqual((self.folder / "plots/compare-small.png").read_bytes()[:4], b"\x89PNG")
        text = page.read_text()
        self.assertIn("data:image/png;base64,", text)
        self.assertTrue(all(f"<td>{machine}</td>" in text for machine in ("uniprocessor", "interlace4")))


class Names(unittest.TestCase):
    def test_an_unknown_machine_is_answered_with_the_nearest_before_anything_runs(self):
        done = script("compare.py", "uniprocessor", "interlase4")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("did you mean interlace4?", done.stderr)

    def test_an_unknown_scene_likewise(self):
        done = script("compare.py", "uniprocessor", "--scene", "runwey")
        self.assertEqual(done.returncode, 2)
        self.assertIn("did you mean runway?", done.stderr)


class Clocks(unittest.TestCase):
    def test_periods_are_exact(self):
        self.assertEqual(period_of("300ns"), 300000)
        self.assertEqual(period_of("14MHz"), Fraction(10 ** 6, 14))
        self.assertEqual(period_of("2.5us"), 2500000)

    def test_sixteen_times_the_processors_have_a_sixteenth_of_the_clock(self):
        one, many = (Machine(None, count, Fraction(300000), "") for count in (1, 16))
        self.assertEqual(same_clock(many, one), ["--set", "nodes.clock=4800000ps"])
        self.assertEqual(same_clock(one, many), ["--set", "nodes.clock=18750ps"])


class Limits(unittest.TestCase):
    def limit(self, *components, nodes=(("P0", 9), ("P1", 5))):
        """Of one frame of 100; a component is kind, name, time."""
        path = {"duration_ps": 100, "components": [{"kind": k, "name": n, "time_ps": t} for k, n, t in components],
                "kinds": [{"kind": k, "time_ps": t} for k, _, t in components]}
        return limit_of({"critical_paths": [path]}, [{"name": name, "busy_ps": busy} for name, busy in nodes])

    def test_each_kind_of_limit_has_its_words(self):
        limit, communication = self.limit(("node", "P0", 90), ("wire", "from node", 10))
        self.assertEqual(limit, "the busiest processor, P0 (90 %)")
        self.assertAlmostEqual(communication, 0.1)
        self.assertIn("others wait for, P1", self.limit(("node", "P1", 90))[0])
        self.assertIn("by turns", self.limit(("node", "P0", 40), ("node", "P1", 40), ("link", "a", 20))[0])
        self.assertEqual(self.limit(("link", "a > b", 30), ("link", "b > c", 30), ("node", "P0", 40))[0], "links (60 %)")
        self.assertEqual(self.limit(("bus", "1", 70), ("node", "P0", 30))[0], "bus 1 (70 %)")
        self.assertEqual(self.limit(("splitter", "2", 70), ("node", "P0", 30))[0], "splitter 2 (70 %)")
        self.assertEqual(self.limit(("host", "host", 70), ("node", "P0", 30))[0], "host (70 %)")
        phases = [{"name": name, "kind": "sequencer", "time_ps": time} for name, time in
                  (("finish", 5), ("communicate", 55), ("rasterise", 20), ("migrate", 10), ("finish", 10))]
        limit, communication = limit_of({"array": {}, "critical_paths": [{"duration_ps": 100, "phases": phases}]}, [])
        self.assertEqual(limit, "sequencer, longest in communicate (55 %)")
        self.assertAlmostEqual(communication, 0.65)
        self.assertTrue(re.match("waiting", self.limit(("wire", "from link", 70), ("node", "P0", 30))[0]))


if __name__ == "__main__":
    unittest.main()
