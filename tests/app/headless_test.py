# SPDX-License-Identifier: MIT
"""Commands without a display say all that the editor says, and texts are read whole or refused."""

import json
import struct
import zlib

import program
from program import ProgramTest

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def flight(*scenes, **members):
    keys = [{"position": [0.9, 0.3, 0.2], "orientations": [{"aim": [0, 0, 0]}]},
            {"position": [0, 0.5, 0.9], "orientations": [{"aim": [0, 0, 0]}]}]
    return {"format": "vides", "version": 1, "keys": keys,
            "scene": [{"file": name} for name in scenes]} | members


class Folder(ProgramTest):
    def write(self, name, content):
        path = self.folder / name
        if isinstance(content, dict):
            content = json.dumps(content)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())

    def said(self, *arguments, status, out=b"", **others):
        """The lines on standard error."""
        done = self.run_vides(*arguments, **others)
        self.assertEqual(done.returncode, status, done)
        self.assertEqual(done.stdout, out)
        return done.stderr.decode().splitlines()


class Scenes(Folder):
    def setUp(self):
        super().setUp()
        self.write("good.obj", TRIANGLE)
        self.write("odd.obj", TRIANGLE + "f 1 2\ncurv 0\n")
        self.write("bad.obj", TRIANGLE + "v 1 2 x\n")
        self.write("all.vid", flight("good.obj", "gone.obj", "odd.obj", "bad.obj", "gone.obj"))
        self.write("fine.vid", flight("good.obj"))
        self.write("odd.vid", flight("odd.obj"))
        self.remarks = ["/scene/2/file: remark: 1 line skipped", "/scene/2/file: remark: 1 face"]
        self.problems = ["/scene/1/file: gone.obj: No such file", "/scene/3/file: bad.obj: line 5: ",
                         "/scene/4/file: gone.obj: No such file"]

    def assert_all_told(self, name, lines):
        wanted = [f"{name}: {part}" for part in self.problems[:1] + self.remarks + self.problems[1:]]
        self.assertEqual(len(lines), len(wanted), lines)
        for line, part in zip(lines, wanted):
            self.assertTrue(line.startswith(part), (line, part))

    def test_that_are_missing_or_refused_end_a_screenshot(self):
        for options in ((), ("--view", "camera"), ("--whole-window",)):
            self.assert_all_told("all.vid", self.said("screenshot", "all.vid", "-o", "a.png",
                                                      *options, status=1))
            self.assertFalse((self.folder / "a.png").exists())
        self.assert_all_told("-", self.said(
            "screenshot", "-", "-o", "-", status=1, input=(self.folder / "all.vid").read_bytes()))

    def test_that_are_missing_are_left_out_where_that_is_allowed(self):
        self.assert_all_told("all.vid", self.said("screenshot", "all.vid", "-o", "a.png",
                                                  "--allow-missing-scenes", status=0))
        self.assertTrue((self.folder / "a.png").exists())
        self.assertEqual(self.said("screenshot", "fine.vid", "-o", "b.png", status=0), [])
        self.assertEqual(self.said("screenshot", "fine.vid", "-o", "b.png",
                                   "--allow-missing-scenes", status=0), [])

    def test_what_was_left_out_changes_no_status(self):
        lines = self.said("screenshot", "odd.vid", "-o", "a.png", status=0)
        self.assertEqual([line.split(" remark: ")[0] for line in lines],
                         ["odd.vid: /scene/0/file:"] * 2)
        self.assertIn("line 6, “curv”", lines[0])

    def test_of_the_flight_end_a_drive(self):
        self.write("run.vds", "save saved.vid\n")
        run = ("drive", "all.vid", "--script", "run.vds")
        self.assert_all_told("all.vid", self.said(*run, status=1))
        self.assertFalse((self.folder / "saved.vid").exists())
        self.assert_all_told("all.vid", self.said(*run, "--allow-missing-scenes", status=0))
        self.assertTrue((self.folder / "saved.vid").exists())

    def test_are_not_read_where_nothing_is_drawn(self):
        for command in ("frames", "info", "check"):
            done = self.run_vides(command, "all.vid")
            self.assertEqual((done.returncode, done.stderr), (0, b""), command)


