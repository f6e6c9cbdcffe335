// SPDX-License-Identifier: MIT
// A host without a window through OSMesa: software OpenGL, the same pixels on each run.
#pragma once

#include <memory>

#include "host/offscreen_host.hpp"

namespace vides {

struct OsmesaOptions : OffscreenOptions {
  std::string library = "libOSMesa.so.8";
};

// Error: a sentence — the library is missing, or OpenGL 3.3 or the size is beyond it.
tl::expected<std::unique_ptr<OffscreenHost>, std::string> openOsmesaHost(
    const OsmesaOptions& options);

}  // namespace vides
