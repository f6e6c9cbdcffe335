# SPDX-License-Identifier: MIT
"""Tries ./dev in a made-up checkout, with a made-up apt-get, dpkg-query and sudo.

usage: dev_test.py PATH-OF-DEV
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

DEV = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None

CMAKE = """
cmake_minimum_required(VERSION 3.25)
project(little LANGUAGES C)
add_subdirectory(src/app)
if(EXISTS ${CMAKE_SOURCE_DIR}/tests/fuzz)
  add_subdirectory(tests/fuzz)
endif()
"""
FUZZ_CMAKE = """
add_custom_target(fuzz_targets)
foreach(name fuzz_one fuzz_two)
  add_executable(${name} main.c)
  add_dependencies(fuzz_targets ${name})
endforeach()
"""
PRESETS = """
{"version": 6, "configurePresets": [
  {"name": "release", "generator": "Ninja", "binaryDir": "${sourceDir}/build/release"},
  {"name": "dev", "generator": "Ninja", "binaryDir": "${sourceDir}/build/dev"},
  {"name": "fuzz", "generator": "Ninja", "binaryDir": "${sourceDir}/build/fuzz"}]}
"""
PROGRAM = """
#include <stdio.h>
#include <unistd.h>
int main(int count, char** words) {
  char folder[4096];
  for (int i = 1; i < count; ++i) printf("[%s]", words[i]);
  printf("%s", getcwd(folder, sizeof folder));
  int c = getchar();
  if (c != EOF) printf("%c", c);
  return 7;
}
"""
# The installed packages are the lines of $FAKE/installed, those apt knows of the lines of
# $FAKE/known; every call is a line of $FAKE/calls.
DPKG_QUERY = """#!/bin/sh
echo dpkg-query >> "$FAKE/calls"
sed 's/^/installed /' "$FAKE/installed"
echo 'config-files was-removed'
"""
APT_GET = """#!/bin/bash
[[ -z $(cat) ]] || echo "asks" >> "$FAKE/calls"
command='' packages=()
for word in "$@"; do
  case $word in
    install | update) command=$word ;;
    -o | -* | *::*) ;;
    *) packages+=("$word") ;;
  esac
done
echo "$command ${packages[*]}" >> "$FAKE/calls"
echo "chatter on standard output"
if [[ -s $FAKE/locked ]]; then
  sed -i 1d "$FAKE/locked"
  echo "E: Could not get lock /var/lib/apt/lists/lock." >&2
  exit 100
fi
if [[ $command == update ]]; then
  cp "$FAKE/archive" "$FAKE/known"
else
  for package in "${packages[@]}"; do
    grep -q -x -e "$package" "$FAKE/known" || {
      echo "E: Unable to locate package $package" >&2
      exit 100
    }
  done
  echo "pmstatus:x:50.0:Unpacking x" >&3
  printf '%s\\n' "${packages[@]}" >> "$FAKE/installed"
