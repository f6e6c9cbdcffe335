// SPDX-License-Identifier: MIT
// Keys as text for the clipboard: a whole `.vid` file that any vides can open.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "edit/edit_state.hpp"

namespace vides {

// The flight with only these keys. A file has at least two: a single key stands twice, and the
// member x_vides_keys tells how many count.
std::string clipboardText(const Flight& flight, const KeySelection& keys);

// The keys of a `.vid` text for pasting into `flight`: at the same place in the scene where the
// spaces differ, in the same shape where the presets differ. Refused where the text isn't a `.vid`
// or a key would lie outside the cube.
tl::expected<std::vector<Key>, Text> keysFromClipboard(std::string_view text, const Flight& flight);

}  // namespace vides
