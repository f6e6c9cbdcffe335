// SPDX-License-Identifier: MIT
// Room for the records and pieces of a whole flight in one block of memory.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include "evaluate/records.hpp"

namespace vides {

// A record beside the piece that begins at its key: the two that a frame needs. In a long flight
// the block lies on large pages where the system has them, so that looking up a frame does not also
// wait for the page tables. The slab lives as long as any of its records or pieces is shared.
class RecordSlab {
 public:
  explicit RecordSlab(std::size_t size) : size_(size) {
    constexpr std::size_t kLargePage = std::size_t{2} << 20;
    const bool large = size * sizeof(Place) >= kLargePage;
    const std::size_t alignment = large ? kLargePage : alignof(Place);
    const std::size_t bytes = (size * sizeof(Place) + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, bytes);
    if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__)
    if (large) madvise(memory, bytes, MADV_HUGEPAGE);  // only advice: failing costs nothing
#endif
    places_ = static_cast<Place*>(memory);
    std::uninitialized_value_construct_n(places_, size_);
  }
  ~RecordSlab() {
    std::destroy_n(places_, size_);
    std::free(places_);
  }
  RecordSlab(const RecordSlab&) = delete;
  RecordSlab& operator=(const RecordSlab&) = delete;

  static std::shared_ptr<KeyRecord> record(const std::shared_ptr<RecordSlab>& slab, std::size_t k) {
    return {slab, &slab->places_[k].record};
  }
  static std::shared_ptr<CurvePiece> piece(const std::shared_ptr<RecordSlab>& slab, std::size_t k) {
    return {slab, &slab->places_[k].piece};
  }

 private:
  struct Place {
    CurvePiece piece;
    KeyRecord record;
  };
  std::size_t size_;
  Place* places_ = nullptr;
};

}  // namespace vides