class Drive(Folder):
    def test_tells_errors_with_the_line_and_keeps_the_scripts_status(self):
        self.write("bad.obj", "v 0 0 0\nf 1 2 3\n")
        self.write("bad.vid", "{")
        self.write("two.obj", TRIANGLE + "f 1\n")
        self.write("gone.vid", flight("gone.obj"))
        self.write("run.vds", """# a comment
do import-scene bad.obj
frame 3
drop none.obj
frame
drop bad.vid
do save-as no/folder.vid
do set-zoom 1000
do frames-file /dev/null/x.txt
do write-frames
open gone.vid
frame 2
do import-scene two.obj
""")
        lines = self.said("drive", "--script", "run.vds", status=0)
        wanted = ["run.vds:2: bad.obj: line 2: there is no vertex “2”", "run.vds:4: none.obj: ",
                  "run.vds:6: bad.vid: ", "run.vds:7: folder.vid: ", "run.vds:8: ",
                  "run.vds:10: x.txt: ", "run.vds:11: gone.obj: No such file",
                  "run.vds:13: two.obj: remark: 1 face"]
        self.assertEqual(len(lines), len(wanted), lines)
        for line, part in zip(lines, wanted):
            self.assertTrue(line.startswith(part), (line, part))

    def test_tells_a_failing_line_once(self):
        self.write("run.vds", "open none.vid\n")
        lines = self.said("drive", "--script", "run.vds", status=1)
        self.assertEqual(len(lines), 1, lines)
        self.assertTrue(lines[0].startswith("run.vds:1: expected to open none.vid"), lines)

    def test_speaks_the_language_that_was_chosen(self):
        self.write("two.obj", TRIANGLE + "f 1\n")
        self.write("bad.obj", "v 1\n")
        self.write("run.vds", "do import-scene two.obj\ndo import-scene bad.obj\n")
        lines = self.said("drive", "--script", "run.vds", "--language", "de", status=0)
        self.assertIn("two.obj: remark: 1 Fläche oder Linie mit zu wenigen Ecken", lines[0])
        self.assertIn("bad.obj: Zeile 1: nach v werden 2, 3, 4, 6 oder 7 Zahlen erwartet", lines[1])


class Texts(Folder):
    """Other texts than OBJ: read whole or refused, with a line that counts all line ends."""

    def test_flights(self):
        text = json.dumps(flight(), indent=1)
        for ends in ("\n", "\r", "\r\n"):
            self.write("a.vid", text.replace("\n", ends))
            self.output_of("check", "a.vid")
            self.write("a.vid", ("\ufeff" + text).replace("\n", ends))
            self.output_of("check", "a.vid")
            self.write("b.vid", ends.join(["{", '"format": "vides",', "!"]))
            self.assertIn(b"b.vid:3:1: ", self.run_vides("check", "b.vid").stdout)
        self.write("b.vid", "{\r\n\r\"format\"\n\n:\r\r!")
        self.assertIn(b"b.vid:7:1: ", self.run_vides("check", "b.vid").stdout)
        for encoding in ("utf-16", "utf-16-le", "utf-16-be", "utf-32"):
            self.write("a.vid", text.encode(encoding))
            done = self.run_vides("check", "a.vid")
            self.assertEqual(done.returncode, 1)
            self.assertIn(encoding[:6].upper().encode(), done.stdout)
        for nul in (text + "\0", "\0" + text, text.replace("vides", "vi\0des", 1),
                    text.replace(",", ",\0", 1)):
            self.write("a.vid", nul)
            self.assertEqual(self.run_vides("check", "a.vid").returncode, 1)

    def test_scripts_and_setups(self):
        script = "do set-roll 5\nexpect /keys/0/orientations/0/roll 5\n"
        for ends in ("\n", "\r", "\r\n"):
            self.write("a.vds", script.replace("\n", ends))
            self.output_of("drive", "--script", "a.vds")
            self.write("a.vds", ("# one\n\n" + script + "nonsense").replace("\n", ends))
            self.assertIn("a.vds:5: ", self.said("drive", "--script", "a.vds", status=1)[0])
        self.write("a.vds", b"\xef\xbb\xbf" + script.encode())
        self.output_of("drive", "--script", "a.vds")
        self.write("a.vds", script.encode("utf-16"))
        self.assertIn("UTF-16", self.said("drive", "--script", "a.vds", status=1)[0])
        self.write("a.vds", script + "# a\0b")
        self.assertIn("a.vds:3: ", self.said("drive", "--script", "a.vds", status=1)[0])
        self.write("a.vds", script)
        self.write("setup", '{"format": "vides-setup", "version": 1}'.encode("utf-16"))
        lines = self.said("drive", "--script", "a.vds", "--setup", "setup", status=1)
        self.assertIn("UTF-16", lines[0])


