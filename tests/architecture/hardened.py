# SPDX-License-Identifier: MIT
"""Looks whether a program and its library were built with what cmake/VidesOptions.cmake asks for in release.

usage: hardened.py PROGRAM ARCHIVE

Prints a line for each thing that is missing and ends with status 1 if there is one.
"""

import re
import subprocess
import sys


def readelf(program, *options):
    return subprocess.run(["readelf", "--wide", *options, program], check=True,
                          capture_output=True, text=True, env={"PATH": "/usr/bin", "LC_ALL": "C"}).stdout


def missing(program, archive):
    """What the program and the archive lack, in words."""
    header, segments = readelf(program, "--file-header"), readelf(program, "--program-headers")
    dynamic = readelf(program, "--dynamic")
    if not re.search(r"Type:\s+DYN", header) or not re.search(r"FLAGS_1.*\bPIE\b", dynamic):
        yield "is not position-independent"
    if "GNU_RELRO" not in segments:
        yield "has no segment that is read-only after relocation"
    if not re.search(r"FLAGS.*\bBIND_NOW\b", dynamic) and not re.search(r"FLAGS_1.*\bNOW\b", dynamic):
        yield "binds its functions lazily, so their table stays writable"
    if not re.search(r"GNU_STACK.*\bRW\s", segments):
        yield "has an executable stack"
    for line in segments.splitlines():
        if re.search(r"^\s+LOAD\s.*\bRWE\b", line):
            yield "has a segment that is writable and executable"
    if re.search(r"\((RPATH|RUNPATH)\)", dynamic):
        yield "looks for libraries in folders of its own"
    if "__stack_chk_fail" not in readelf(archive, "--symbols"):
        yield f"is made of {archive}, which has no stack protector"


if __name__ == "__main__":
    found = list(missing(*sys.argv[1:]))
    for what in found:
        print(f"{sys.argv[1]}: {what}", file=sys.stderr)
    sys.exit(1 if found else 0)
