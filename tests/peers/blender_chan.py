# SPDX-License-Identifier: MIT
"""Runs inside Blender: imports flight.chan and compares every frame's camera with flight.json.

Conventions. A .chan says [right up back] = R_y R_x R_z; Blender calls that rotation order 'ZXY' (Z
is applied first) and asks for it, because the file doesn't tell. Blender's camera looks along its
-z with +y up, as ours does: right = VPN x VUP, up = VUP, back = -VPN. Blender's world has z up;
with the importer's option z_up it turns the scene about x, (x, y, z) -> (x, -z, y), without it the
numbers stay as they are. Both are tried.
"""

import json
import math
import pathlib
import sys

import numpy

# The importer's package was written for an older numpy.
for name, kind in (("bool", bool), ("int", int), ("float", float), ("object", object)):
    if name not in numpy.__dict__:
        setattr(numpy, name, kind)

import bpy  # noqa: E402  (Blender's own module)
from mathutils import Matrix, Vector  # noqa: E402

POSITION = 1e-5  # scene units
# Degrees. Where Blender keeps Euler angles it takes them from its own matrix of floats, and near
# the poles of that order (rotation y at 90 degrees) loses digits that the file has.
ROTATION = {"QUATERNION": 0.001, "XYZ": 0.01}
FOCAL = 1e-3  # millimetres, of a lens of 12 to 210


def wanted_camera(frame, z_up):
    """Position and rotation of a frame as Blender should have them."""
    vpn, up = Vector(frame["vpn"]), Vector(frame["vup"])
    rotation = Matrix((vpn.cross(up), up, -vpn)).transposed()
    position = Vector(frame["vrp"])
    if z_up:
        turn = Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0)))
        position, rotation = turn @ position, turn @ rotation
    return position, rotation


def compare(chan, flight, mode, z_up):
    """Largest differences over all frames: position, rotation in degrees, focal length."""
    scene = bpy.context.scene
    camera = bpy.data.objects.new("flight", bpy.data.cameras.new("flight"))
    scene.collection.objects.link(camera)
    bpy.context.view_layer.objects.active = camera
    camera.rotation_mode = mode
    picture, lens = flight["picture"], flight["lens"]
    width = lens["sensor_width_mm"]
    bpy.ops.import_scene.import_chan(
        filepath=str(chan), z_up=z_up, rotation_order="ZXY", sensor_width=width,
        sensor_height=width * picture["height"] / picture["width"])
    worst = [0.0, 0.0, 0.0]
    for frame in flight["frames"]:
        scene.frame_set(frame["frame"] + 1)
        position, rotation = wanted_camera(frame, z_up)
        actual = camera.matrix_world
        worst[0] = max(worst[0], (actual.translation - position).length)
        # The axes' largest distance, as an angle: exact for small ones, unlike an acos.
        away = max((actual.to_3x3().col[i] - rotation.col[i]).length for i in range(3))
        worst[1] = max(worst[1], math.degrees(2.0 * math.asin(min(1.0, away / 2.0))))
        first, last = lens["focal_length_mm"]
        focal = first + (frame["zoom"] - 1.0) / 99.0 * (last - first)
        worst[2] = max(worst[2], abs(camera.data.lens - focal))
    bpy.data.objects.remove(camera)
    return worst


def main(folder):
    if bpy.ops.preferences.addon_enable(module="io_anim_nuke_chan") != {"FINISHED"}:
        raise RuntimeError("the add-on io_anim_nuke_chan is missing")
    flight = json.loads((folder / "flight.json").read_text())
    lines = [f"Blender {bpy.app.version_string}, {len(flight['frames'])} frames, order ZXY"]
    equal = len(flight["frames"]) > 0
    for z_up in (False, True):
        for mode in ("QUATERNION", "XYZ"):
            worst = compare(folder / "flight.chan", flight, mode, z_up)
            equal = equal and all(w <= bar for w, bar in zip(worst, (POSITION, ROTATION[mode], FOCAL)))
            lines.append(f"z_up {z_up!s:5}, {mode:10}: position {worst[0]:.2e}, rotation "
                         f"{worst[1]:.2e} degrees, focal length {worst[2]:.2e} mm at most apart")
    lines.append("equal" if equal else
                 f"not equal: {POSITION}, {ROTATION['QUATERNION']} degrees, {FOCAL} mm may they be apart")
    (folder / "report.txt").write_text("\n".join(lines) + "\n")


main(pathlib.Path(sys.argv[sys.argv.index("--") + 1]))
