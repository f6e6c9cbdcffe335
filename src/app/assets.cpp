// SPDX-License-Identifier: MIT
// The places where assets may be.
#include "app/assets.hpp"

#include <cstdlib>
#include <vector>

namespace vides {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> assetFolders() {
  const char* const chosen = std::getenv("VIDES_ASSETS");
  if (chosen != nullptr && *chosen != '\0') return {chosen};
  std::vector<fs::path> folders;
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  if (!unknown) folders.push_back(program.parent_path().parent_path() / "share" / "vides");
  folders.emplace_back(VIDES_SOURCE_ASSETS);
  return folders;
}

}  // namespace

std::optional<fs::path> findAsset(const fs::path& name) {
  for (const fs::path& folder : assetFolders()) {
    std::error_code ignored;
    if (fs::path file = folder / name; fs::is_regular_file(file, ignored)) return file;
  }
  return std::nullopt;
}

}  // namespace vides
