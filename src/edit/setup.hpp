// SPDX-License-Identifier: MIT
// The setup: how the editor looks and what it shows, kept from one run to the next.
//
// A small JSON object, "format": "vides-setup", "version": 1; what is missing is as built in.
// Members that this version doesn't know are passed over, so that an older program can start with a
// newer one's setup of the same version.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "edit/display.hpp"
#include "edit/layout.hpp"
#include "flight/limits.hpp"
#include "flight/problem.hpp"
#include "flight/up_axis.hpp"
#include "math/view_projection.hpp"

namespace vides {

inline constexpr int kSetupVersion = 1;
inline constexpr std::size_t kSetupBytes = std::size_t{1} << 20;

struct Setup {
  Display display;  // a content scale of 0, the screen's, is left out in the file
  Layout layout;
  // How the viewport is looked at; its target stays with the flight that is open.
  double turn = EditorView().turn;
  double tilt = EditorView().tilt;
  double size = EditorView().size;
  bool perspective = false;
  // The axis of a format that points up in imports, by its ending ("obj"), where another one than
  // the format's usual axis was chosen.
  std::map<std::string, UpAxis> importUp;

  bool operator==(const Setup&) const = default;
};

// What is wrong is told as in a `.vid`, up to kMostProblems problems in the order of the file.
using ReadSetup = tl::expected<Setup, std::vector<Problem>>;
ReadSetup readSetup(std::string_view text);
ReadSetup readSetupFile(const std::string& path);  // of a file: not of a pipe

// The same text for the same setup, in every locale.
std::string writeSetup(const Setup& setup);
// Whole or not at all; folders on the way are made. What the system refuses is kUnwritable.
std::optional<Problem> saveSetup(const Setup& setup, const std::string& path);

}  // namespace vides
