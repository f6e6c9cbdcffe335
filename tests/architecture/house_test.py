# SPDX-License-Identifier: MIT
"""Proves that house.py sees each kind of breach, and none in a tree that has none."""

import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

import house

HEAD = "// SPDX-License-Identifier: MIT\n// A file made up for a test.\n"


class Tree(unittest.TestCase):
    """A made-up repository: the files given, and in each folder a CMakeLists.txt naming them."""

    def breaches(self, files, listed=None):
        with tempfile.TemporaryDirectory(prefix="a house ") as name:
            root = pathlib.Path(name)
            for path, text in {"src/math/point.hpp": HEAD, **files}.items():
                path = root / path
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            if listed is None:
                for path in list(root.rglob("*.[ch]*")):
                    with open(path.parent / "CMakeLists.txt", "a", encoding="utf-8") as lists:
                        lists.write(f"  {path.name}\n")
            for path, text in (listed or {}).items():
                (root / path).write_text(text, encoding="utf-8")
            with contextlib.redirect_stderr(io.StringIO()):
                self.status = house.main([str(root)])
            return [
                f"{path.relative_to(root)}:{line}: {message}"
                for path, line, message in house.breaches(root)
            ]

    def assertOne(self, found, *parts):
        self.assertEqual(len(found), 1, found)
        for part in parts:
            self.assertIn(part, found[0])
        self.assertEqual(self.status, 1)

    def test_orderly_tree(self):
        found = self.breaches({
            "src/flight/flight.cpp": HEAD + '#include "math/point.hpp"\n#include <vector>\n',
            "src/panels/keys.cpp": HEAD + "#include <imgui.h>\n",
            "src/render/draw.cpp": HEAD + "#include <GL/gl.h>\n",
            "src/host/window.cpp": HEAD + "#include <GLFW/glfw3.h>\n",
            "src/io/file.hpp": HEAD + "// #include <GL/gl.h>\n/*\n#include <imgui.h>\n*/\n",
            "tests/math/point_test.cpp": HEAD,
        })
        self.assertEqual(found, [])
        self.assertEqual(self.status, 0)

    def test_every_include_to_the_right(self):
        for folder, allowed in house.MAY_INCLUDE.items():
            for other in house.MAY_INCLUDE:
                text = HEAD + f'#include "{other}/x.hpp"\n'
                found = self.breaches({f"src/{folder}/a.cpp": text})
                if other == folder or other in allowed:
                    self.assertEqual(found, [], f"{folder} includes {other}")
                else:
                    self.assertOne(found, f"src/{folder}/a.cpp:3", f"'{other}/x.hpp'")

    def test_the_table_has_no_cycle(self):
        for folder, allowed in house.MAY_INCLUDE.items():
            for other in allowed:
                self.assertNotIn(folder, house.MAY_INCLUDE[other])
                self.assertLessEqual(house.MAY_INCLUDE[other], allowed | {other}, folder)

    def test_core_and_editing_see_no_screen(self):
        headers = ["GL/gl.h", "GLES3/gl3.h", "glad/gl.h", "GLFW/glfw3.h", "EGL/egl.h",
                   "GL/osmesa.h", "X11/Xlib.h", "imgui.h", "imgui/imgui.h", "imgui_internal.h"]
        for folder in ("math", "flight", "evaluate", "io", "scene", "edit"):
            for header in headers:
                for quoted in (f"<{header}>", f'"{header}"', f"  # include <{header}>"):
                    line = quoted if "#" in quoted else f"#include {quoted}"
                    found = self.breaches({f"src/{folder}/a.hpp": HEAD + line + "\n"})
                    self.assertTrue(found, f"{folder}: {line}")
                    self.assertIn(f"src/{folder}/a.hpp:3", found[0])

    def test_panels_see_no_gl_and_app_no_window(self):
        self.assertOne(self.breaches({"src/panels/a.cpp": HEAD + "#include <GL/gl.h>\n"}), "OpenGL")
        self.assertOne(self.breaches({"src/app/a.cpp": HEAD + "#include <GLFW/glfw3.h>\n"}), "window")
        self.assertOne(self.breaches({"src/render/a.cpp": HEAD + "#include <EGL/egl.h>\n"}), "window")
        self.assertOne(self.breaches({"src/io/a.cpp": HEAD + "#include <CLI/CLI.hpp>\n"}), "CLI")

    def test_roundabout_includes(self):
        self.assertOne(
            self.breaches({"src/flight/a.cpp": HEAD + '#include "../io/x.hpp"\n'}), "start at src/")
        self.assertOne(
            self.breaches({"src/math/a.cpp": HEAD + '#include "point.hpp"\n'}), "'math/point.hpp'")
        self.assertOne(
            self.breaches({"src/math/a.cpp": HEAD + "#include WHAT_IT_NEEDS\n"}), "write the name")
        self.assertOne(
            self.breaches({"src/math/a.cpp": HEAD + '#include/**/"io/x.hpp"\n'}), "'io/x.hpp'")
        self.assertOne(
            self.breaches({"src/math/a.cpp": HEAD + 'char c = \'"\';\n#include <io/x.hpp>\n'}), ":4")

    def test_unlisted_files(self):
        lists = {"src/math/CMakeLists.txt": "point.hpp # lost.cpp\n"}
        found = self.breaches({"src/math/lost.cpp": HEAD}, lists)
        self.assertOne(found, "src/math/lost.cpp:1", "listed in no CMakeLists.txt")
        found = self.breaches({"tests/math/lost_test.cpp": HEAD}, lists)
        self.assertOne(found, "tests/math/lost_test.cpp:1", "listed in no CMakeLists.txt")
        lists = {"src/math/CMakeLists.txt": "point.hpp sub/found.cpp\n"}
        self.assertEqual(self.breaches({"src/math/sub/found.cpp": HEAD}, lists), [])

    def test_unlisted_scripts(self):
        files = {"tests/scripts/drag.vds": "frame\n", "tests/app/a.cpp": HEAD}
        lists = {"src/math/CMakeLists.txt": "point.hpp\n",
                 "tests/app/CMakeLists.txt": "a.cpp foreach(name\n  drag)\n"}
        self.assertEqual(self.breaches(files, lists), [])
        lists["tests/app/CMakeLists.txt"] = "a.cpp dragging\n"
        self.assertOne(self.breaches(files, lists), "tests/scripts/drag.vds:1", "nothing runs it")

    def test_first_lines(self):
        spdx = HEAD.splitlines()[0] + "\n"
        for text in ("", "#pragma once\n", "\n" + HEAD, "// SPDX-License-Identifier: GPL-2.0\n"):
            self.assertOne(self.breaches({"src/math/a.hpp": text}), "a.hpp:1", "SPDX")
        for text in ("", "#pragma once\n", "//\n", "// Point.\n", "// no sentence without its end\n"):
            self.assertOne(self.breaches({"src/math/a.hpp": spdx + text}), "a.hpp:2", "sentence")
        text = spdx + "// A sentence that goes over\n// more than one line.\n"
        self.assertEqual(self.breaches({"src/math/a.hpp": text}), [])

    def test_length(self):
        text = HEAD + "\n" * (house.MOST_LINES - 2)
        self.assertEqual(self.breaches({"src/math/a.cpp": text}), [])
        self.assertOne(self.breaches({"src/math/a.cpp": text + "\n"}), "more than 500 lines")

    def test_unknown_folder(self):
        self.assertOne(self.breaches({"src/util/a.cpp": HEAD}), "src/util/ has no place")

    def test_nothing_to_check_is_an_error(self):
        with tempfile.TemporaryDirectory() as empty:
            (pathlib.Path(empty) / "src").mkdir()
            with contextlib.redirect_stderr(io.StringIO()):
                self.assertEqual(house.main([empty]), 1)

    def test_as_a_program(self):
        with tempfile.TemporaryDirectory() as root:
            path = pathlib.Path(root) / "src" / "io" / "a.cpp"
            path.parent.mkdir(parents=True)
            path.write_text(HEAD + "#include <imgui.h>\n", encoding="utf-8")
            (path.parent / "CMakeLists.txt").write_text("a.cpp", encoding="utf-8")
            run = subprocess.run([sys.executable, house.__file__, root],
                                 capture_output=True, text=True, check=False)
            self.assertEqual(run.returncode, 1)
            self.assertTrue(run.stderr.startswith(f"{path}:3: includes 'imgui.h'"), run.stderr)


if __name__ == "__main__":
    unittest.main()
