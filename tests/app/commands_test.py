# SPDX-License-Identifier: MIT
"""What frames, info and check do with flights: results, files, standard input, failures."""

import json
import os
import pathlib
import pty
import select
import signal
import struct
import subprocess
import time

from program import FLIGHTS, LONG, NAMES, PROGRAM, PYRAMID, ProgramTest, environment, main


class Frames(ProgramTest):
    def test_reference_flights(self):
        for name in NAMES:
            flight = FLIGHTS / f"{name}.vid"
            wanted = (FLIGHTS / f"{name}.frames.txt").read_bytes()
            self.assertEqual(self.output_of("frames", flight), wanted, name)
            rows = self.output_of("frames", flight, "--format=csv").decode().splitlines()
            wanted = (FLIGHTS / f"{name}.frames.csv").read_text().splitlines()
            self.assertEqual(len(rows), len(wanted))
            self.assertEqual(rows[0], wanted[0])
            for row, want in zip(rows[1:], wanted[1:]):
                a, b = row.split(","), want.split(",")
                self.assertEqual(a[3], b[3])
                for k in (0, 1, 2, *range(4, 14)):
                    self.assertLessEqual(abs(float(a[k]) - float(b[k])), 1e-9, (name, row))

    def test_standard_input(self):
        with open(PYRAMID, "rb") as flight:
            self.assertEqual(self.output_of("frames", "-", stdin=flight),
                             self.output_of("frames", PYRAMID))
        self.assertEqual(self.output_of("frames", "-", "-o", "-", input=LONG.encode())[:6],
                         b"0.0000")

    def test_output_files(self):
        for form in ("vides", "csv", "json", "chan"):
            out = self.folder / f"frames.{form}"
            out.write_text("old\n" * 100_000)
            os.chmod(out, 0o640)
            self.assertEqual(self.output_of("frames", PYRAMID, f"--format={form}", "-o", out), b"")
            self.assertEqual(out.read_bytes(),
                             self.output_of("frames", PYRAMID, f"--format={form}"))
            self.assertEqual(out.stat().st_mode & 0o777, 0o640)
        self.assertEqual(len(list(self.folder.iterdir())), 4)

    def test_the_editor_writes_the_same(self):
        """Output -> Frames…, operated widget by widget, against the same options here."""
        choices = (("vides", "cube", 0, 777, 1), ("csv", "world", 3, 20, 1),
                   ("json", "world", 700, 776, 1), ("chan", "world", 10, 50, 1001),
                   ("chan", "cube", 0, 0, -5))
        script = [f'open "{PYRAMID}"', "do set-space 1 2 3 40", 'save "moved.vid"']
        for i, (form, space, first, last, number) in enumerate(choices):
            script += ["click menu/output/frames", "frame 2", "click frames/all",
                       f"set frames/format {form}", f"set frames/space {space}",
                       f"set frames/last {last}", f"set frames/first {first}",
                       f'set frames/file "{i}.out"']
            if form == "chan":
                script.append(f"set frames/first_number {number}")
            script += ["click frames/write", f'expect_output "{i}.out"', "frame 2"]
        (self.folder / "script.vds").write_text("\n".join(script))
        self.output_of("drive", "--script", "script.vds")
        for i, (form, space, first, last, number) in enumerate(choices):
            chan = [f"--first-frame={number}"] if form == "chan" else []
            wanted = self.output_of("frames", "moved.vid", f"--format={form}", f"--space={space}",
                                    f"--range={first}:{last + 1}", *chan)
            self.assertGreater(len(wanted), 40)
            self.assertEqual((self.folder / f"{i}.out").read_bytes(), wanted, (form, space))

    def test_same_bytes_on_two_runs(self):
        for form in ("vides", "csv", "json", "chan"):
            self.assertEqual(self.output_of("frames", PYRAMID, f"--format={form}"),
                             self.output_of("frames", PYRAMID, f"--format={form}"))

    def test_ranges(self):
        lines = self.output_of("frames", PYRAMID).splitlines(keepends=True)
        for text, wanted in (("0:1", lines[:1]), ("5:8", lines[5:8]), (":7", lines[:7]),
                             ("770:", lines[770:]), (":", lines), ("700:99999", lines[700:]),
                             ("700:" + "9" * 40, lines[700:]),
                             ("778:", []), ("900:901", []), ("0000005:8", lines[5:8])):
            self.assertEqual(self.output_of("frames", PYRAMID, "--range", text), b"".join(wanted))
        head = self.output_of("frames", PYRAMID, "--range=900:901", "--format=csv")
        self.assertEqual(head.count(b"\n"), 1)
        nothing = json.loads(self.output_of("frames", PYRAMID, "--range=900:", "--format=json"))
        self.assertEqual(nothing["frames"], [])

    def test_space(self):
        flight = json.loads((FLIGHTS / "pyramid-smooth.vid").read_text())
        flight["space"] = {"center": [100, 0, -7], "half_size": 10}
        (self.folder / "far.vid").write_text(json.dumps(flight))

        def position(*options):
            row = self.output_of("frames", "far.vid", "--range=0:1", *options).decode().split("\n")
            return row

        cube, world = "0.9000 -0.1000 0.2000 ", "109.0000 -1.0000 -5.0000 "
        self.assertTrue(position()[0].startswith(cube))
        self.assertTrue(position("--space=cube")[0].startswith(cube))
        self.assertTrue(position("--space=world")[0].startswith(world))
        self.assertEqual(position("--space=world")[0][len(world):], position()[0][len(cube):])
        self.assertIn(",109,-1,-5,", position("--space=world", "--format=csv")[1])
        self.assertIn('"vrp":[109,-1,-5]', position("--space=world", "--format=json")[1])
        self.assertIn('"vrp":[0.9,-0.1,0.2]', position("--format=json")[1])
        self.assertTrue(position("--format=chan")[0].startswith("1 109.000000 -1.000000 -5.000000 "))
        self.assertTrue(
            position("--format=chan", "--space=cube")[0].startswith("1 0.900000 -0.100000 0.2"))

    def test_first_frame(self):
        for number, wanted in (("1001", b"1006 "), ("0", b"5 "), ("-10", b"-5 "), ("+3", b"8 ")):
            text = self.output_of("frames", PYRAMID, "--format=chan", "--range=5:6",
                                  f"--first-frame={number}")
            self.assertTrue(text.startswith(wanted), text)

    def test_bad_flights(self):
        self.refused("frames", "nowhere.vid", status=1, says=["nowhere.vid", "No such file"])
        self.refused("frames", self.folder, status=1, says=str(self.folder))
        self.refused("frames", "-", input=b"", status=1, says="-:")
        (self.folder / "bad.vid").write_text('{"format": "vides", "version": 1, "keys": [1, 2]}')
        self.refused("frames", "bad.vid", "-o", "out.txt", status=1,
                     says=["bad.vid: /keys/0: ", "bad.vid: /keys/1: "])
        self.refused("info", "bad.vid", status=1, says="bad.vid: /keys/0: ")
        self.assertFalse((self.folder / "out.txt").exists())

    def test_where_nothing_can_be_written(self):
        for out in ("no/such/folder.txt", ".", "/proc/nothing"):
            self.refused("frames", PYRAMID, "-o", out, status=1, says=f"{out}: ")
        self.assert_folder_empty()

    def test_a_full_disk(self):
        self.refused("frames", PYRAMID, "-o", "/dev/full", status=1, says="No space left")
        for arguments in (("frames", PYRAMID), ("info", PYRAMID), ("info", "--json", PYRAMID),
                          ("--help",), ("--version",), ()):
            with open("/dev/full", "wb") as full:
                done = self.run_vides(*arguments, stdout=full,
                                      env=environment(VIDES_WITHOUT_DISPLAY="sample"))
            self.assertEqual(done.returncode, 1, arguments)
            self.assertIn(b"No space left", done.stderr)

    def test_a_closed_standard_output(self):
        done = subprocess.run(["sh", "-c", 'exec "$0" "$@" >&-', PROGRAM, "frames", PYRAMID],
                              stderr=subprocess.PIPE, env=environment(), check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"standard output", done.stderr)

    def test_a_closed_pipe_ends_quietly(self):
        (self.folder / "long.vid").write_text(LONG)
        for ignored in (False, True):
            reader, writer = os.pipe()
            process = subprocess.Popen(
                [PROGRAM, "frames", "long.vid"], cwd=self.folder, env=environment(),
                stdout=writer, stderr=subprocess.PIPE, restore_signals=not ignored)
            os.close(writer)
            self.assertTrue(os.read(reader, 100))
            os.close(reader)
            self.assertEqual(process.communicate(timeout=120)[1], b"")
            self.assertEqual(process.returncode, -signal.SIGPIPE, ignored)


