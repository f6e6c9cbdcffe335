// SPDX-License-Identifier: MIT
// How long the mathematics takes: curve points, arc lengths and their inverse, orientation curves.
#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <cstddef>
#include <random>
#include <unsupported/Eigen/Splines>
#include <vector>

#include "bars.hpp"
#include "math/arc_length.hpp"
#include "math/kochanek_bartels.hpp"
#include "math/quaternion.hpp"
#include "math/speed_curve.hpp"

namespace vides {
namespace {

constexpr std::size_t kCount = 1024;  // inputs in turn, so that no branch learns one by heart

class Random {
 public:
  double unit() { return share_(engine_); }
  double signedUnit() { return 2.0 * unit() - 1.0; }
  Vec3 inCube() {
    const double x = signedUnit(), y = signedUnit();
    return {x, y, signedUnit()};
  }
  Quaternion orientation() {
    const double x = signedUnit(), y = signedUnit(), z = signedUnit();
    return glm::normalize(Quaternion(signedUnit(), x, y, z));
  }

 private:
  std::mt19937_64 engine_{20};
  std::uniform_real_distribution<double> share_{0.0, 1.0};
};

// Pieces between keys anywhere in the cube, with moderate shapes.
std::vector<CubicSegment> usualSegments() {
  Random random;
  std::vector<CubicSegment> segments;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Vec3 before = random.inCube(), p0 = random.inCube(), p1 = random.inCube(),
               after = random.inCube();
    const Shape s0{0.5 * random.signedUnit(), 0.0, 0.5 * random.signedUnit()};
    segments.push_back(kochanekBartelsSegment(&before, p0, s0, p1, {}, &after));
  }
  return segments;
}

std::vector<double> shares() {
  Random random;
  std::vector<double> values(kCount);
  for (double& v : values) v = random.unit();
  return values;
}

// The peer: a cubic B-spline of Eigen's through the same number of points.
void cubicPointEigenSplines(benchmark::State& state) {
  using Spline = Eigen::Spline<double, 3, 3>;
  Random random;
  Eigen::Matrix<double, 3, Eigen::Dynamic> points(3, 64);
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    const Vec3 p = random.inCube();
    points.col(k) << p.x, p.y, p.z;
  }
  const Spline spline = Eigen::SplineFitting<Spline>::Interpolate(points, 3);
  const auto u = shares();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(spline(u[i]));
    i = (i + 1) % kCount;
  }
}
BENCHMARK(cubicPointEigenSplines);

void cubicPoint(benchmark::State& state) {
  const auto segments = usualSegments();
  const auto u = shares();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(segments[i].point(u[i]));
    i = (i + 1) % kCount;
  }
  bench::setPeer(state, "cubicPointEigenSplines");
}
BENCHMARK(cubicPoint);

void buildArcLength(benchmark::State& state) {
  const auto segments = usualSegments();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ArcLength(segments[i]));
    i = (i + 1) % kCount;
  }
  bench::setLimit(state, 4000.0);
}
BENCHMARK(buildArcLength);

void inverseArcLength(benchmark::State& state) {
  const auto segments = usualSegments();
  const auto share = shares();
  std::vector<ArcLength> lengths;
  for (const CubicSegment& s : segments) lengths.emplace_back(s);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(lengths[i].parameterAt(segments[i], share[i] * lengths[i].length()));
    i = (i + 1) % kCount;
  }
  bench::setLimit(state, 100.0);
}
BENCHMARK(inverseArcLength);

void sphericalSlerp(benchmark::State& state) {
  Random random;
  std::vector<Quaternion> q;
  for (std::size_t i = 0; i <= kCount; ++i) q.push_back(random.orientation());
  const auto t = shares();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(slerp(q[i], q[i + 1], t[i]));
    i = (i + 1) % kCount;
  }
}
BENCHMARK(sphericalSlerp);

void preparedSlerp(benchmark::State& state) {
  Random random;
  std::vector<SlerpArc> arcs;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Quaternion a = random.orientation();
    arcs.emplace_back(a, random.orientation());
  }
  const auto t = shares();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(arcs[i].at(t[i]));
    i = (i + 1) % kCount;
  }
}
BENCHMARK(preparedSlerp);

template <typename Curve>
void orientationCurve(benchmark::State& state) {
  Random random;
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Quaternion a = random.orientation(), b = random.orientation(), c = random.orientation();
    curves.emplace_back(a, b, c, random.orientation());
  }
  const auto t = shares();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(curves[i].at(t[i]));
    i = (i + 1) % kCount;
  }
  bench::setLimit(state, 250.0);
}
BENCHMARK(orientationCurve<SphericalBezier>);
BENCHMARK(orientationCurve<SchlagCurve>);

void quaternionFromVpnAndRoll(benchmark::State& state) {
  Random random;
  std::vector<Vec3> vpn;
  for (std::size_t i = 0; i < kCount; ++i) vpn.push_back(glm::normalize(random.inCube()));
  const auto roll = shares();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(quaternionFrom(vpn[i], roll[i]));
    i = (i + 1) % kCount;
  }
}
BENCHMARK(quaternionFromVpnAndRoll);

void speedProgress(benchmark::State& state) {
  const SpeedCurve curve({30, 42, 55, 61, 58, 50, 44, 47, 52, 50}, 25.0, 60.0);
  const auto tau = shares();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(curve.progress(tau[i]));
    i = (i + 1) % kCount;
  }
}
BENCHMARK(speedProgress);

}  // namespace
}  // namespace vides
