// SPDX-License-Identifier: MIT
// Opens the hosts that this build has.
#pragma once

#include <memory>

#include "host/glfw_host.hpp"
#include "host/offscreen_host.hpp"

namespace vides {

// A window; the error is a sentence, also where this build has no windows.
tl::expected<std::unique_ptr<Host>, std::string> openWindow(const WindowOptions& options);

enum class OffscreenKind { kOsmesa, kEgl };

// A host without a window. OSMesa gives the same pixels on each run; EGL is faster where there is a
// graphics card. The error is a sentence, also where this build lacks that kind.
tl::expected<std::unique_ptr<OffscreenHost>, std::string> openOffscreen(
    OffscreenKind kind, const OffscreenOptions& options);

}  // namespace vides
