// SPDX-License-Identifier: MIT
// From the angles back to the camera, by matrices that are formed here.
#include "io/camera_angles.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "math/quaternion.hpp"

namespace vides {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;  // rows

constexpr double kDegree = std::numbers::pi / 180.0;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

// R_y(ry) R_x(rx) R_z(rz), each turning counter-clockwise about its axis.
Matrix matrixOf(const CameraAngles& a) {
  const double cx = std::cos(a.rx * kDegree), sx = std::sin(a.rx * kDegree);
  const double cy = std::cos(a.ry * kDegree), sy = std::sin(a.ry * kDegree);
  const double cz = std::cos(a.rz * kDegree), sz = std::sin(a.rz * kDegree);
  const Matrix x{{{1, 0, 0}, {0, cx, -sx}, {0, sx, cx}}};
  const Matrix y{{{cy, 0, sy}, {0, 1, 0}, {-sy, 0, cy}}};
  const Matrix z{{{cz, -sz, 0}, {sz, cz, 0}, {0, 0, 1}}};
  return product(product(y, x), z);
}

void expectGives(const CameraAngles& angles, const Camera& camera, double tolerance = 1e-12) {
  const Matrix m = matrixOf(angles);
  const Vec3& up = camera.viewUpVector;
  const Vec3& n = camera.viewPlaneNormal;
  const Vec3 right{n.y * up.z - n.z * up.y, n.z * up.x - n.x * up.z, n.x * up.y - n.y * up.x};
  for (int i = 0; i < 3; ++i) {
    const auto row = static_cast<std::size_t>(i);
    ASSERT_NEAR(m[row][0], right[i], tolerance);
    ASSERT_NEAR(m[row][1], up[i], tolerance);
    ASSERT_NEAR(m[row][2], -n[i], tolerance);
  }
}

Camera cameraOf(const Quaternion& q) {
  Camera camera;
  camera.viewPlaneNormal = viewPlaneNormal(q);
  camera.viewUpVector = viewUpVector(q);
  return camera;
}

Camera cameraAt(double yaw, double pitch, double roll) {
  return cameraOf(quaternionFrom(YawPitchRoll{yaw * kDegree, pitch * kDegree, roll * kDegree}));
}

TEST(CameraAngles, AtRestTheCameraIsTurnedRound) {
  const CameraAngles a = AngleChain().next(Camera{});
  EXPECT_DOUBLE_EQ(a.rx, 0.0);
  EXPECT_DOUBLE_EQ(a.ry, 180.0);  // looks along +z, where an unturned one looks along -z
  EXPECT_DOUBLE_EQ(a.rz, 0.0);
}

TEST(CameraAngles, LookingUpIsPositive) {
  Camera camera;
  camera.viewPlaneNormal = {0.0, 0.6, -0.8};
  camera.viewUpVector = {0.0, 0.8, 0.6};
  const CameraAngles a = AngleChain().next(camera);
  EXPECT_NEAR(a.rx, 36.86989764584402, 1e-12);
  EXPECT_NEAR(a.ry, 0.0, 1e-12);
  EXPECT_NEAR(a.rz, 0.0, 1e-12);
}

TEST(CameraAngles, GiveBackEveryOrientation) {
  std::mt19937_64 random{7};
  std::normal_distribution<double> normal;
  AngleChain chain;
  for (int i = 0; i < 100'000; ++i) {
    const double w = normal(random), x = normal(random), y = normal(random);
    const Camera camera = cameraOf(glm::normalize(Quaternion(w, x, y, normal(random))));
    const CameraAngles first = AngleChain().next(camera);
    expectGives(first, camera);
    EXPECT_LE(std::abs(first.rx), 90.0);
    EXPECT_LE(std::abs(first.ry), 180.0);
    EXPECT_LE(std::abs(first.rz), 180.0);
    expectGives(chain.next(camera), camera, 1e-10);
  }
}

TEST(CameraAngles, ContinueOverHalfATurn) {
  AngleChain chain;
  CameraAngles before = chain.next(cameraAt(0, 10, 0));
  for (int i = 1; i <= 1500; ++i) {
    const Camera camera = cameraAt(i, 10, 2.0 * i);  // four turns of yaw, eight of roll
    const CameraAngles a = chain.next(camera);
    expectGives(a, camera, 1e-9);
    EXPECT_LT(std::abs(a.ry - before.ry), 1.001);
    EXPECT_LT(std::abs(a.rz - before.rz), 2.001);
    before = a;
  }
  EXPECT_NEAR(std::abs(before.ry - AngleChain().next(cameraAt(0, 10, 0)).ry), 1500.0, 1e-6);
}

TEST(CameraAngles, AtThePolesRzStaysAndRyTakesTheRest) {
  for (const double pole : {90.0, -90.0}) {
    AngleChain chain;
    const CameraAngles before = chain.next(cameraAt(20, 0.99 * pole, 30));
    ASSERT_GT(std::abs(before.rz), 1.0);
    const Camera camera = cameraAt(25, pole, 30);
    const CameraAngles a = chain.next(camera);
    EXPECT_EQ(a.rz, before.rz);
    EXPECT_NEAR(std::abs(a.rx), 90.0, 1e-9);
    expectGives(a, camera, 2e-7);
    // The first frame has nothing to continue.
    const CameraAngles first = AngleChain().next(camera);
    EXPECT_EQ(first.rz, 0.0);
    expectGives(first, camera, 2e-7);
  }
}

TEST(CameraAngles, NothingJumpsOverThePoles) {
  // A looping: pitch through both poles, never a change of more than the step.
  for (const double step : {1.0, 0.7, 7.0}) {
    AngleChain chain;
    CameraAngles before = chain.next(cameraAt(40, 0, 0));
    for (double pitch = step; pitch < 800.0; pitch += step) {
      const Camera camera = cameraAt(40, pitch, 0);
      const CameraAngles a = chain.next(camera);
      expectGives(a, camera, 2e-7);
      EXPECT_NEAR(std::abs(a.rx - before.rx), step, 1e-4);
      EXPECT_NEAR(a.ry, before.ry, 1e-4);
      EXPECT_NEAR(a.rz, before.rz, 1e-4);
      before = a;
    }
  }
}

}  // namespace
}  // namespace vides
