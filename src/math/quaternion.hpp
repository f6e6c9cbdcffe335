// SPDX-License-Identifier: MIT
// Orientations as unit quaternions, and what leads to and from them.
//
// Right-handed, y up. The rest orientation looks along +z with +y up (screen right is -x).
// q = q_yaw(y) q_pitch(x) q_roll(z); VPN = q e_z q^-1, VUP = q e_y q^-1 (paper 4.4.5).
// Positive pitch looks down, positive yaw turns left, positive roll turns the VUP towards -x at
// rest. Angles are radians here. Nothing in this file ever flips a quaternion's sign by itself, and
// every function is exactly odd in the signs: f(-q) == -f(q), bit for bit.
#pragma once

#include "math/vector.hpp"

namespace vides {

struct YawPitchRoll {
  double yaw = 0.0;    // about y, radians
  double pitch = 0.0;  // about the turned x, radians; positive looks down
  double roll = 0.0;   // about the VPN, radians
};

// The viewing direction q e_z q^-1 of a unit quaternion; a unit vector.
Vec3 viewPlaneNormal(const Quaternion& q);
// The up vector q e_y q^-1 of a unit quaternion; a unit vector.
Vec3 viewUpVector(const Quaternion& q);

// Yaw and pitch (roll 0) of a unit direction; yaw is 0 where hypot(n.x, n.z) < 1e-7.
YawPitchRoll yawPitchOf(const Vec3& vpn);
// Yaw, pitch and roll of a camera; VUP is made perpendicular to VPN first. At the poles yaw is 0.
YawPitchRoll yawPitchRollOf(const Vec3& vpn, const Vec3& vup);
Quaternion quaternionFrom(const YawPitchRoll& angles);
// The orientation that looks along the unit direction `vpn` with `roll` radians. Rolls a full turn
// apart give q and -q.
Quaternion quaternionFrom(const Vec3& vpn, double roll);
// The VUP of a camera that looks along `vpn` with `roll` radians, without a quaternion between.
Vec3 viewUpVector(const Vec3& vpn, double roll);

// The angle between unit quaternions on the 3-sphere, 2 atan2(|a-b|, |a+b|), in [0, pi]: half the
// rotation angle where it is <= pi/2. Exact near 0 and near pi.
double angleOnSphere(const Quaternion& a, const Quaternion& b);
// The same up to sign: the smaller of the angles to b and to -b, in [0, pi/2].
double halfRotationAngle(const Quaternion& a, const Quaternion& b);

// The great circle through a (t = 0) and b (t = 1), at any real t. Exact for tiny angles. Where b
// is -a no plane is singled out: one is chosen, always the same.
Quaternion slerp(const Quaternion& a, const Quaternion& b, double t);

// A slerp between fixed ends, its angle and sine computed once; at(t) equals slerp(a, b, t) bit for
// bit.
class SlerpArc {
 public:
  SlerpArc() = default;
  SlerpArc(const Quaternion& a, const Quaternion& b);
  Quaternion at(double t) const;
  const Quaternion& start() const { return a_; }
  const Quaternion& end() const { return b_; }

 private:
  void straightenTangent();

  Quaternion a_{1.0, 0.0, 0.0, 0.0};
  Quaternion b_{1.0, 0.0, 0.0, 0.0};
  Quaternion tangent_{0.0, 0.0, 0.0, 0.0};  // unit, perpendicular to a, towards b
  double angle_ = 0.0;                      // on the 3-sphere, in [0, pi]
};

// Half the rotation angle times the unit axis (world axes) of a unit quaternion; exp is its
// inverse. Exact for tiny angles; log(-1) is some vector of length pi.
Vec3 log(const Quaternion& q);
Quaternion exp(const Vec3& halfAngleAxis);

// Schlag's construction (4.4.4), uniform: the curve piece from q1 (t = 0) to q2 (t = 1) whose
// neighbours are q0 and q3.
class SchlagCurve {
 public:
  SchlagCurve() = default;
  SchlagCurve(const Quaternion& q0, const Quaternion& q1, const Quaternion& q2,
              const Quaternion& q3);
  Quaternion at(double t) const;

 private:
  SlerpArc first_, middle_, last_;
};

// De Casteljau's algorithm with slerp over four control orientations.
class SphericalBezier {
 public:
  SphericalBezier() = default;
  SphericalBezier(const Quaternion& start, const Quaternion& after, const Quaternion& before,
                  const Quaternion& end);
  Quaternion at(double t) const;

 private:
  SlerpArc first_, middle_, last_;
};

}  // namespace vides
