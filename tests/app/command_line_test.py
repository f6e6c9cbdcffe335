# SPDX-License-Identifier: MIT
"""What the command line accepts and refuses, and what it says about itself."""

import re
import shlex

from program import FLIGHTS, NAMES, PYRAMID, SOURCE, ProgramTest, environment, main


class Help(ProgramTest):
    OPTIONS = {
        "": ["--help", "--version", "FLIGHT", "frames", "info", "check", "screenshot", "drive"],
        "frames": ["--help", "--version", "FLIGHT", "-o", "--output", "--format", "--space",
                   "--range", "--first-frame", "vides", "csv", "json", "chan", "cube", "world",
                   "A:B", "ZXY"],
        "info": ["--help", "--version", "FLIGHT", "--json"],
        "check": ["--help", "--version", "FLIGHT", "FILE: POINTER: MESSAGE"],
        "screenshot": ["--help", "--version", "FLIGHT", "-o", "--output", "--size", "--scale",
                       "--view", "iso", "front", "side", "top", "camera", "--frame",
                       "--whole-window", "--allow-missing-scenes"],
        "drive": ["--help", "--version", "FLIGHT", "--script", "--size", "--scale",
                  "--language", "--setup", "--allow-missing-scenes"],
    }

    def test_help_mentions_everything(self):
        for command, words in self.OPTIONS.items():
            for flag in ("--help", "-h"):
                text = self.output_of(*([command] if command else []), flag).decode()
                for word in words:
                    self.assertIn(word, text, command)

    def test_help_offers_only_what_works(self):
        text = self.output_of("--help").decode()
        for later in ("render", "convert"):
            self.assertNotIn(later, text)
            self.refused(later, PYRAMID, status=2, says="neither a command nor a file")

    def test_help_fits_the_screen(self):
        for command in self.OPTIONS:
            for line in self.output_of(*([command] if command else []), "--help").splitlines():
                self.assertLessEqual(len(line), 110, line)

    def test_version_everywhere(self):
        version = re.search(r"project\(vides VERSION (\S+)",
                            (SOURCE / "CMakeLists.txt").read_text()).group(1)
        for command in self.OPTIONS:
            text = self.output_of(*([command] if command else []), "--version")
            self.assertEqual(text.decode(), f"vides {version}\n")

    def test_help_needs_no_operands(self):
        self.assertEqual(self.output_of("frames", "nowhere.vid", "--help"),
                         self.output_of("frames", "--help"))


