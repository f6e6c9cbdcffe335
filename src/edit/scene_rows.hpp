// SPDX-License-Identifier: MIT
// The scenes of the open flight as the Scene window lists them, and what an import tells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "edit/text.hpp"
#include "flight/up_axis.hpp"
#include "scene/drawable_scene.hpp"

namespace vides {

// One file of the flight.
struct SceneRow {
  enum class State : std::uint8_t {
    kHidden,   // not drawn; what was read of it before may still be known
    kWaiting,  // for its turn to be read
    kReading,
    kRead,
    kMissing,  // no such file
    kRefused,  // it is there, and can't be read
    kStopped,  // its reading was
  };
  std::string file;  // as the flight names it
  std::filesystem::path path;
  UpAxis up = UpAxis::kY;
  bool visible = true;
  State state = State::kWaiting;
  double share = 0.0;          // of kReading, 0 to 1
  SharedDrawable drawable;     // of kRead, and of kHidden where it is known
  Text problem;                // of kMissing, kRefused
  bool changedOnDisk = false;  // as of the last look
  bool failed() const { return state == State::kMissing || state == State::kRefused; }
};

// What the note about an import says and offers, until the next edit.
struct ImportNote {
  std::size_t scene = 0;  // the row of the file
  std::string name;
  Text content;         // what is in it: "5 vertices, 5 faces"
  Text size;            // of what is drawn, in scene units
  Text notes;           // what its reading left out; may be empty
  bool fitted = false;  // the import has fitted the space; another axis fits it again
};

// What is in a scene: "5 vertices, 5 faces".
Text contentText(const DrawableScene& scene);
// A box's extent: "2 × 1 × 2".
Text extentText(const BoundingBox& box);

}  // namespace vides