class Screenshot(ProgramTest):
    def size_of(self, picture):
        self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
        return struct.unpack(">II", picture[16:24])

    def test_to_a_file_and_to_standard_output(self):
        out = self.folder / "shot.png"
        self.assertEqual(self.output_of("screenshot", PYRAMID, "-o", out), b"")
        self.assertEqual(self.size_of(out.read_bytes()), (1280, 800))
        self.assertEqual(self.output_of("screenshot", PYRAMID, "-o", "-"), out.read_bytes())
        self.assertEqual([p.name for p in self.folder.iterdir()], ["shot.png"])

    def test_each_view_is_another_picture_of_the_size(self):
        pictures = {self.output_of("screenshot", PYRAMID, "-o", "-", "--size", "320x200", *view)
                    for view in (["--view", "front"], ["--view", "side"], ["--view", "top"],
                                 ["--view", "iso"], ["--view", "camera"], ["--whole-window"],
                                 ["--view", "camera", "--frame", "298"])}
        self.assertEqual(len(pictures), 7)
        self.assertEqual({self.size_of(picture) for picture in pictures}, {(320, 200)})

    def test_what_cannot_be_is_refused(self):
        self.refused("screenshot", PYRAMID, "-o", "a.png", "--frame", "778", status=1,
                     says=["778", "777"])
        self.refused("screenshot", PYRAMID, "-o", "no/a.png", status=1, says="no/a.png")
        self.refused("screenshot", "none.vid", "-o", "a.png", status=1, says="none.vid")
        self.refused("screenshot", PYRAMID, "-o", "a.png", "--view", "below", status=2,
                     says="below")
        self.assert_folder_empty()


