# SPDX-License-Identifier: MIT
"""What the tests of scripts share: the project's scripts on the path, the command, a folder that goes, a small scene."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
RASTERLOOM = os.environ.get("RASTERLOOM", str(ROOT / "build/release/rasterloom"))

SMALL = """polygon
0 0 100 50
99 0 100 50
99 99 100 200
0 99 100 200
polygon
100 100 50 10
120 100 50 10
110 130 50 90
"""


class FolderTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def small_scene(self):
        """A scene file of two polygons."""
        return self.file("small.yaml", f"object: {self.file('small.polygons', SMALL)}\n")


def script(name, *words):
    """Runs a script as a user does."""
    return subprocess.run(["/usr/bin/python3", str(ROOT / "scripts" / name), *map(str, words), "--rasterloom", RASTERLOOM], capture_output=True,
                          text=True)
