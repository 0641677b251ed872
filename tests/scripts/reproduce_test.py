#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""reproduce.py: verdicts, papers that join by themselves, pages with the same rows."""

import re
import unittest
from html import unescape

from folders import RASTERLOOM, ROOT, FolderTest, script

import pages
from claims import (DIFFERS, FAILED, INCONSISTENT, NOT_EMULATED, REPRODUCED, Claim, Tolerance, examine, shown, verdict_on)
from measuring import CachedEmulator, Emulator, EmulatorError
from reproduce import load_papers

PAPER = '''from claims import Claim, Tolerance
TITLE = "Nobody 1999: a machine"
NOTES = ["A note with `code` & signs <."]
CLAIMS = [
    Claim("1", "right", 5, lambda e: 5),
    Claim("2", "wrong | odd", 5, lambda e: 6, because="Ours is <another>."),
    Claim("3", "against itself", 5, lambda e: 5, implied=7, implied_by="section 4"),
    Claim("5", "not there", 5, None, because="Nothing to measure."),
]
'''


class Verdict(unittest.TestCase):
    def test_follows_from_tolerance(self):
        for tolerance, value, expected in ((Tolerance(), 100, REPRODUCED), (Tolerance(), 101, DIFFERS), (Tolerance(percent=1), 101, REPRODUCED),
                                           (Tolerance(percent=1), 98.9, DIFFERS), (Tolerance(margin=3), 103, REPRODUCED),
                                           (Tolerance(margin=3), 104, DIFFERS)):
            self.assertEqual(verdict_on(Claim("", "", 100, tolerance=tolerance), value), expected, (tolerance, value))

    def test_ranges_have_ends_and_may_lack_one(self):
        for published, value, expected in (((1, 2), 1.5, REPRODUCED), ((1, 2), 2.5, DIFFERS), ((None, 2), -9, REPRODUCED), ((1, None), 0.5, DIFFERS)):
            self.assertEqual(verdict_on(Claim("", "", published), value), expected)

    def test_texts_agree_or_not(self):
        self.assertEqual(verdict_on(Claim("", "", "yes"), "yes"), REPRODUCED)
        self.assertEqual(verdict_on(Claim("", "", "yes"), "no"), DIFFERS)

    def test_the_papers_own_numbers_come_first(self):
        self.assertEqual(verdict_on(Claim("", "", 5, implied=7), 5), INCONSISTENT)
        self.assertEqual(verdict_on(Claim("", "", 5, implied=5.1, tolerance=Tolerance(percent=5)), 5), REPRODUCED)
        self.assertEqual(verdict_on(Claim("", "", 5, implied=(6, None)), None), INCONSISTENT)
        self.assertEqual(verdict_on(Claim("", "", 5, implied=(6, None), slack=Tolerance(margin=1)), 5), REPRODUCED)

    def test_nothing_measured_is_not_emulated(self):
        self.assertEqual(verdict_on(Claim("", "", 5), None), NOT_EMULATED)

    def test_explanations_change_no_verdict(self):
        self.assertEqual(examine(Claim("", "", 5, lambda e: 6), None).because, "Unexplained.")
        finding = examine(Claim("", "", 5, lambda e: 6, because="Reproduced."), None)
        self.assertEqual((finding.verdict, finding.because), (DIFFERS, "Reproduced."))

    def test_a_run_that_fails_is_a_finding(self):
        def fails(_emulator):
            raise EmulatorError("no such file")

        finding = examine(Claim("", "", 5, fails), None)
        self.assertEqual((finding.verdict, finding.because), (FAILED, "no such file"))

    def test_values_are_shown_as_they_are(self):
        self.assertEqual([shown(v) for v in (None, 5766526.5, 0.25, (None, 3), (1, None), (1, 2), 20000, "yes")],
                         ["-", "5,766,526", "0.25", "at most 3", "at least 1", "1 to 2", "20,000", "yes"])


