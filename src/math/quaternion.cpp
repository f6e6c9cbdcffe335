// SPDX-License-Identifier: MIT
// Orientations as unit quaternions: conversions, slerp, Schlag's and Bézier's constructions.
#include "math/quaternion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vides {
namespace {

constexpr double kPi = std::numbers::pi;
// Closer to the vertical than this, the yaw is taken as 0.
constexpr double kPole = 1e-7;
// |a + b| below this is rounding: b is -a and no great circle is singled out.
constexpr double kAntipodal = 1e-14;

struct CosSin {
  double cos = 1.0;
  double sin = 0.0;
};

// Yaw and pitch of a direction as points on the unit circle.
struct Heading {
  CosSin yaw, pitch;
};

Heading headingOf(const Vec3& vpn) {
  const double level = std::sqrt(vpn.x * vpn.x + vpn.z * vpn.z);
  Heading h;
  if (level >= kPole) h.yaw = {vpn.z / level, vpn.x / level};
  h.pitch = {level, -vpn.y};
  return h;
}

// Cosine and sine of half an angle in [-pi, pi]. The root is always taken of the larger one, so
// that nothing cancels.
CosSin halved(const CosSin& a) {
  if (a.cos >= 0.0) {
    const double c = std::sqrt(0.5 * (1.0 + a.cos));
    return {c, 0.5 * a.sin / c};
  }
  const double s = std::copysign(std::sqrt(0.5 * (1.0 - a.cos)), a.sin);
  return {0.5 * a.sin / s, s};
}

// q_yaw q_pitch q_roll, from the cosines and sines of half the angles.
Quaternion composed(const CosSin& yaw, const CosSin& pitch, const CosSin& roll) {
  const double w = yaw.cos * pitch.cos;
  const double x = yaw.cos * pitch.sin;
  const double y = yaw.sin * pitch.cos;
  const double z = -yaw.sin * pitch.sin;
  return {w * roll.cos - z * roll.sin, x * roll.cos + y * roll.sin, y * roll.cos - x * roll.sin,
          z * roll.cos + w * roll.sin};
}

double squaredDistance(const Quaternion& a, const Quaternion& b) {
  const double w = a.w - b.w, x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return (w * w + x * x) + (y * y + z * z);
}

double squaredSum(const Quaternion& a, const Quaternion& b) {
  const double w = a.w + b.w, x = a.x + b.x, y = a.y + b.y, z = a.z + b.z;
  return (w * w + x * x) + (y * y + z * z);
}

// s a + t b, exactly odd in (a, b).
Quaternion weighted(double s, const Quaternion& a, double t, const Quaternion& b) {
  return {s * a.w + t * b.w, s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
}

}  // namespace

Vec3 viewPlaneNormal(const Quaternion& q) {
  return {2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x),
          (q.w * q.w - q.x * q.x) + (q.z * q.z - q.y * q.y)};
}

Vec3 viewUpVector(const Quaternion& q) {
  return {2.0 * (q.x * q.y - q.w * q.z), (q.w * q.w - q.x * q.x) + (q.y * q.y - q.z * q.z),
          2.0 * (q.y * q.z + q.w * q.x)};
}

YawPitchRoll yawPitchOf(const Vec3& vpn) {
  const double level = std::hypot(vpn.x, vpn.z);
  YawPitchRoll angles;
  if (level >= kPole) angles.yaw = std::atan2(vpn.x, vpn.z);
  angles.pitch = std::atan2(-vpn.y, level);
  return angles;
}

YawPitchRoll yawPitchRollOf(const Vec3& vpn, const Vec3& vup) {
  YawPitchRoll angles = yawPitchOf(vpn);
  const Vec3 up = vup - glm::dot(vup, vpn) / glm::dot(vpn, vpn) * vpn;
  // A VUP along the VPN tells nothing: no roll, rather than the roll of a rounding error.
  if (!(glm::dot(up, up) > 1e-24 * glm::dot(vup, vup))) return angles;
  const double cy = std::cos(angles.yaw), sy = std::sin(angles.yaw);
  const double cp = std::cos(angles.pitch), sp = std::sin(angles.pitch);
  const Vec3 x0{cy, 0.0, -sy};
  const Vec3 y0{sp * sy, cp, sp * cy};
  angles.roll = std::atan2(-glm::dot(up, x0), glm::dot(up, y0));
  return angles;
}

Quaternion quaternionFrom(const YawPitchRoll& angles) {
  const auto half = [](double a) { return CosSin{std::cos(0.5 * a), std::sin(0.5 * a)}; };
  return composed(half(angles.yaw), half(angles.pitch), half(angles.roll));
}

Quaternion quaternionFrom(const Vec3& vpn, double roll) {
  const Heading h = headingOf(vpn);
  return composed(halved(h.yaw), halved(h.pitch), {std::cos(0.5 * roll), std::sin(0.5 * roll)});
}

Vec3 viewUpVector(const Vec3& vpn, double roll) {
  const Heading h = headingOf(vpn);
  const double c = std::cos(roll), s = std::sin(roll);
  const double along = c * h.pitch.sin;  // share of y0 in the heading's level direction
  return {along * h.yaw.sin - s * h.yaw.cos, c * h.pitch.cos, along * h.yaw.cos + s * h.yaw.sin};
}