class Interrupted(ProgramTest):
    def test_leaves_nothing(self):
        (self.folder / "long.vid").write_text(LONG)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for old in (None, b"old"):
                out = self.folder / "out.json"
                if old is not None:
                    out.write_bytes(old)
                process = subprocess.Popen(
                    [PROGRAM, "frames", "long.vid", "--format=json", "-o", "out.json"],
                    cwd=self.folder, env=environment(), stdin=subprocess.DEVNULL)
                self.wait_for_bytes(process)
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=60), -number)
                left = sorted(p.name for p in self.folder.iterdir())
                if old is None:
                    self.assertEqual(left, ["long.vid"])
                else:
                    self.assertEqual(left, ["long.vid", "out.json"])
                    self.assertEqual(out.read_bytes(), old)
                    out.unlink()

    def wait_for_bytes(self, process):
        """Until the temporary file has grown: the writing is under way. It may have no name."""
        for _ in range(60_000):
            for file in pathlib.Path(f"/proc/{process.pid}/fd").iterdir():
                try:
                    if "/.vides-" in os.readlink(file) or "(deleted)" in os.readlink(file):
                        if file.stat().st_size > 100_000:
                            return
                except FileNotFoundError:
                    pass
            time.sleep(0.001)
        self.fail("nothing was written")


class ProgressBar(ProgramTest):
    def on_terminal(self, **changes):
        """What goes to a terminal as standard error while a long flight is written."""
        (self.folder / "long.vid").write_text(LONG)
        ours, theirs = pty.openpty()
        process = subprocess.Popen(
            [PROGRAM, "frames", "long.vid", "--format=json", "-o", "/dev/null"], cwd=self.folder,
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=theirs,
            env=environment(**({"TERM": "xterm"} | changes)))
        os.close(theirs)
        text = b""
        while select.select([ours], [], [], 120)[0]:
            try:
                part = os.read(ours, 4096)
            except OSError:  # the other end is closed
                break
            if not part:
                break
            text += part
        os.close(ours)
        self.assertEqual(process.wait(timeout=120), 0)
        return text

    def test_bar(self):
        text = self.on_terminal()
        self.assertIn(b"Writing frames [", text)
        self.assertIn(b"#", text)
        self.assertIn(b" %", text)
        self.assertIn(b"\033[36m", text)
        self.assertTrue(text.endswith(b"\r\033[K"), text[-40:])

    def test_no_colour(self):
        text = self.on_terminal(NO_COLOR="1")
        self.assertIn(b"Writing frames [", text)
        self.assertNotIn(b"\033[3", text)

    def test_dumb_terminals_get_none(self):
        self.assertEqual(self.on_terminal(TERM="dumb"), b"")

    def test_only_on_terminals(self):
        (self.folder / "long.vid").write_text(LONG)
        self.assertEqual(
            self.output_of("frames", "long.vid", "--format=json", "-o", "/dev/null"), b"")


