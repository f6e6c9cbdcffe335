// SPDX-License-Identifier: MIT
// Properties of single frames and of the joints between sections, over random flights.
#include <gtest/gtest.h>

#include <cmath>

#include "evaluate/builder.hpp"
#include "evaluate/evaluation.hpp"
#include "evaluate/evaluation_state.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

using test::Random;

double apart(const Camera& a, const Camera& b) {
  return glm::length(a.viewReferencePoint - b.viewReferencePoint) +
         glm::length(a.viewPlaneNormal - b.viewPlaneNormal) +
         glm::length(a.viewUpVector - b.viewUpVector) + std::abs(a.zoom - b.zoom) / 99.0;
}

void expectUnit(const Camera& c) {
  ASSERT_NEAR(glm::length(c.viewPlaneNormal), 1.0, 1e-12);
  ASSERT_NEAR(glm::length(c.viewUpVector), 1.0, 1e-12);
  ASSERT_NEAR(glm::dot(c.viewPlaneNormal, c.viewUpVector), 0.0, 1e-12);
  ASSERT_TRUE(std::isfinite(glm::length(c.viewReferencePoint)));
  ASSERT_GE(c.zoom, 1.0 - 1e-12);
  ASSERT_LE(c.zoom, 100.0 + 1e-12);
}

TEST(Frames, AreUnitAndPerpendicularAndHitEveryKey) {
  std::int64_t frames = 0;
  for (std::uint64_t seed = 1; frames < 100'000 || seed <= 1000; ++seed) {
    Random random(seed);
    const Flight flight = test::randomFlight(random, {.nasty = seed % 2 == 0});
    const Evaluation evaluation(flight);
    FrameWalk walk(evaluation);
    Frame frame;
    while (walk.next(frame)) {
      expectUnit(frame.camera);
      ++frames;
      if (HasFatalFailure()) FAIL() << "seed " << seed << " frame " << frame.number;
    }
    for (std::size_t k = 0; k < flight.keys.size(); ++k) {
      const Camera camera = evaluation.frame(evaluation.frameOf({k, 0})).camera;
      // A section without frames may leave its neighbour's key up to 1e-9 away.
      ASSERT_LT(glm::length(camera.viewReferencePoint - flight.keys[k].position), 1e-8)
          << "seed " << seed << " key " << k;
      const Vec3 toAim = glm::normalize(aimOffset(flight.keys[k], flight.keys[k].orientations[0]));
      // Closer than 1e-7 to a pole the yaw is 0 and the direction in the plane of y and z.
      ASSERT_LT(glm::length(evaluation.cameraAt({k, 0}).viewPlaneNormal - toAim), 3e-7);
    }
  }
}

// The camera just before a section's end is the camera at the next orientation.
TEST(Joints, HaveNoJumps) {
  std::int64_t sections = 0;
  for (std::uint64_t seed = 1; sections < 10'000; ++seed) {
    Random random(seed);
    const Flight flight = test::randomFlight(random, {.nasty = seed % 2 == 0});
    const Evaluation evaluation(flight);
    const EvaluationTree tree = buildTree(flight);
    const Chain chain(tree, flight.closed, *flight.orientationCurve);
    for (std::size_t k = 0; k < tree.size(); ++k) {
      for (std::size_t j = 0; j < tree[k]->sections.size(); ++j) {
        SectionRecord s = tree[k]->sections[j];
        if (!s.exists) continue;
        s.frames = std::int64_t{1} << 50;
        const Camera end = evaluation.cameraAt(chain.after({k, j}));
        const Camera nearEnd =
            cameraInSection(*tree[k], s, s.path, static_cast<double>(s.frames - 1));
        const Camera nearStart = cameraInSection(*tree[k], s, s.path, 1);
        ++sections;
        // Beside a pole a tracking camera swings round within any distance.
        const bool swings = s.tracking && (std::abs(end.viewPlaneNormal.y) > 1.0 - 1e-6 ||
                                           std::abs(viewPlaneNormal(s.q).y) > 1.0 - 1e-6);
        // Cusps leave a key with the cube root of the length.
        if (swings) continue;
        ASSERT_LT(apart(nearEnd, end), 1e-3) << "seed " << seed << " key " << k << " " << j;
        ASSERT_LT(apart(nearStart, evaluation.cameraAt({k, j})), 1e-3)
            << "seed " << seed << " key " << k << " " << j;
      }
    }
  }
}

// Half the angular velocity per unit of work at one end of a section, by differences.
Vec3 turnRateAt(const KeyRecord& record, SectionRecord s, bool atEnd) {
  s.frames = 1'000'000;
  const std::int64_t step = atEnd ? s.frames - 2 : 1;
  const Camera a = cameraInSection(record, s, s.path, static_cast<double>(step));
  const Camera b = cameraInSection(record, s, s.path, static_cast<double>(step + 1));
  const auto progress = [&](std::int64_t n) {
    return s.speed.progress(static_cast<double>(n) / static_cast<double>(s.frames));
  };
  const double share = progress(step + 1) - progress(step);
  const Quaternion qa = quaternionFrom(yawPitchRollOf(a.viewPlaneNormal, a.viewUpVector));
  Quaternion qb = quaternionFrom(yawPitchRollOf(b.viewPlaneNormal, b.viewUpVector));
  if (glm::dot(qa, qb) < 0.0) qb = -qb;
  return log(qb * glm::conjugate(qa)) / (share * s.work);
}

// The smooth curve's angular velocity is the same on both sides of a joint without a rest.
TEST(Joints, SmoothCurvesTurnWithoutAJump) {
  int joints = 0;
  for (std::uint64_t seed = 1; joints < 500; ++seed) {
    Random random(seed);
    Flight flight = test::randomFlight(random, {});
    flight.orientationCurve = orientationMethod("smooth");
    const EvaluationTree tree = buildTree(flight);
    const Chain chain(tree, flight.closed, *flight.orientationCurve);
    for (std::size_t k = 0; k < tree.size(); ++k) {
      const KeyRecord& record = *tree[k];
      for (std::size_t j = 0; j < record.sections.size(); ++j) {
        const SectionRecord& s = record.sections[j];
        const auto next = chain.nextSection({k, j});
        if (!s.exists || !next || s.tracking || chain.at(*next).tracking) continue;
        const SectionRecord& t = chain.at(*next);
        if (std::min(s.work, t.work) < 1.0) continue;
        const Vec3 before = turnRateAt(record, s, true);
        const Vec3 after = turnRateAt(chain.record(next->key), t, false);
        const double size = std::max(glm::length(before), glm::length(after));
        const double longest = 3.2 / std::min(s.work, t.work);
        ASSERT_LT(glm::length(before - after), 2e-3 * size + 2e-5 * longest)
            << "seed " << seed << " key " << k << " orientation " << j;
        ++joints;
      }
    }
  }
}

}  // namespace
}  // namespace vides