class Wrong(ProgramTest):
    def test_mistyped_commands(self):
        for typed, meant in (("frmaes", "frames"), ("frame", "frames"), ("ifno", "info"),
                             ("chekc", "check"), ("inf", "info"), ("help", "--help")):
            self.refused(typed, PYRAMID, status=2, says=f"did you mean '{meant}'?")
            self.refused(typed, PYRAMID, "--format", "csv", status=2,
                         says=f"did you mean '{meant}'?")
        done = self.run_vides("xylophone")
        self.assertEqual(done.returncode, 2)
        self.assertNotIn(b"did you mean", done.stderr)

    def test_mistyped_options(self):
        self.refused("frames", PYRAMID, "--formt", "csv", status=2, says="did you mean '--format'?")
        self.refused("frames", PYRAMID, "--spaec=cube", status=2, says="did you mean '--space'?")
        self.refused("info", PYRAMID, "--jsno", status=2, says="did you mean '--json'?")
        self.refused("--versoin", status=2, says="did you mean '--version'?")

    def test_missing_operands(self):
        for command in ("frames", "info", "check"):
            self.refused(command, status=2, says=["FLIGHT", f"see vides {command} --help"])

    def test_too_many_operands(self):
        self.refused("frames", PYRAMID, "second.vid", status=2, says="'second.vid'")
        self.refused("info", PYRAMID, "second.vid", status=2, says="'second.vid'")
        self.refused("first.vid", "second.vid", status=2, says="'second.vid'")
        self.refused("first.vid", "frames", PYRAMID, status=2, says="'first.vid'")

    def test_values(self):
        self.refused("frames", PYRAMID, "--format", "cvs", status=2, says="did you mean 'csv'?")
        self.refused("frames", PYRAMID, "--format", "gltf", status=2,
                     says="vides, csv, json, chan")
        self.refused("frames", PYRAMID, "--format", "", status=2, says="--format")
        self.refused("frames", PYRAMID, "--format", "CSV", status=2, says="--format")
        self.refused("frames", PYRAMID, "--space", "earth", status=2, says="--space")
        self.refused("frames", PYRAMID, "--range", status=2, says="--range")
        self.refused("frames", PYRAMID, "--format", "csv", "--format", "json", status=2,
                     says="--format")

    def test_ranges(self):
        for text in ("5:5", "6:5", "0:0", ":0", "5", "", "a:b", "1:2:3", "-1:5", "1:-5", "1.5:3",
                     "0x1:3", " 1:3", "1:3 ", "99999999999999999999:", "1-3"):
            self.refused("frames", PYRAMID, f"--range={text}", status=2, says="--range")

    def test_first_frame(self):
        for text in ("a", "", "1.5", "1e3", "9999999999999"):
            self.refused("frames", PYRAMID, "--format=chan", f"--first-frame={text}", status=2,
                         says="--first-frame")
        self.refused("frames", PYRAMID, "--first-frame=1", status=2, says="chan")
        self.refused("frames", PYRAMID, "--format=csv", "--first-frame=1", status=2, says="chan")

    def test_the_flight_is_not_overwritten(self):
        mine = self.folder / "mine.vid"
        mine.write_bytes((FLIGHTS / "two-keys.vid").read_bytes())
        (self.folder / "link").symlink_to(mine)
        for name in ("mine.vid", "link", "./mine.vid"):
            self.refused("frames", "mine.vid", "-o", name, status=2, says="overwritten")
        self.assertEqual(mine.read_bytes(), (FLIGHTS / "two-keys.vid").read_bytes())


class Order(ProgramTest):
    def test_options_before_and_after_file_names(self):
        wanted = self.output_of("frames", PYRAMID, "--format", "csv", "--range", "3:9")
        self.assertEqual(wanted.count(b"\n"), 7)
        for arguments in (("--format", "csv", PYRAMID, "--range", "3:9"),
                          ("--range", "3:9", "--format", "csv", PYRAMID),
                          ("--range=3:9", PYRAMID, "--format=csv"),
                          (PYRAMID, "--format=csv", "--range=3:9", "-o", "-"),
                          ("-o-", PYRAMID, "--format=csv", "--range=3:9"),
                          ("--format=csv", "--range=3:9", "--output=-", "--", PYRAMID)):
            self.assertEqual(self.output_of("frames", *arguments), wanted, arguments)

    def test_files_with_odd_names(self):
        flight = (FLIGHTS / "two-keys.vid").read_bytes()
        wanted = self.output_of("frames", FLIGHTS / "two-keys.vid")
        for name in ("info", "frames", "with blanks.vid", "Überflug.vid", "--x.vid", "a=b:c"):
            (self.folder / name).write_bytes(flight)
            self.assertEqual(self.output_of("frames", "--", name), wanted, name)
            out = f"{name}.txt"
            self.assertEqual(self.output_of("frames", f"-o{out}", "--", name), b"")
            self.assertEqual((self.folder / out).read_bytes(), wanted)


# As `./dev run` starts it.
def sample(**changes):
    return environment(VIDES_WITHOUT_DISPLAY="sample", **changes)


