// SPDX-License-Identifier: MIT
// Opens a host without a window for a test.
#include "support/offscreen.hpp"

#include <cstdio>
#include <cstdlib>

namespace {
bool leaksAreTold = true;  // the leak checker asks a function without arguments
}

extern "C" int __lsan_is_turned_off();
extern "C" int __lsan_is_turned_off() { return leaksAreTold ? 0 : 1; }

namespace vides::test {

std::unique_ptr<OffscreenHost> openForTest(PixelSize size, OffscreenKind kind, int samples) {
  if (kind == OffscreenKind::kEgl) leaksAreTold = false;
  auto host = openOffscreen(kind, {.size = size, .samples = samples});
  if (!host) {
    std::fprintf(stderr, "%s\n", host.error().c_str());
    std::abort();
  }
  return std::move(*host);
}

bool hasEgl() {
  leaksAreTold = false;
  return openOffscreen(OffscreenKind::kEgl, {.size = {16, 16}}).has_value();
}

}  // namespace vides::test
