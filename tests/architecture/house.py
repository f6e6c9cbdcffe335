# SPDX-License-Identifier: MIT
"""The order of the house: finds includes against it, unlisted files, missing first lines.

usage: house.py [ROOT]

Prints a line `FILE:LINE: MESSAGE` for each breach and ends with status 1 if there is one.
"""

import pathlib
import re
import sys

# Each folder of src/ and the folders that it may include, besides itself. What stands to the left
# of an arrow in the picture (README, "How it is built") never includes anything to its right.
MAY_INCLUDE = {
    "math": set(),
    "flight": {"math"},
    "evaluate": {"math", "flight"},
    "io": {"math", "flight", "evaluate"},
    "scene": {"math", "flight", "evaluate"},
    # What the user does, as values: tools and the editor read it, hosts and scripts fill it.
    "input": set(),
    "edit": {"math", "flight", "evaluate", "io", "scene", "input"},
    # Pictures are files, too: whole or not at all like all others.
    "render": {"math", "flight", "evaluate", "io", "scene"},
    "panels": {"math", "flight", "evaluate", "io", "scene", "edit", "input"},
    # A window or an offscreen context: who draws what into it is the app's matter.
    "host": {"math", "flight", "evaluate", "io", "scene", "input", "render"},
    "app": {
        "math", "flight", "evaluate", "io", "scene", "input", "edit", "render", "panels", "host"},
    "capi": {
        "math", "flight", "evaluate", "io", "scene", "input", "edit", "render", "panels", "host",
        "app"},
}

# Foreign headers that only some folders may see: (name, pattern, folders).
FOREIGN = [
    ("OpenGL", r"(GL|GLES\d?|KHR|glad|epoxy)/|glad\.h|gl3w|GLES", {"render", "host"}),
    ("a window system", r"GLFW/|EGL/|GL/osmesa|X11/|wayland", {"host"}),
    ("Dear ImGui", r"(.*/)?imgui", {"render", "panels", "host", "app"}),
    ("the command line's parser", r"CLI/", {"app"}),
]

SOURCE = {".cpp", ".hpp", ".c", ".h"}
SPDX = "// SPDX-License-Identifier: MIT"
MOST_LINES = 500


def files_under(folder):
    """Every C and C++ file of a folder except test data, in a steady order."""
    return sorted(
        path
        for path in folder.rglob("*")
        if path.suffix in SOURCE and path.is_file() and "data" not in path.relative_to(folder).parts
    )


def without_comments(text):
    """The text with its comments blanked; the lines keep their numbers."""

    def blank(match):
        found = match.group(0)
        return found if found[0] in "\"'" else re.sub(r"[^\n]", " ", found)

    # Include lines first: the // in <a//b.h> or a quote in a comment must not mislead us.
    tokens = r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|//[^\n]*|/\*.*?\*/'
    return re.sub(tokens, blank, text, flags=re.S)


def includes(text):
    """(line number, kind, name) for each include; the kind is '"', '<', or '' for a macro."""
    for number, line in enumerate(without_comments(text).splitlines(), 1):
        match = re.match(r"\s*#\s*(?:include|include_next|import)\b\s*(.*)", line)
        if match:
            name = re.match(r'(["<])([^">]+)[">]', match.group(1))
            yield (number, name.group(1), name.group(2)) if name else (number, "", match.group(1))


def include_breaches(src, path):
    """Messages for the includes of one file that the order of the house forbids."""
    folder = path.relative_to(src).parts[0]
    for line, kind, name in includes(path.read_text(encoding="utf-8")):
        first = name.split("/")[0]
        if not kind:
            yield line, f"includes '{name.strip()}': write the name out, so that it can be checked"
        elif ".." in name.split("/") or name.startswith("./"):
            yield line, f"includes '{name}': paths start at src/"
        elif first in MAY_INCLUDE and "/" in name:
            if first != folder and first not in MAY_INCLUDE[folder]:
                allowed = ", ".join(sorted(MAY_INCLUDE[folder])) or "no other folder"
                yield line, f"includes '{name}': {folder}/ may include {allowed}"
        elif kind == '"' and (path.parent / name).is_file():
            yield line, f"includes '{name}': paths start at src/ ('{folder}/{name}')"
        for what, pattern, folders in FOREIGN:
            if re.match(pattern, name) and first not in MAY_INCLUDE and folder not in folders:
                yield line, f"includes '{name}': {what} belongs to {', '.join(sorted(folders))}"


def listed_names(top, folder):
    """Absolute paths of all source files that the CMakeLists.txt at or above the folder name."""
    found = set()
    while True:
        lists = folder / "CMakeLists.txt"
        if lists.is_file():
            text = re.sub(r"#[^\n]*", "", lists.read_text(encoding="utf-8"))
            for name in re.findall(r"[\w./+-]+\.(?:cpp|hpp|c|h)\b", text):
                found.add((folder / name).resolve())
        if folder == top:
            return found
        folder = folder.parent


def head_breaches(lines):
    """Messages for a file's first lines: the licence, then a sentence of purpose."""
    if not lines or lines[0] != SPDX:
        yield 1, f"must begin with '{SPDX}'"
        return
    comment = []
    for line in lines[1:]:
        if not line.startswith("//"):
            break
        comment.append(line[2:].strip())
    purpose = " ".join(comment)
    if "." not in purpose or len(re.findall(r"\w+", purpose)) < 3:
        yield 2, "must say in a sentence after the licence line what it is for"


def breaches(root):
    """(file, line, message) for everything in the tree that is against the rules."""
    src = root / "src"
    for path in files_under(src):
        folder = path.relative_to(src).parts[0]
        if folder not in MAY_INCLUDE:
            yield path, 1, f"src/{folder}/ has no place in the order: name it in {__file__}"
            continue
        for line, message in include_breaches(src, path):
            yield path, line, message
    for top in (src, root / "tests", root / "bench", root / "examples"):
        for path in files_under(top):
            lines = path.read_text(encoding="utf-8").splitlines()
            for line, message in head_breaches(lines):
                yield path, line, message
            if path.resolve() not in listed_names(top, path.parent):
                yield path, 1, "is listed in no CMakeLists.txt, so nothing builds it"
            if top == src and len(lines) > MOST_LINES:
                yield path, len(lines), f"has more than {MOST_LINES} lines: divide it"
    yield from unlisted_scripts(root)


def unlisted_scripts(root):
    """Scripts of `vides drive` that no test runs."""
    lists = root / "tests" / "app" / "CMakeLists.txt"
    words = set(lists.read_text(encoding="utf-8").split()) if lists.is_file() else set()
    for script in sorted((root / "tests" / "scripts").glob("*.vds")):
        if script.stem not in {word.rstrip(")") for word in words}:
            yield script, 1, "is listed in tests/app/CMakeLists.txt nowhere, so nothing runs it"


def main(arguments):
    root = pathlib.Path(arguments[0]) if arguments else pathlib.Path(__file__).parents[2]
    if not files_under(root / "src"):
        print(f"{root}/src: no source files, so nothing was checked", file=sys.stderr)
        return 1
    count = 0
    for path, line, message in breaches(root):
        print(f"{path}:{line}: {message}", file=sys.stderr)
        count += 1
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