fi
"""
SUDO = """#!/bin/sh
echo "sudo $*" >> "$FAKE/calls"
exit 1
"""


class Checkout(unittest.TestCase):
    def setUp(self):
        self.box = pathlib.Path(tempfile.mkdtemp(prefix="a dev test "))
        self.addCleanup(shutil.rmtree, self.box)
        self.root = self.box / "with a blank" / "vides"
        app = self.root / "src" / "app"
        app.mkdir(parents=True)
        shutil.copy(DEV, self.root / "dev")
        (self.root / "CMakeLists.txt").write_text(CMAKE)
        (self.root / "CMakePresets.json").write_text(PRESETS)
        (app / "CMakeLists.txt").write_text("add_executable(vides main.c)\n")
        (app / "main.c").write_text(PROGRAM)
        self.fake = self.box / "fake"
        self.fake.mkdir()
        for name, text in (("dpkg-query", DPKG_QUERY), ("apt-get", APT_GET), ("sudo", SUDO)):
            (self.fake / name).write_text(text)
            (self.fake / name).chmod(0o755)
        self.packages("# the one that matters\ncompiler # with a remark\n\n", "compiler", "compiler")

    def packages(self, listed, installed, known, archive=""):
        (self.root / "packages.txt").write_text(listed)
        for name, text in (("installed", installed), ("known", known), ("archive", archive)):
            (self.fake / name).write_text("".join(word + "\n" for word in text.split()))
        (self.fake / "calls").write_text("")

    def dev(self, *words, cwd=None, before=(), stdin=b""):
        env = dict(os.environ, FAKE=str(self.fake), PATH=f"{self.fake}:{os.environ['PATH']}",
                   CCACHE_DISABLE="1")
        run = subprocess.run([*before, self.root / "dev", *words], cwd=cwd or self.box, env=env,
                             input=stdin, capture_output=True, check=False)
        return run.returncode, run.stdout.decode(), run.stderr.decode()

    def calls(self):
        return (self.fake / "calls").read_text().splitlines()


class Building(Checkout):
    def test_run_becomes_the_program(self):
        here = self.box / "elsewhere"
        here.mkdir()
        for _ in range(2):  # the first builds, the second finds it built
            code, out, err = self.dev("run", "a b", "--help", "", cwd=here, stdin=b"x")
            self.assertEqual((code, out), (7, f"[a b][--help][]{here}x"), err)
        self.assertEqual(err, "")

    def test_build_ends_with_the_path(self):
        code, out, _ = self.dev("build")
        program = pathlib.Path(out.splitlines()[-1])
        self.assertEqual(code, 0)
        self.assertTrue(program.is_absolute() and os.access(program, os.X_OK), out)

    def test_through_a_link(self):
        (self.box / "link").symlink_to(self.root / "dev")
        run = subprocess.run([self.box / "link", "help"], capture_output=True, check=False)
        self.assertEqual(run.returncode, 0)
        self.assertIn(b"usage", run.stdout)

    def test_broken_source(self):
        (self.root / "src/app/main.c").write_text("int main(void) { return nonsense; }\n")
        for command in ("run", "build"):
            code, out, err = self.dev(command)
            self.assertEqual((code, out), (1, ""))
            self.assertIn("undeclared", err)

    def test_broken_configuration(self):
        (self.root / "src/app/CMakeLists.txt").write_text("such_a_command()\n")
        for _ in range(2):  # a failure must not count as configured
            code, out, err = self.dev("run")
            self.assertEqual((code, out), (1, ""))
            self.assertIn("such_a_command", err)

    def test_changes_are_built(self):
        self.dev("build")
        (self.root / "src/app/main.c").write_text("int main(void) { return 9; }\n")
        self.assertEqual(self.dev("run"), (9, "", ""))

    def test_moved_checkout(self):
        self.dev("build")
        moved = self.box / "moved"
        self.root.rename(moved)
        self.root = moved
        self.assertEqual(self.dev("run")[0], 7)

    def test_several_at_once(self):
        env = dict(os.environ, FAKE=str(self.fake), PATH=f"{self.fake}:{os.environ['PATH']}",
                   CCACHE_DISABLE="1")
        runs = [subprocess.Popen([self.root / "dev", "run"], cwd=self.box, env=env,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE) for _ in range(4)]
        for run in runs:
            out, err = run.communicate(timeout=120)
            self.assertEqual((run.returncode, out.decode()), (7, str(self.box)), err.decode())

    def test_unknown_command(self):
        code, out, err = self.dev("rnu")
        self.assertEqual((code, out), (2, ""))
        self.assertIn("no command 'rnu'", err)

    def test_clean(self):
        self.dev("build")
        self.assertEqual(self.dev("clean")[0], 0)
        self.assertFalse((self.root / "build").exists())


class Fuzzing(Checkout):
    def setUp(self):
        super().setUp()
        fuzz = self.root / "tests" / "fuzz"
        (fuzz / "corpus" / "fuzz_one").mkdir(parents=True)
        (fuzz / "CMakeLists.txt").write_text(FUZZ_CMAKE)
        (fuzz / "fuzz_two.dict").write_text("")
        (fuzz / "main.c").write_text("""
            #include <stdio.h>
            int main(int count, char** words) {
              for (int i = 0; i < count; ++i) printf("[%s]", words[i]);
              return 0;
            }""")

    def test_builds_the_targets_only_and_runs_each(self):
        (self.root / "src/app/main.c").write_text("int main(void) { return nonsense; }\n")
        code, out, err = self.dev("fuzz", "-runs=7")
        self.assertEqual(code, 0, err)
        for name in ("fuzz_one", "fuzz_two"):
            self.assertEqual(out.count(f"build/fuzz/tests/fuzz/{name}]"), 1, out)
        self.assertEqual(out.count("[-runs=7]"), 2)
        self.assertEqual(out.count("tests/fuzz/corpus/fuzz_one]"), 1)
        self.assertEqual(out.count("-dict="), 1)

    def test_those_that_are_named(self):
        code, out, _ = self.dev("fuzz", "fuzz_two", "-runs=7")
        self.assertEqual(code, 0)
        self.assertNotIn("tests/fuzz/fuzz_one]", out)
        code, out, err = self.dev("fuzz", "fuzz_three")
        self.assertEqual((code, out), (1, ""))
        self.assertIn("no such fuzz targets: fuzz_three", err)

    def test_what_is_found_is_told(self):
        source = self.root / "tests" / "fuzz" / "main.c"
        source.write_text("int main(void) { return 1; }\n")
        code, _, err = self.dev("fuzz")
        self.assertEqual(code, 1)
        self.assertIn("fuzz_one found something", err)


class Packages(Checkout):
    def test_nothing_missing(self):
        self.assertEqual(self.dev("run")[0], 7)
        self.assertEqual(self.calls(), ["dpkg-query"])
        self.assertEqual(self.dev("run")[0], 7)
        self.assertEqual(self.calls(), ["dpkg-query"], "the second start asks again")

    def test_a_changed_list_is_looked_at(self):
        self.dev("run")
        self.packages("compiler\nother\n", "compiler other", "")
        self.assertEqual(self.dev("run")[0], 7)
        self.assertEqual(self.calls(), ["dpkg-query"])

    @unittest.skipIf(os.geteuid() != 0, "needs root")
    def test_only_the_missing_and_no_update(self):
        self.packages("compiler\nlibrary\n", "compiler", "compiler library")
        code, out, err = self.dev("run")
        self.assertEqual((code, out), (7, str(self.box)), err)
        self.assertEqual(self.calls(), ["dpkg-query", "install library", "dpkg-query"])
        self.assertIn("installing 1 missing", err)
        self.assertNotIn("chatter", err)

    @unittest.skipIf(os.geteuid() != 0, "needs root")
    def test_update_when_the_lists_are_old(self):
        self.packages("library\nwas-removed\n", "", "", "library was-removed")
        code, _, err = self.dev("run")
        self.assertEqual(code, 7, err)
        names = "library was-removed"
        self.assertEqual(self.calls(), ["dpkg-query", f"install {names}", "update ",
                                        f"install {names}", "dpkg-query"])

    @unittest.skipIf(os.geteuid() != 0, "needs root")
    def test_waits_for_another_apt(self):
        self.packages("library\n", "", "library")
        (self.fake / "locked").write_text("once\n")
        code, _, err = self.dev("run")
        self.assertEqual(code, 7, err)
        self.assertEqual(self.calls(), ["dpkg-query", "install library", "install library",
                                        "dpkg-query"])
        self.assertIn("waiting for another package manager", err)

    @unittest.skipIf(os.geteuid() != 0, "needs root")
    def test_not_to_be_had(self):
        self.packages("library\n", "", "", "")
        code, out, err = self.dev("run")
        self.assertEqual((code, out), (1, ""))
        self.assertIn("Unable to locate package library", err)
        self.assertIn("could not install: library", err)
        self.assertFalse((self.root / "build" / ".packages").exists())

    @unittest.skipIf(os.geteuid() != 0, "needs root, to be somebody else")
    def test_without_root(self):
        self.packages("compiler\nlibrary\n", "compiler", "library")
        for path in (self.box, *self.box.rglob("*")):
            os.chown(path, 65534, 65534)
        other = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
        code, out, err = self.dev("test", before=other)
        self.assertEqual((code, out), (1, ""))
        self.assertIn("only root may install them: library", err)
        self.assertEqual([call for call in self.calls() if "install" in call], [])


if __name__ == "__main__":
    assert DEV is not None, __doc__
    unittest.main()
