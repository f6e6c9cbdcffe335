// SPDX-License-Identifier: MIT
// A host without a window through EGL's surfaceless platform: the machine's own OpenGL.
#pragma once

#include <memory>

#include "host/offscreen_host.hpp"

namespace vides {

struct EglOptions : OffscreenOptions {
  std::string library = "libEGL.so.1";
};

// Error: a sentence — the library is missing, it has no surfaceless platform, or OpenGL 3.3 or the
// size is beyond it.
tl::expected<std::unique_ptr<OffscreenHost>, std::string> openEglHost(const EglOptions& options);

}  // namespace vides
