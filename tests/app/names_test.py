# SPDX-License-Identifier: MIT
"""Names of files that the screen, the terminal or JSON can't hold: any that the file system allows."""

import os
import pathlib
import shutil

from program import PYRAMID, ProgramTest, main

EMPTY = b'{"format":"vides","version":1,"keys":[]}'
PYRAMID_OBJ = (b"v -0.5 -0.5 -0.5\nv 0.5 -0.5 -0.5\nv 0.5 -0.5 0.5\nv -0.5 -0.5 0.5\nv 0 0.6 0\n"
               b"f 1 2 3 4\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n")
# A name, and how it is told of.
NAMES = [
    (b"esc\x1b[31m.vid", b"esc\\x1B[31m.vid"),
    (b"two\nlines.vid", b"two\\x0Alines.vid"),
    (b"pl\xe4ne.vid", b"pl\\xE4ne.vid"),
    (b"half\xc3.vid", b"half\\xC3.vid"),
    (b"bell\x07\x7f.vid", b"bell\\x07\\x7F.vid"),
    (b"c1\xc2\x9b31m.vid", b"c1\\xC2\\x9B31m.vid"),
    ("ünï 中 😀.vid".encode(), "ünï 中 😀.vid".encode()),
    (b"back\\slash \"quoted\".vid", b"back\\slash \"quoted\".vid"),
    (b"#hash ##2 ###3.vid", b"#hash ##2 ###3.vid"),
    (b"~.vid", b"~.vid"),
    (b"%2F%s{0}.vid", b"%2F%s{0}.vid"),
    (b" blank .vid", b" blank .vid"),
    (b"n" * 251 + b".vid", b"n" * 251 + b".vid"),
]


class Names(ProgramTest):
    def path(self, name):
        return os.path.join(os.fsencode(self.folder), name)

    def vides(self, *arguments):
        """As run_vides(), but the names stay the bytes that they are."""
        return self.run_vides(*(os.fsdecode(a) if isinstance(a, bytes) else a for a in arguments))

    def script(self, text):
        (self.folder / "script.vds").write_bytes(text)
        return self.run_vides("drive", "--script", "script.vds")

    def quoted(self, name):
        return b'"' + name.replace(b"\\", b"\\\\").replace(b'"', b'\\"') + b'"'

    def test_check_tells_a_line_a_problem(self):
        for name, _ in NAMES:
            pathlib.Path(os.fsdecode(self.path(name))).write_bytes(EMPTY)
        done = self.vides("check", *(name for name, _ in NAMES))
        self.assertEqual(done.returncode, 1)
        wanted = [shown + b": /keys: " for _, shown in NAMES]
        lines = done.stdout.split(b"\n")[:-1]
        self.assertEqual(len(lines), len(wanted))
        for line, start in zip(lines, wanted):
            self.assertTrue(line.startswith(start), (line, start))
        self.assertFalse(any(byte < 0x20 or byte == 0x7F for byte in done.stdout.replace(b"\n", b"")))
        # What isn't there, and what can't be written.
        for name, shown in NAMES:
            for arguments in (("frames", b"no/" + name), ("info", b"no/" + name),
                              ("frames", PYRAMID, "-o", b"no/" + name),
                              ("screenshot", b"no/" + name, "-o", "x.png"),
                              ("drive", "--script", b"no/" + name)):
                done = self.vides(*arguments)
                self.assertEqual(done.returncode, 1, arguments)
                self.assertIn(shown, done.stderr)
                self.assertEqual(done.stderr.count(b"\n"), 1, done.stderr)

    def test_frames_and_flights_of_any_name(self):
        for name, _ in NAMES:
            flight = self.path(name)
            shutil.copy(PYRAMID, os.fsdecode(flight))
            done = self.vides("frames", flight, "-o", name[:-4] + b".csv", "--format", "csv")
            self.assertEqual((done.returncode, done.stderr), (0, b""))
            self.assertTrue(os.path.exists(self.path(name[:-4] + b".csv")))
            info = self.vides("info", flight)
            self.assertEqual(info.returncode, 0)
            self.assertFalse(any(b < 0x20 for b in info.stdout.replace(b"\n", b"")))

    def test_saved_opened_and_dropped(self):
        for name, shown in NAMES:
            if b"\n" in name:
                continue  # a script has a command a line
            os.makedirs(self.folder / "in", exist_ok=True)
            words = self.quoted(name)
            said = self.quoted(shown)
            # As long as a name may be, with its longer ending.
            setup = self.quoted(name[:-4][:250] + b".json")
            done = self.script(
                b"do set-zoom 33\ndo save-as " + words + b"\nexpect_output " + said +
                b"\nexpect_title " + said +
                b"\ndo new\nopen " + words + b"\nexpect /keys/0/orientations/0/zoom 33\ndo new\ndrop " +
                words + b"\nexpect /keys/0/orientations/0/zoom 33\nexpect_output " + said +
                b"\ndo new\ndo open-recent 0\nexpect /keys/0/orientations/0/zoom 33\ndo save-setup " +
                setup + b"\ndo load-setup " + setup + b"\nexpect_output " +
                self.quoted(shown[:-4][:250] + b".json") + b"\ndo set-zoom 44\ndo quit\ndo answer save\n")
            self.assertEqual((done.returncode, done.stderr), (0, b""), name)
            self.assertIn(b'"zoom": 44', pathlib.Path(os.fsdecode(self.path(name))).read_bytes())

    def test_chosen_in_the_chooser(self):
        for name, _ in NAMES[:9]:
            folder = self.folder / "chosen"
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir()
            shutil.copy(PYRAMID, folder / os.fsdecode(name))
            done = self.script(
                b"do open\nframe 2\nclick chooser/file_0\nframe 2\nkey enter\nframe 30\n"
                b"click chooser/file_0\nframe 2\nclick chooser/ok\nframe 2\n"
                b"expect /keys/2/position/0 0 2\n")
            self.assertEqual((done.returncode, done.stderr), (0, b""), name)

    def test_a_scene_must_be_named_in_utf8(self):
        for name in (b"pl\xe4ne.obj", b"half\xc3.obj"):
            pathlib.Path(os.fsdecode(self.path(name))).write_bytes(PYRAMID_OBJ)
            for line in (b"drop ", b"do import-scene "):
                done = self.script(line + name + b"\nframe 20\nexpect_output \"UTF-8\"\nexpect /scene []\n")
                self.assertEqual(done.returncode, 0, done.stderr)
        # Beside a flight whose folder isn't UTF-8 the scene's own name is enough.
        os.mkdir(self.path(b"\xe4"))
        pathlib.Path(os.fsdecode(self.path(b"\xe4/s.obj"))).write_bytes(PYRAMID_OBJ)
        done = self.script(b"save \xe4/a.vid\ndo import-scene \xe4/s.obj\nframe 20\n"
                           b"expect /scene/0/file s.obj\nsave \xe4/a.vid\n"
                           b"do save-as b.vid\nexpect_output \"UTF-8\"\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse((self.folder / "b.vid").exists())

    def test_a_failing_line_is_one_line(self):
        done = self.script(b"open no/esc\x1b[31m.vid\n")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.count(b"\n"), 1)
        self.assertIn(b"esc\\x1B[31m.vid", done.stderr)


if __name__ == "__main__":
    main()
