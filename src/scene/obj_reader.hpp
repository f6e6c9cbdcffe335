// SPDX-License-Identifier: MIT
// Reads the geometry of a Wavefront OBJ file: vertices, faces, lines and points.
//
// Normals, texture coordinates, materials, groups and smoothing are passed over; no other file is
// ever opened, whatever mtllib or call may name. Every statement that counts is checked: a damaged
// file gives the place of its first fault, never a part of a scene. What other programs skip as
// harmless, and lines that mean nothing here (free-form curves among them), are counted in the
// report. Lines end with CR, LF or CRLF; a text in UTF-16 is read, too.
#pragma once

#include <string_view>

#include "scene/scene_reader.hpp"

namespace vides {

ReadScene readObj(std::string_view text, const KeepGoing& keepGoing = {});

}  // namespace vides
