// SPDX-License-Identifier: MIT
// At most 2,000,000,000 frames, to the frame; and the bound that spares the evaluation.
#include "io/frame_limit.hpp"

#include <gtest/gtest.h>

#include "evaluate/evaluation.hpp"
#include "flight/limits.hpp"
#include "io/problem_text.hpp"
#include "io/vid_reader.hpp"
#include "io/vid_writer.hpp"
#include "support/property.hpp"
#include "support/random_document.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

// Two keys in one place, ten orientations each that only hold: so many seconds in all at 1000 fps.
// (An open flight has one frame more.)
Flight holding(double seconds) {
  Flight flight;
  flight.frameRate = 1000;
  Key key;
  key.orientations.clear();
  Orientation o;
  o.aim = {0, 0, 1};
  std::vector<KeyPointer> keys;
  while (seconds > 0 || keys.size() < 2) {
    o.hold = std::min(seconds, limits::kHold.max);
    seconds -= o.hold;
    key.orientations.assign(1, o);
    keys.emplace_back(key);
  }
  flight.keys = KeyList(std::move(keys));
  return flight;
}

TEST(FrameLimit, IsMetToTheFrame) {
  const Flight most = holding(1'999'999.999);
  EXPECT_EQ(Evaluation(most).frameCount(), 2'000'000'000);
  EXPECT_FALSE(checkFrameCount(most).has_value());
  EXPECT_EQ(readVid(writeVid(most)).value(), most);
  const Flight more = holding(2'000'000);
  const ReadFlight read = readVid(writeVid(more));
  ASSERT_FALSE(read.has_value());
  ASSERT_EQ(read.error().size(), 1U);
  EXPECT_EQ(problemLine("f", read.error()[0]),
            "f: /keys: expected at most 2000000000 frames, found 2000000001");
}

TEST(FrameLimit, BoundIsABound) {
  test::holdsFor(10'000, [] {
    test::Random random(*test::seeds());
    const Flight flight = *rc::gen::element(0, 1, 2) == 0
                              ? test::randomDocument(random, 5)
                              : test::randomFlight(random, {.nasty = random.coin()});
    const auto frames = static_cast<double>(Evaluation(flight).frameCount());
    RC_ASSERT(frameCountBound(flight) >= frames);
  });
}

// If it were far off, evaluations would be made for nothing.
TEST(FrameLimit, BoundIsNear) {
  test::Random random(3);
  double bound = 0;
  double frames = 0;
  for (int i = 0; i < 200; ++i) {
    Flight flight = test::randomFlight(random, {});
    flight.rates = {100, 100, 100, 100};
    bound += frameCountBound(flight);
    frames += static_cast<double>(Evaluation(flight).frameCount());
  }
  EXPECT_LT(bound, 3 * frames);
}

}  // namespace
}  // namespace vides