class WithoutDisplay(ProgramTest):
    def test_it_is_told(self):
        self.refused(status=1, says=["no display", "vides frames", "vides info", "vides check",
                                     "vides screenshot", "vides drive"])
        self.assert_folder_empty()

    def test_no_arguments_write_the_sample(self):
        for _ in range(2):  # over the first one's file, too
            text = self.output_of(env=sample()).decode()
            for word in ("out/pyramid.txt", "778", "Around the pyramid", "vides info",
                         "vides frames", "vides check", "--help"):
                self.assertIn(word, text)
            self.assertEqual(sorted(str(p.relative_to(self.folder)) for p in
                                    self.folder.rglob("*")), ["out", "out/pyramid.txt"])
            self.assertEqual((self.folder / "out" / "pyramid.txt").read_bytes(),
                             (FLIGHTS / "pyramid-smooth.frames.txt").read_bytes())

    def test_what_it_says_to_try_works(self):
        text = self.output_of(env=sample()).decode()
        tried = 0
        for line in text.splitlines():
            if line.startswith("  vides ") and "FLIGHT" not in line:
                self.output_of(*shlex.split(line)[1:])
                tried += 1
        self.assertEqual(tried, 4)
        self.assertTrue((self.folder / "out" / "pyramid.chan").exists())

    def test_the_sample_can_lie_elsewhere(self):
        (self.folder / "flights").mkdir()
        (self.folder / "flights" / "pyramid.vid").write_bytes(
            (FLIGHTS / "two-keys.vid").read_bytes())
        text = self.output_of(env=sample(VIDES_ASSETS=str(self.folder)))
        self.assertIn(b"101 frames", text)
        self.refused(status=1, says="flights/pyramid.vid",
                     env=sample(VIDES_ASSETS=str(self.folder / "nowhere")))

    def test_a_folder_that_a_shell_would_split_is_quoted(self):
        flights = self.folder / "Anna's new $films" / "flights"
        flights.mkdir(parents=True)
        (flights / "pyramid.vid").write_bytes((FLIGHTS / "two-keys.vid").read_bytes())
        for line in self.output_of(env=sample(
                VIDES_ASSETS=str(flights.parent))).decode().splitlines():
            if line.startswith("  vides info"):
                self.assertEqual(shlex.split(line)[2:],
                                 ["Anna's new $films/flights/pyramid.vid"])
                return
        self.fail("nothing to try")

    def test_out_is_in_the_way(self):
        (self.folder / "out").write_text("mine")
        self.refused(status=1, says="out", env=sample())
        self.assertEqual((self.folder / "out").read_text(), "mine")

    def test_a_flight_needs_a_display(self):
        self.refused(PYRAMID, status=1,
                     says=["no display", "vides frames", "vides info", "vides check"])
        self.assert_folder_empty()


class Locales(ProgramTest):
    def test_the_same_in_german(self):
        import os
        german = environment(LC_ALL="de_DE.UTF-8", LANG="de_DE.UTF-8", LANGUAGE="de",
                             LOCPATH=os.environ["VIDES_TEST_LOCPATH"])
        runs = [("frames", PYRAMID, f"--format={f}") for f in ("vides", "csv", "json", "chan")]
        runs += [("info", PYRAMID), ("info", "--json", PYRAMID), ("--help",), ("frames", "--help")]
        for arguments in runs:
            self.assertEqual(self.output_of(*arguments), self.output_of(*arguments, env=german))
        for arguments in (("frames", "nowhere.vid"), ("frmaes",), ("frames", "--bogus", "x"),
                          ("frames", PYRAMID, "-o", "no/such/folder")):
            plain, other = self.run_vides(*arguments), self.run_vides(*arguments, env=german)
            self.assertEqual((plain.returncode, plain.stderr), (other.returncode, other.stderr))
            self.assertNotEqual(plain.returncode, 0)


class Samples(ProgramTest):
    def test_samples_are_right_and_refer_to_their_scene(self):
        folder = SOURCE / "assets" / "flights"
        samples = sorted(folder.glob("*.vid"))
        self.assertEqual([p.stem for p in samples], ["closed-orbit", "dolly", "pyramid"])
        self.assertEqual(self.output_of("check", *samples), b"")
        for sample in samples:
            self.assertIn('"../scenes/pyramid.obj"', sample.read_text())
            self.assertIn(b"Frames outside cube     0\n", self.output_of("info", sample))
        self.assertTrue((folder / "../scenes/pyramid.obj").exists())

    def test_the_pyramid_is_that_of_the_reference(self):
        for form in ("vides", "csv"):
            self.assertEqual(
                self.output_of("frames", SOURCE / "assets/flights/pyramid.vid", "--format", form),
                self.output_of("frames", PYRAMID, "--format", form))

    def test_reference_flights_are_there(self):
        self.assertGreaterEqual(len(NAMES), 24)


if __name__ == "__main__":
    main()
