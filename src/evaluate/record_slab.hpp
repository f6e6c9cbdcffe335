// SPDX-License-Identifier: MIT
// Room for the records or the pieces of a whole flight in one block of memory.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace vides {

// Items of one kind, value-initialised. In a long flight the block lies on large pages where the
// system has them, so that looking up a frame does not also wait for the page tables. The slab
// lives as long as any of its items is shared.
//
// Records and the pieces that they share lie in slabs of their own: a record in the block of its
// own piece would keep that block, and so itself, alive for ever.
template <class T>
class Slab {
 public:
  explicit Slab(std::size_t size) : size_(size) {
    constexpr std::size_t kLargePage = std::size_t{2} << 20;
    const bool large = size * sizeof(T) >= kLargePage;
    const std::size_t alignment = large ? kLargePage : alignof(T);
    const std::size_t bytes = (size * sizeof(T) + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, bytes);
    if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__)
    if (large) madvise(memory, bytes, MADV_HUGEPAGE);  // only advice: failing costs nothing
#endif
    items_ = static_cast<T*>(memory);
    std::uninitialized_value_construct_n(items_, size_);
  }
  ~Slab() {
    std::destroy_n(items_, size_);
    std::free(items_);
  }
  Slab(const Slab&) = delete;
  Slab& operator=(const Slab&) = delete;

  static std::shared_ptr<T> item(const std::shared_ptr<Slab>& slab, std::size_t k) {
    return {slab, &slab->items_[k]};
  }

 private:
  std::size_t size_;
  T* items_ = nullptr;
};

}  // namespace vides
