// SPDX-License-Identifier: MIT
// Asking for memory before it is needed.
#pragma once

#include <cstddef>
#include <cstdint>

namespace vides {

// Asks for all of the `size` bytes at `address` at once. In a long flight nothing of what a look-up
// reads is in the caches, and waiting for one line after the other takes longer than all the
// arithmetic. Harmless for any address, null too: hence reckoned in numbers, not in pointers.
inline void fetch(const void* address, std::size_t size) {
  constexpr std::size_t kLine = 64;
  const auto first = reinterpret_cast<std::uintptr_t>(address);
  for (std::uintptr_t at = first; at < first + size; at += kLine) {
    __builtin_prefetch(reinterpret_cast<const void*>(at));
  }
}

}  // namespace vides
