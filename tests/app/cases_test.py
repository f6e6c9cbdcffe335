# SPDX-License-Identifier: MIT
"""What users of other programs reported, as small files of tests/data/cases: each must be right."""

import json
import os
import shutil

import program
from program import ProgramTest, SOURCE

CASES = SOURCE / "tests" / "data" / "cases"


class Cases(ProgramTest):
    def enter(self, case):
        """The case's files stand in the folder that the program runs in."""
        shutil.copytree(CASES / case, self.folder, dirs_exist_ok=True)

    def drive(self, case):
        self.enter(case)
        done = self.run_vides("drive", "--script", "run.vds")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, b"")
        return done.stderr.decode(errors="surrogateescape")

    def shot(self, flight, *options):
        return self.output_of("screenshot", flight, "-o", "-", "--size", "640x360", *options)

    def test_backslash_blank(self):
        self.assertEqual(self.drive("obj-backslash-blank"), "")

    def test_comment_backslash(self):
        self.assertEqual(self.drive("obj-comment-backslash"), "")

    def test_cr_lines(self):
        self.assertEqual(self.drive("obj-cr-lines"), "")

    def test_extra_words_on_v(self):
        self.assertEqual(self.drive("obj-extra-words-on-v"),
                         "run.vds:1: glued.obj: line 3: expected a number after v, found “f”\n")

    def test_face_before_vertices(self):
        self.assertEqual(self.drive("obj-face-before-vertices"), "")

    def test_one_nan_vertex(self):
        said = self.drive("obj-one-nan-vertex")
        self.assertTrue(said.startswith("run.vds:1: nan.obj: remark: 3 vertices "), said)
        self.assertIn("line 11", said)

    def test_two_corner_face(self):
        said = self.drive("obj-two-corner-face")
        self.assertTrue(said.startswith("run.vds:1: twofold.obj: remark: 2 faces "), said)
        self.assertIn("line 11", said)

    def test_vertices_only(self):
        self.enter("obj-vertices-only")
        empty = json.loads((self.folder / "cloud.vid").read_text())
        del empty["scene"]
        (self.folder / "empty.vid").write_text(json.dumps(empty))
        for view in ("camera", "iso"):
            without = self.shot("empty.vid", "--view", view)
            for name, says in (("cloud", "200 vertices"), ("curve", "5 lines skipped")):
                done = self.run_vides("screenshot", name + ".vid", "-o", "-", "--size", "640x360",
                                      "--view", view)
                self.assertEqual(done.returncode, 0)
                self.assertNotEqual(done.stdout, without)
                self.assertIn(f"{name}.vid: /scene/0/file: remark: ", done.stderr.decode())
                self.assertIn(says, done.stderr.decode())

    def test_screenshot_silent_scene(self):
        self.enter("screenshot-silent-scene")
        for name, why in (("gone", "not-there.obj: No such file"),
                          ("refused", "refused.obj: line 4: there is no vertex “4”")):
            done = self.run_vides("screenshot", name + ".vid", "-o", "a.png")
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"{name}.vid: /scene/0/file: {why}", done.stderr.decode())
            self.assertFalse((self.folder / "a.png").exists())

    def test_duration_drift(self):
        self.enter("duration-drift")
        info = json.loads(self.output_of("info", "--json", "beat.vid"))
        self.assertEqual(info["frames"], 656)

    def test_import_latin1_name(self):
        pyramid = (CASES / "obj-cr-lines" / "cr.obj").read_bytes()
        (self.folder / os.fsdecode(b"pl\xe4ne.obj")).write_bytes(pyramid)
        self.assertIn("UTF-8", self.drive("import-latin1-name"))

    def test_check_control_characters(self):
        names = [b"esc\x1b[31m.vid", b"two\nlines.vid", b"bell\x07.vid"]
        for name in names:
            (self.folder / name.decode()).write_text('{"format": "vides", "version": 1, "keys": []}')
        done = self.run_vides("check", *[name.decode() for name in names])
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout.count(b"\n"), len(names))
        self.assertFalse(any(byte < 0x20 and byte != 0x0a for byte in done.stdout), done.stdout)


if __name__ == "__main__":
    program.main()