double angleOnSphere(const Quaternion& a, const Quaternion& b) {
  return 2.0 * std::atan2(std::sqrt(squaredDistance(a, b)), std::sqrt(squaredSum(a, b)));
}

double halfRotationAngle(const Quaternion& a, const Quaternion& b) {
  const double minus = squaredDistance(a, b), plus = squaredSum(a, b);
  return 2.0 * std::atan2(std::sqrt(std::min(minus, plus)), std::sqrt(std::max(minus, plus)));
}

Quaternion slerp(const Quaternion& a, const Quaternion& b, double t) {
  return SlerpArc(a, b).at(t);
}

SlerpArc::SlerpArc(const Quaternion& a, const Quaternion& b) : a_(a), b_(b) {
  const double squaredMinus = squaredDistance(a, b), squaredPlus = squaredSum(a, b);
  const double minus = std::sqrt(squaredMinus), plus = std::sqrt(squaredPlus);
  if (minus == 0.0) return;  // one point: the tangent stays zero
  if (plus < kAntipodal) {
    angle_ = kPi;
    tangent_ = {-a.x, a.w, a.z, -a.y};  // a i: unit, perpendicular to a, and odd in a
    return;
  }
  angle_ = 2.0 * std::atan2(minus, plus);
  // (b - a cos)/sin, from the difference or the sum: whichever doesn't cancel.
  const double inverseSine = 2.0 / (minus * plus);
  if (squaredMinus <= squaredPlus) {
    const double s = 0.5 * squaredMinus;  // 1 - cos
    tangent_ = {((b.w - a.w) + s * a.w) * inverseSine, ((b.x - a.x) + s * a.x) * inverseSine,
                ((b.y - a.y) + s * a.y) * inverseSine, ((b.z - a.z) + s * a.z) * inverseSine};
  } else {
    const double s = 0.5 * squaredPlus;  // 1 + cos
    tangent_ = {((b.w + a.w) - s * a.w) * inverseSine, ((b.x + a.x) - s * a.x) * inverseSine,
                ((b.y + a.y) - s * a.y) * inverseSine, ((b.z + a.z) - s * a.z) * inverseSine};
  }
  if (squaredPlus < 1e-2) straightenTangent();
}

// Near pi a rounding error of |a| or |b| is large beside the sine. What of it lies along a would
// make the result longer than a unit quaternion: take it out. (Near 0 it is harmless: at()
// multiplies the tangent by as small a sine.)
void SlerpArc::straightenTangent() {
  const double along =
      (a_.w * tangent_.w + a_.x * tangent_.x) + (a_.y * tangent_.y + a_.z * tangent_.z);
  const Quaternion level = weighted(1.0, tangent_, -along, a_);
  const double length =
      std::sqrt((level.w * level.w + level.x * level.x) + (level.y * level.y + level.z * level.z));
  tangent_ = {level.w / length, level.x / length, level.y / length, level.z / length};
}

Quaternion SlerpArc::at(double t) const {
  if (t == 0.0) return a_;
  if (t == 1.0) return b_;
  const double angle = t * angle_;
  return weighted(std::cos(angle), a_, std::sin(angle), tangent_);
}

Vec3 log(const Quaternion& q) {
  const double sine = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
  if (sine == 0.0) return q.w >= 0.0 ? Vec3{q.x, q.y, q.z} : Vec3{kPi, 0.0, 0.0};
  return std::atan2(sine, q.w) / sine * Vec3{q.x, q.y, q.z};
}

Quaternion exp(const Vec3& halfAngleAxis) {
  const double angle = std::sqrt(glm::dot(halfAngleAxis, halfAngleAxis));
  const double scale = angle == 0.0 ? 1.0 : std::sin(angle) / angle;
  return {std::cos(angle), scale * halfAngleAxis.x, scale * halfAngleAxis.y,
          scale * halfAngleAxis.z};
}

SchlagCurve::SchlagCurve(const Quaternion& q0, const Quaternion& q1, const Quaternion& q2,
                         const Quaternion& q3)
    : first_(q0, q1), middle_(q1, q2), last_(q2, q3) {}

Quaternion SchlagCurve::at(double t) const {
  const Quaternion q10 = first_.at(t + 1.0);
  const Quaternion q11 = middle_.at(t);
  const Quaternion q12 = last_.at(t - 1.0);
  const Quaternion q20 = slerp(q10, q11, 0.5 * (t + 1.0));
  const Quaternion q21 = slerp(q11, q12, 0.5 * t);
  return slerp(q20, q21, t);
}

SphericalBezier::SphericalBezier(const Quaternion& start, const Quaternion& after,
                                 const Quaternion& before, const Quaternion& end)
    : first_(start, after), middle_(after, before), last_(before, end) {}

Quaternion SphericalBezier::at(double t) const {
  const Quaternion q10 = first_.at(t);
  const Quaternion q11 = middle_.at(t);
  const Quaternion q12 = last_.at(t);
  return slerp(slerp(q10, q11, t), slerp(q11, q12, t), t);
}

}  // namespace vides