class Info(ProgramTest):
    MEMBERS = ["keys", "orientations", "frames", "seconds", "length", "sections", "quality"]
    SECTION = ["index", "kind", "from", "to", "length", "angle_deg", "frames", "seconds",
               "first_frame"]
    QUALITY = ["max_speed", "max_angular_speed_deg", "max_speed_jump", "max_angular_speed_jump",
               "frames_outside_cube"]

    def test_reference_flights(self):
        for name in NAMES:
            flight = json.loads((FLIGHTS / f"{name}.vid").read_text())
            info = json.loads(self.output_of("info", "--json", FLIGHTS / f"{name}.vid"))
            self.assertEqual(list(info), self.MEMBERS)
            self.assertEqual(list(info["quality"]), self.QUALITY)
            self.assertEqual(info["keys"], len(flight["keys"]))
            self.assertEqual(info["orientations"],
                             sum(len(key["orientations"]) for key in flight["keys"]))
            count = (FLIGHTS / f"{name}.frames.txt").read_text().count("\n")
            self.assertEqual(info["frames"], count)
            self.assertAlmostEqual(info["seconds"], count / flight["frame_rate"], 12)
            wanted = json.loads((FLIGHTS / f"{name}.sections.json").read_text())
            self.assertEqual(len(info["sections"]), len(wanted))
            for section, want in zip(info["sections"], wanted):
                self.assertEqual(list(section), self.SECTION)
                self.assertAlmostEqual(section["seconds"],
                                       section["frames"] / flight["frame_rate"], 12)
                for member, value in want.items():
                    if isinstance(value, float):
                        self.assertAlmostEqual(section[member], value, 9, (name, member))
                    else:
                        self.assertEqual(section[member], value, (name, member))

    def test_measures_are_those_of_the_frames(self):
        for name in ("pyramid-smooth", "random-103", "tracking-over-the-pole"):
            info = json.loads(self.output_of("info", "--json", FLIGHTS / f"{name}.vid"))
            rate = json.loads((FLIGHTS / f"{name}.vid").read_text())["frame_rate"]
            rows = [[float(x) for x in line.split(",")[4:7]] for line in
                    (FLIGHTS / f"{name}.frames.csv").read_text().splitlines()[1:]]
            steps = [rate * sum((x - y) ** 2 for x, y in zip(a, b)) ** 0.5
                     for a, b in zip(rows, rows[1:])]
            jumps = [abs(b - a) / max(a, b) for a, b in zip(steps, steps[1:]) if max(a, b) >= 1e-9]
            self.assertAlmostEqual(info["quality"]["max_speed"], max(steps), 9)
            self.assertAlmostEqual(info["quality"]["max_speed_jump"], max(jumps), 6)
            self.assertEqual(info["quality"]["frames_outside_cube"],
                             sum(max(map(abs, row)) > 1 + 1e-9 for row in rows))

    def test_what_is_given_in_seconds_does_not_drift(self):
        """100 sections of 3/11 s at 24 a second are 27.27 s; rounded one by one they were 29.2."""
        keys = [{"position": [-0.99 + 0.0198 * k, 0, 0],
                 "orientations": [{"aim": [0, 1, 3], "duration": 0.27272727}]}
                for k in range(101)]
        (self.folder / "beat.vid").write_text(json.dumps(
            {"format": "vides", "version": 1, "frame_rate": 24, "keys": keys}))
        text = self.output_of("info", "--json", "beat.vid").decode()
        self.assertIn('"frames":656,"seconds"', text)
        info = json.loads(text)
        for i, section in enumerate(info["sections"]):
            self.assertAlmostEqual(section["first_frame"], i * 0.27272727 * 24, delta=0.5 + 1e-6)
        # The last frame of an open flight is in the total alone.
        self.assertEqual(sum(section["frames"] for section in info["sections"]), 655)
        self.assertIn("656 (0 to 655, 24 a second)", self.output_of("info", "beat.vid").decode())

    def test_text(self):
        text = self.output_of("info", PYRAMID).decode()
        for word in ("Around the pyramid", "6 (open)", "10", "778", "31.12", "5.9953", "move",
                     "pan", "roll", "zoom", "4.4", "Top speed", "Top turn rate",
                     "Frames outside cube"):
            self.assertIn(word, text)
        table = [line for line in text.splitlines() if line.lstrip()[:1].isdigit()]
        self.assertEqual(len(table), 9)
        self.assertEqual(len({len(line) for line in table}), 1)  # aligned

    def test_text_from_standard_input_without_a_name(self):
        text = self.output_of("info", "-", input=LONG.encode()).decode()
        self.assertIn("hold", text)
        self.assertEqual(len({len(line) for line in text.splitlines()
                              if line.lstrip()[:1].isdigit()}), 1)


