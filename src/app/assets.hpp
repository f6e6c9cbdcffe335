// SPDX-License-Identifier: MIT
// Finds the files that come with the program.
#pragma once

#include <filesystem>
#include <optional>

namespace vides {

// The asset with that name, "flights/pyramid.vid" for example, looked for in the folder that
// VIDES_ASSETS names (and then nowhere else), beside the program as installed (../share/vides), and
// in the source tree that it was built from.
std::optional<std::filesystem::path> findAsset(const std::filesystem::path& name);

}  // namespace vides
