// SPDX-License-Identifier: MIT
// Conversions between VPN, VUP, angles and quaternions against the reference; poles, logarithms.
#include "math/quaternion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "math/random.hpp"
#include "math/reference_data.hpp"

namespace vides {
namespace {

using test::difference;
using test::differenceOfRotations;
using test::Json;
using test::quaternion;
using test::Random;
using test::vec3;

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180.0;

double angleDifference(double a, double b) { return std::abs(std::remainder(a - b, 2 * kPi)); }

TEST(Orientation, TableMatchesTheReference) {
  const Json data = test::reference("04_orientation_conversions.json");
  for (const Json& row : data.at("table")) {
    const Vec3 euler = vec3(row.at("euler_in_deg")) * kDegree;
    const Quaternion q = quaternionFrom({euler.x, euler.y, euler.z});
    const std::string what = row.at("euler_in_deg").dump();
    const Vec3 vpn = vec3(row.at("VPN")), vup = vec3(row.at("VUP"));
    EXPECT_LT(differenceOfRotations(q, quaternion(row.at("q"))), 1e-13) << what;
    EXPECT_LT(difference(viewPlaneNormal(q), vpn), 1e-13) << what;
    EXPECT_LT(difference(viewUpVector(q), vup), 1e-13) << what;
    EXPECT_LT(difference(glm::cross(vpn, vup), vec3(row.at("right"))), 1e-13) << what;

    const YawPitchRoll back = yawPitchRollOf(vpn, vup);
    EXPECT_LT(differenceOfRotations(quaternionFrom(back), q), 1e-12) << what;
    const Vec3 canonical = vec3(row.at("euler_canonical_deg")) * kDegree;
    if (std::abs(std::abs(canonical.y) - kPi / 2) > 0.01 * kDegree) {
      EXPECT_LT(angleDifference(back.yaw, canonical.x), 1e-10 * kDegree) << what;
      EXPECT_LT(angleDifference(back.pitch, canonical.y), 1e-10 * kDegree) << what;
      EXPECT_LT(angleDifference(back.roll, canonical.z), 1e-10 * kDegree) << what;
    } else if (std::hypot(vpn.x, vpn.z) < 1e-7) {
      EXPECT_EQ(back.yaw, 0.0) << what;  // ours, at the poles
    }
  }
  EXPECT_GE(data.at("table").size(), 438u);
}

TEST(Orientation, FromVectorsMatchesTheReference) {
  const Json data = test::reference("04_orientation_conversions.json");
  for (const Json& row : data.at("from_vectors")) {
    const Vec3 vpn = glm::normalize(vec3(row.at("VPN_in")));
    const YawPitchRoll angles = yawPitchRollOf(vpn, vec3(row.at("VUP_in")));
    const Quaternion q = quaternionFrom(angles);
    // Within 1e-7 of the pole our yaw is 0, which turns the VPN by as much.
    const double tolerance = row.at("name") == "near +y pole 1e-8" ? 2e-8 : 1e-13;
    EXPECT_LT(differenceOfRotations(q, quaternion(row.at("q"))), tolerance) << row.at("name");
    EXPECT_LT(difference(viewPlaneNormal(q), vec3(row.at("VPN"))), tolerance) << row.at("name");
    EXPECT_LT(difference(viewUpVector(q), vec3(row.at("VUP"))), tolerance) << row.at("name");
  }
}

TEST(Orientation, FromAimAndRollMatchesTheReference) {
  const Json data = test::reference("04_orientation_conversions.json");
  for (const Json& row : data.at("from_target_and_roll")) {
    const Vec3 vpn = glm::normalize(vec3(row.at("VPN_in")));
    const double roll = row.at("roll_deg").get<double>() * kDegree;
    const Quaternion q = quaternionFrom(vpn, roll);
    EXPECT_LT(differenceOfRotations(q, quaternion(row.at("q"))), 1e-13) << row.at("name");
    EXPECT_LT(difference(viewUpVector(vpn, roll), vec3(row.at("VUP"))), 1e-13) << row.at("name");
  }
}

TEST(Orientation, Rest) {
  const Quaternion rest{1, 0, 0, 0};
  EXPECT_EQ(viewPlaneNormal(rest), Vec3(0, 0, 1));
  EXPECT_EQ(viewUpVector(rest), Vec3(0, 1, 0));
  EXPECT_EQ(quaternionFrom(YawPitchRoll{}), rest);
}

TEST(Orientation, SignsOfTheAngles) {
  // Positive pitch looks down, positive yaw turns left (towards +x, for right is -x), positive roll
  // turns the VUP towards -x.
  EXPECT_LT(viewPlaneNormal(quaternionFrom({0, 0.1, 0})).y, 0.0);
  EXPECT_GT(viewPlaneNormal(quaternionFrom({0.1, 0, 0})).x, 0.0);
  EXPECT_LT(viewUpVector(quaternionFrom({0, 0, 0.1})).x, 0.0);
}

// Directions everywhere, and close to the poles on both sides of the limit.
Vec3 anyDirection(Random& random, int i) {
  if (i % 3 != 0) return random.direction();
  const double level = random.magnitude(-12, -2), yaw = random.angle();
  const double up = random.coin() ? 1.0 : -1.0;
  return glm::normalize(Vec3{level * std::sin(yaw), up, level * std::cos(yaw)});
}

TEST(Orientation, DirectionAndRollAgreeWithTheAngles) {
  Random random(21);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 vpn = anyDirection(random, i);
    const double roll = random.between(-10, 10);
    const bool pole = std::hypot(vpn.x, vpn.z) < 1e-7;
    YawPitchRoll angles = yawPitchOf(vpn);
    angles.roll = roll;
    const Quaternion q = quaternionFrom(vpn, roll);
    ASSERT_LT(difference(q, quaternionFrom(angles)), 1e-15);
    ASSERT_LT(difference(viewUpVector(vpn, roll), viewUpVector(q)), 1e-15);
    ASSERT_LT(difference(viewPlaneNormal(q), vpn), pole ? 2e-7 : 1e-15);
    ASSERT_NEAR(glm::length(viewUpVector(q)), 1.0, 1e-15);
    ASSERT_NEAR(glm::dot(viewUpVector(q), viewPlaneNormal(q)), 0.0, 1e-15);
    if (pole) {
      ASSERT_EQ(angles.yaw, 0.0);
    }
    const YawPitchRoll back = yawPitchRollOf(viewPlaneNormal(q), viewUpVector(q));
    if (!pole) {
      ASSERT_LT(angleDifference(back.roll, roll), 1e-14 / std::hypot(vpn.x, vpn.z));
    }
  }
}

TEST(Orientation, AFullTurnOfRollIsTheOtherSign) {
  Random random(22);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 vpn = random.direction();
    const double roll = random.angle();
    ASSERT_LT(difference(quaternionFrom(vpn, roll + 2 * kPi), -quaternionFrom(vpn, roll)), 1e-15);
  }
}

