# SPDX-License-Identifier: MIT
"""Runs the program as its users do: as another process, in an empty folder, without a display."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.environ["VIDES_PROGRAM"]
SOURCE = pathlib.Path(os.environ["VIDES_SOURCE_DIR"])
FLIGHTS = SOURCE / "tests" / "data" / "flights"
PYRAMID = str(FLIGHTS / "pyramid-smooth.vid")
NAMES = sorted(p.name.removesuffix(".frames.txt") for p in FLIGHTS.glob("*.frames.txt"))

# A flight of 2,160,000 frames at rest for every 86,400 s: long work from a short file.
LONG = """{"format": "vides", "version": 1, "keys": [
  {"position": [0, 0, 0.5], "orientations": [
    {"aim": [0.1, 0.2, -0.3], "hold": 86400}, {"aim": [0.3, 0.1, -0.7], "hold": 86400}]},
  {"position": [0, 0, 0.7], "orientations": [{"aim": [0, 0, 0]}]}]}"""


def environment(**changes):
    names = ("DISPLAY", "WAYLAND_DISPLAY", "VIDES_ASSETS", "NO_COLOR", "LC_ALL", "LANG")
    kept = {name: value for name, value in os.environ.items() if name not in names}
    return kept | changes


class ProgramTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="vides-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_vides(self, *arguments, input=None, env=None, **others):
        """The finished process; its outputs are bytes."""
        if input is None and "stdin" not in others:
            others["stdin"] = subprocess.DEVNULL
        return subprocess.run(
            [PROGRAM, *map(str, arguments)], input=input, env=env or environment(),
            cwd=self.folder, timeout=300, check=False,
            **({"stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | others))

    def output_of(self, *arguments, **others):
        """Standard output of a run that must be right, and must say nothing else."""
        done = self.run_vides(*arguments, **others)
        self.assertEqual(done.stderr, b"")
        self.assertEqual(done.returncode, 0)
        return done.stdout

    def refused(self, *arguments, status, says, **others):
        """A run that must fail: nothing on standard output, a reason on standard error."""
        done = self.run_vides(*arguments, **others)
        self.assertEqual(done.returncode, status, done)
        self.assertEqual(done.stdout, b"")
        self.assertTrue(done.stderr.startswith(b"vides: "), done.stderr)
        for part in says if isinstance(says, (list, tuple)) else [says]:
            self.assertIn(part, done.stderr.decode())

    def assert_folder_empty(self):
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), [])


def main():
    unittest.main(argv=[sys.argv[0], *sys.argv[1:]])