class CameraPictures(Folder):
    """`screenshot --view camera` has the flight's format unless both sides are given."""

    def size_of(self, *options, name="a.vid"):
        self.output_of("screenshot", name, "-o", "a.png", "--view", "camera", *options)
        return struct.unpack(">II", (self.folder / "a.png").read_bytes()[16:24])

    def row(self, y):
        """A row of pixels of the last picture, four bytes each; filter types undone."""
        data = (self.folder / "a.png").read_bytes()
        width, _, _, kind = struct.unpack(">IIBB", data[16:26])
        packed, at = b"", 8
        while at < len(data):
            length, name = struct.unpack(">I4s", data[at:at + 8])
            if name == b"IDAT":
                packed += data[at + 8:at + 8 + length]
            at += 12 + length
        size = 4 if kind == 6 else 3
        raw, before = zlib.decompress(packed), bytearray(width * size)
        for line in range(y + 1):
            begin = line * (width * size + 1)
            now = bytearray(raw[begin + 1:begin + 1 + width * size])
            for i, byte in enumerate(now):
                left = now[i - size] if i >= size else 0
                up, corner = before[i], before[i - size] if i >= size else 0
                guess = left + up - corner
                nearest = min((left, up, corner), key=lambda c: abs(guess - c))
                now[i] = (byte + (0, left, up, (left + up) // 2, nearest)[raw[begin]]) % 256
            before = now
        return [bytes(before[i:i + 3]) for i in range(0, len(before), size)]

    def test_sizes(self):
        for width, height, wanted in ((1920, 1080, 720), (2048, 858, 536), (1998, 1080, 692),
                                      (640, 480, 960), (1000, 3, 4)):
            self.write("a.vid", flight(picture={"width": width, "height": height}))
            self.assertEqual(self.size_of(), (1280, wanted))
            self.assertEqual(self.size_of("--size", "500"),
                             (500, max(1, int(500 * height / width + 0.5))))
            self.assertEqual(self.size_of("--size", "300x200"), (300, 200))
        self.write("a.vid", flight())
        self.assertEqual(self.size_of("--whole-window"), (1280, 800))

    def test_edge_to_edge(self):
        self.write("a.obj", TRIANGLE)
        for width, height in ((2048, 858), (1998, 1080), (858, 2048), (1920, 1080)):
            self.write("a.vid", flight("a.obj", picture={"width": width, "height": height}))
            for options in ((), ("--size", "333")):
                rows = self.size_of(*options)[1]
                ground = self.row(rows // 2)[:1]
                self.assertEqual(self.row(0)[:1], ground)
                self.assertEqual(self.row(0)[-1:], ground)
                self.assertEqual(self.row(rows - 1)[-1:], ground)
            # Another format has bars.
            self.size_of("--size", "300x300")
            self.assertNotEqual(self.row(150)[150], self.row(150 if height > width else 0)[0])

    def test_one_number_is_for_the_camera_alone(self):
        self.write("a.vid", flight())
        for options in ((), ("--view", "iso"), ("--view", "top"),
                        ("--view", "camera", "--whole-window")):
            self.refused("screenshot", "a.vid", "-o", "a.png", "--size", "640", *options, status=2,
                         says="--size")
        self.write("a.vds", "")
        self.refused("drive", "--script", "a.vds", "--size", "640", status=2, says="--size")
        for size in ("0", "-5", "16385", "1e3", "x", "640x", "x480", "640x480x1", ""):
            self.refused("screenshot", "a.vid", "-o", "a.png", "--view", "camera", "--size=" + size,
                         status=2, says="--size")
        self.write("high.vid", flight(picture={"width": 1, "height": 20}))
        self.refused("screenshot", "high.vid", "-o", "a.png", "--view", "camera", status=1,
                     says=["25600", "--size"])
        self.assertFalse((self.folder / "a.png").exists())


if __name__ == "__main__":
    program.main()
