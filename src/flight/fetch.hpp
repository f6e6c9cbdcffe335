// SPDX-License-Identifier: MIT
// Asking for memory before it is needed.
#pragma once

#include <cstddef>

namespace vides {

// Asks for all of the `size` bytes at `address` at once. In a long flight nothing of what a look-up
// reads is in the caches, and waiting for one line after the other takes longer than all the
// arithmetic. Harmless for any address, null too.
inline void fetch(const void* address, std::size_t size) {
  constexpr std::size_t kLine = 64;
  const char* bytes = static_cast<const char*>(address);
  for (std::size_t i = 0; i < size; i += kLine) __builtin_prefetch(bytes + i);
}

}  // namespace vides
