// SPDX-License-Identifier: MIT
// An evaluation gives back all of its memory, also when others share parts of it.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstddef>

#include "evaluate/evaluation.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

// Bytes that are allocated. (Under the address sanitizer always 0; it has its own leak checker.)
std::size_t inUse() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

Flight flightOf(std::size_t keys) {
  test::Random random(5);
  Flight flight = test::randomFlight(random, {});
  while (flight.keys.size() < keys) flight.keys.push_back(test::randomKey(random, false));
  return flight;
}

TEST(EvaluationMemory, IsGivenBack) {
  const Flight flight = flightOf(300);
  EXPECT_GT(Evaluation(flight).frameCount(), 0);  // the allocator's own caches are filled
  const std::size_t before = inUse();
  for (int i = 0; i < 20; ++i) EXPECT_GT(Evaluation(flight).frameCount(), 0);
  EXPECT_LT(inUse(), before + 300 * sizeof(Key));
}

// Each shares curve pieces with the one before, whatever the edit: a key, or all that there is.
TEST(EvaluationMemory, DoesNotGrowWithTheNumberOfEdits) {
  Flight flight = flightOf(300);
  Evaluation evaluation(flight);
  std::size_t after20 = 0;
  for (int i = 0; i < 200; ++i) {
    const std::size_t k = i % 2 == 0 ? 10 : 14;  // neighbours, so that pieces are handed on
    Key key = flight.keys[k];
    key.position.x = i % 2 == 0 ? -key.position.x : key.position.x * 0.99;
    flight.keys.set(k, key);
    if (i % 5 == 0) flight.closed = !flight.closed;
    evaluation = evaluation.updated(flight);
    if (i == 20) after20 = inUse();
  }
  EXPECT_LE(inUse(), after20 + after20 / 2);
}

}  // namespace
}  // namespace vides
