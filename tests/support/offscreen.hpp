// SPDX-License-Identifier: MIT
// Opens a host without a window for a test.
#pragma once

#include <memory>

#include "host/open_host.hpp"

namespace vides::test {

// Aborts where there is none. After one of EGL's the leak checker is off: what its drivers keep
// until the process ends cannot be told apart from a leak of ours.
std::unique_ptr<OffscreenHost> openForTest(PixelSize size,
                                           OffscreenKind kind = OffscreenKind::kOsmesa,
                                           int samples = 0);

// Whether this machine has what EGL needs: tests through it are skipped where it hasn't.
bool hasEgl();

}  // namespace vides::test
