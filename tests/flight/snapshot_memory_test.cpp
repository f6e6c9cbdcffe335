// SPDX-License-Identifier: MIT
// What snapshots of a flight cost: a thousand of a flight with 10,000 keys, each with another key,
// stay under 200 MB. A program of its own, because it counts what is allocated.
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include "flight/flight.hpp"

namespace {

std::atomic<std::size_t> allocated{0};

void* counted(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) {
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  allocated += malloc_usable_size(memory);
  return memory;
}

void release(void* memory) noexcept {
  if (memory != nullptr) allocated -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace vides {
namespace {

Flight flightOf(std::size_t keys) {
  std::vector<KeyPointer> list;
  for (std::size_t i = 0; i < keys; ++i) {
    Key key;
    key.position = {0.5, 0.25, static_cast<double>(i) / static_cast<double>(keys)};
    list.emplace_back(std::move(key));
  }
  Flight flight;
  flight.keys = KeyList(std::move(list));
  return flight;
}

TEST(Snapshots, AThousandOfTenThousandKeysStayUnder200Megabytes) {
  const std::size_t before = allocated;
  Flight flight = flightOf(10'000);
  const std::size_t one = allocated - before;
  std::vector<Flight> snapshots;
  for (std::size_t i = 0; i < 1000; ++i) {
    Key key = flight.keys[i * 7919 % 10'000];
    key.position.x = -0.001 * static_cast<double>(i);
    flight.keys.set(i * 7919 % 10'000, key);
    snapshots.push_back(flight);
  }
  const std::size_t all = allocated - before;
  RecordProperty("megabytes", static_cast<int>(all >> 20));
  EXPECT_LT(all, 200'000'000U);
  // They are what they claim to be.
  EXPECT_GT(one, 10'000 * sizeof(Key));
  EXPECT_EQ(snapshots.front().keys[0].position.x, 0.0);
  EXPECT_EQ(snapshots.back().keys[999 * 7919 % 10'000].position.x, -0.999);
  EXPECT_EQ(snapshots.front().keys[999 * 7919 % 10'000].position.x, 0.5);
}

TEST(Snapshots, ACopyCostsNoKeys) {
  const Flight flight = flightOf(10'000);
  const std::size_t before = allocated;
  const Flight copy = flight;
  EXPECT_LT(allocated - before, 4096U);
  EXPECT_EQ(copy, flight);
}

}  // namespace
}  // namespace vides