class Check(ProgramTest):
    def test_right_flights_get_no_word(self):
        self.assertEqual(self.output_of("check", *(FLIGHTS / f"{n}.vid" for n in NAMES)), b"")

    def test_remarks_on_rolls_of_whole_turns(self):
        def flight(*rolls, **members):
            keys = [{"position": [0.5, 0, 0], "orientations":
                     [{"aim": [0, 0, 0], "roll": roll, **members} for roll in rolls]},
                    {"position": [0, 0, 0.5], "orientations": [{"aim": [0, 0, 0]}]}]
            return json.dumps({"format": "vides", "version": 1, "keys": keys}).encode()

        def lines(text):
            done = self.run_vides("check", "-", input=text)
            self.assertEqual(done.returncode, 0)
            self.assertEqual(done.stderr, b"")
            return done.stdout.decode().splitlines()

        self.assertEqual(lines(flight(0, 360)), [
            "-: /keys/0/orientations/1/roll: remark: 360 is a whole turn from 0 at "
            "/keys/0/orientations/0, and nothing else differs: the section between has nothing to "
            "do and no frames"])
        self.assertIn("is a hold", lines(flight(-180, 180, duration=2))[0])
        self.assertIn("3 whole turns", lines(flight(1080, 0))[0])
        self.assertEqual(len(lines(flight(0, 360, 0, 720))), 3)
        for quiet in (flight(0, 180), flight(0, -180), flight(0, 540), flight(10, 10)):
            self.assertEqual(lines(quiet), [])
        # Beside a flight with problems the status is that of the problems.
        (self.folder / "turn.vid").write_bytes(flight(0, 360))
        (self.folder / "bad.vid").write_text('{"format": "vides", "version": 1, "keys": []}')
        done = self.run_vides("check", "turn.vid", "bad.vid")
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"turn.vid: /keys/0/orientations/1/roll: remark: ", done.stdout)
        self.assertIn(b"bad.vid: /keys: ", done.stdout)

    def test_a_line_per_problem(self):
        (self.folder / "bad.vid").write_text(
            '{"format": "vides", "version": 1, "keys": [\n'
            '{"position": [0, 0, 3], "orientations": [{"aim": [0, 0, 0], "zoom": 250}]},\n'
            '{"position": [0, 0, 0.5], "orientations": [{"aim": [0, 0, 0]}], "colour": 1}]}')
        (self.folder / "broken.vid").write_text('{"format": "vides",\n "version": }')
        done = self.run_vides("check", "bad.vid", PYRAMID, "broken.vid", "nowhere.vid")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, b"")
        lines = done.stdout.decode().splitlines()
        self.assertEqual([line.split(": ")[:2] for line in lines[:3]],
                         [["bad.vid", "/keys/0/position/2"],
                          ["bad.vid", "/keys/0/orientations/0/zoom"],
                          ["bad.vid", "/keys/1/colour"]])
        self.assertIn("250", lines[1])
        self.assertTrue(lines[3].startswith("broken.vid:2:"), lines[3])
        self.assertTrue(lines[4].startswith("nowhere.vid: "), lines[4])
        self.assertEqual(len(lines), 5)

    def test_standard_input(self):
        with open(PYRAMID, "rb") as flight:
            self.assertEqual(self.output_of("check", "-", stdin=flight), b"")
        done = self.run_vides("check", "-", input=b'{"format": "vides", "version": 2}')
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"-: /version: ", done.stdout)
        self.assertIn(b"newer vides", done.stdout)


if __name__ == "__main__":
    main()