class Papers(FolderTest):
    def pages_of(self, *words, status=0):
        done = script("reproduce.py", "--out", self.folder, *words)
        self.assertEqual(done.returncode, status, done.stderr)
        return (self.folder / "reproduction.md").read_text(), (self.folder / "reproduction.html").read_text(), done.stdout

    def test_a_file_joins_by_itself_and_both_pages_have_the_same_rows(self):
        self.file("nobody1999.py", PAPER)
        markdown, html, printed = self.pages_of("--papers", self.folder)
        self.assertIn("| Nobody 1999: a machine | 1 | 1 | 1 | 1 | 0 | 4 |", printed)
        self.assertEqual(markdown_rows(markdown), html_rows(html))
        self.assertEqual(len(markdown_rows(markdown)), 1 + 1 + 1 + 4)
        self.assertIn("section 4: 7.", markdown)
        self.assertNotRegex(html, r'(src|href)="(?!data:)')

    def test_a_claim_that_cannot_be_measured_ends_with_status_1(self):
        self.file("broken2000.py",
                  'from claims import Claim\nTITLE = "B"\nNOTES = []\nCLAIMS = [Claim("1", "x", 1, lambda e: e.text("run", "nothing.yaml"))]\n')
        markdown, _, _ = self.pages_of("--papers", self.folder, status=1)
        self.assertIn("could not be measured", markdown)

    def test_an_unknown_paper_is_answered_with_those_there_are(self):
        done = script("reproduce.py", "--out", self.folder, "--paper", "parks1892")
        self.assertEqual(done.returncode, 2)
        self.assertIn("parks1982", done.stderr)

    def test_shipped_papers_are_well_formed(self):
        papers = load_papers(ROOT / "scripts/papers", [])
        self.assertGreaterEqual(len(papers), 2)
        for paper in papers:
            self.assertTrue(paper.TITLE and paper.NOTES and paper.CLAIMS)
            for claim in paper.CLAIMS:
                self.assertTrue(claim.source and claim.what, claim)
                self.assertTrue(claim.measure or claim.because or claim.implied is not None, f"{claim.what}: neither measured nor explained")

    def test_a_small_claim_of_each_paper_runs(self):
        emulator = CachedEmulator(RASTERLOOM)
        papers = {paper.TITLE.split(":")[0]: paper for paper in load_papers(ROOT / "scripts/papers", [])}
        for title, what in (("Strothotte 1981", "diameter"), ("Parks 1982", "uniprocessor: polygons"), ("Eldridge 1995", "C, sort-middle"),
                            ("Chen 1998", "Quake, depth complexity")):
            claim = next(claim for claim in papers[title].CLAIMS if what in claim.what)
            self.assertEqual(examine(claim, emulator).verdict, REPRODUCED, claim)


class Cache(unittest.TestCase):
    def test_nothing_runs_twice(self):
        emulator = CachedEmulator(RASTERLOOM)
        ran = []
        emulator.run_into = lambda out, *words: ran.append(words) or Emulator.run_into(emulator, out, *words)
        records = {}
        first = emulator.run("ring")
        self.assertEqual(emulator.run("ring", records=records), first)
        self.assertEqual(len(ran), 1)
        self.assertIn("nodes", records)
        emulator.run("ring", "--set", "links.latency=2us")
        self.assertEqual(len(ran), 2)


class Pages(unittest.TestCase):
    def test_signs_are_escaped(self):
        text = pages.html("a < b", ["x & `y < z`", pages.Table(["h"], [["<b>"]])])
        self.assertIn("x &amp; <code>y &lt; z</code>", text)
        self.assertIn("<td>&lt;b&gt;</td>", text)


def markdown_rows(text):
    rows = [line for line in text.splitlines() if line.startswith("|") and not re.fullmatch(r"[|-]+", line)]
    return [[cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in rows]


def html_rows(text):
    rows = re.findall(r"<tr>(.*?)</tr>", text)
    return [[unescape(re.sub(r"</?code>", "`", cell)).strip() for cell in re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row)] for row in rows]


if __name__ == "__main__":
    unittest.main()
