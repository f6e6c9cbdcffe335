#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Does Blender read our .chan as we mean it? Writes the frames of a flight as chan and as csv, lets
# headless Blender (3.4.1 is what Debian 12 has) import the one and compares with the other.
#
# usage: tests/peers/blender_chan.sh [FLIGHT.vid]     status 0: equal, 1: not, 77: no Blender here
#
# Not a part of ./dev test: Blender is a big package that building vides doesn't need. To have it:
# apt-get install --no-install-recommends blender python3-numpy
set -euo pipefail

here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
root=$(dirname -- "$(dirname -- "$here")")
flight=${1-$root/assets/flights/pyramid.vid}

if ! command -v blender > /dev/null; then
  echo "skipped: Blender is not installed (apt-get install --no-install-recommends blender python3-numpy)"
  exit 77
fi

vides=${VIDES_PROGRAM-$("$root/dev" build)}
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
"$vides" frames "$flight" --format chan -o "$work/flight.chan"
"$vides" frames "$flight" --format json --space world -o "$work/flight.json"

# Blender says much, and its own status is 0 even where a script failed: what counts is our file.
blender --background --factory-startup --python-exit-code 1 \
  --python "$here/blender_chan.py" -- "$work" > "$work/blender.log" 2>&1 ||
  { cat "$work/blender.log" >&2; echo "failed: Blender could not be used" >&2; exit 1; }
cat "$work/report.txt"
grep --quiet '^equal' "$work/report.txt"