TEST(Orientation, AnUpVectorAlongTheViewTellsNoRoll) {
  Random random(23);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 vpn = random.direction();
    ASSERT_EQ(yawPitchRollOf(vpn, vpn * random.between(-2, 2)).roll, 0.0);
    ASSERT_EQ(yawPitchRollOf(vpn, Vec3{0.0}).roll, 0.0);
  }
}

TEST(Orientation, SignOfTheQuaternionMeansNothing) {
  Random random(24);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion q = random.orientation();
    ASSERT_EQ(viewPlaneNormal(q), viewPlaneNormal(-q));
    ASSERT_EQ(viewUpVector(q), viewUpVector(-q));
  }
}

TEST(Logarithm, IsInvertedByExp) {
  Random random(25);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 v =
        random.direction() * (i % 2 ? random.between(0, kPi) : random.magnitude(-300, 0));
    const Vec3 back = log(exp(v));
    const double size = glm::length(v);
    // Near pi the direction is all there is in the small vector part.
    ASSERT_LE(difference(back, v), 1e-15 * size + (size > 3 ? 1e-14 : 0.0)) << size;
    const Quaternion q = random.orientation();
    ASSERT_LT(difference(exp(log(q)), q), 1e-15);
  }
}

TEST(Logarithm, AtOneAndMinusOne) {
  EXPECT_EQ(log(Quaternion(1, 0, 0, 0)), Vec3(0.0));
  EXPECT_DOUBLE_EQ(glm::length(log(Quaternion(-1, 0, 0, 0))), kPi);
  EXPECT_EQ(exp(Vec3(0.0)), Quaternion(1, 0, 0, 0));
  // Half the angle: a quarter turn about y has pi/4.
  const Vec3 quarter = log(quaternionFrom({kPi / 2, 0, 0}));
  EXPECT_LT(difference(quarter, Vec3(0, kPi / 4, 0)), 1e-15);
  EXPECT_LT(difference(log(Quaternion(1, 1e-200, 0, 0)), Vec3(1e-200, 0, 0)), 1e-210);
}

TEST(Angle, HalfTheRotationAndUpToSign) {
  const Quaternion a = quaternionFrom({0.3, 0.2, 0.1});
  for (const double angle : {1e-15, 1e-9, 0.1, 1.0, 2.0, 3.0}) {
    const Quaternion b = a * quaternionFrom({0, 0, angle});
    EXPECT_NEAR(angleOnSphere(a, b), 0.5 * angle, 3e-16);
    EXPECT_NEAR(angleOnSphere(a, -b), kPi - 0.5 * angle, 1e-15);
    EXPECT_NEAR(halfRotationAngle(a, -b), 0.5 * angle, 3e-16);
    EXPECT_EQ(halfRotationAngle(a, -b), halfRotationAngle(a, b));
  }
  EXPECT_EQ(angleOnSphere(a, a), 0.0);
  EXPECT_DOUBLE_EQ(angleOnSphere(a, -a), kPi);
}

}  // namespace
}  // namespace vides
