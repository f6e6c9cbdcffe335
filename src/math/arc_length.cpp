// SPDX-License-Identifier: MIT
// Builds the table of arc lengths and inverts it.
//
// The inverse takes a guess from the table, one Gauss-Legendre sum over the part of the panel up to
// it, and a step of fourth order from the speed and its two derivatives there. The panels are made
// so short that this one step nearly always suffices; where it may not, the bracketed iteration
// goes on.
#include "math/arc_length.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vides {
namespace {

// Gauss-Legendre, 8 points +-kNodes on [-1, 1] (to 17 digits).
constexpr std::array<double, 4> kNodes{0.96028985649753623, 0.79666647741362674,
                                       0.52553240991632899, 0.18343464249564980};
constexpr std::array<double, 4> kWeights{0.10122853629037626, 0.22238103445337447,
                                         0.31370664587788729, 0.36268378337836198};

// Two sums that differ by less than this part of the whole length are equal.
constexpr double kSumTolerance = 5e-15;
// A panel is halved while the guess at its middle is off by more than this part of its width …
constexpr double kGuessTolerance = 4e-4;
// … but not below this width for that reason alone.
constexpr double kNarrow = 1.0 / 24.0;
// What the inverse may be off, as a part of the whole length.
constexpr double kInverseTolerance = 1e-13;
constexpr int kMaxDepth = 40;

// |Q'(u)| and what it takes to integrate it.
class Speed {
 public:
  explicit Speed(const CubicSegment& q) : a_(3.0 * q.a), b_(2.0 * q.b), c_(q.c) {}

  double at(double u) const {
    const double x = (a_.x * u + b_.x) * u + c_.x;
    const double y = (a_.y * u + b_.y) * u + c_.y;
    const double z = (a_.z * u + b_.z) * u + c_.z;
    return std::sqrt(x * x + y * y + z * z);
  }

  // The integral from u to u + width. Kept out of loops, where GCC would take its roots one by one.
  [[gnu::noinline]] double integral(double u, double width) const {
    // About the middle, Q'(m +- d) = (e + a d^2) +- d g, so a pair of nodes shares all its
    // products.
    const double half = 0.5 * width, middle = u + half;
    const Vec3 e = (a_ * middle + b_) * middle + c_;
    const Vec3 g = 2.0 * a_ * middle + b_;
    const double ee = glm::dot(e, e), aa = glm::dot(a_, a_);
    const double even = 2.0 * glm::dot(e, a_) + glm::dot(g, g);
    const double eg = 2.0 * glm::dot(e, g), ag = 2.0 * glm::dot(a_, g);
    std::array<double, 8> f;
    for (std::size_t i = 0; i < 4; ++i) {
      const double d = half * kNodes[i], dd = d * d;
      const double sum = ee + dd * (even + dd * aa), odd = d * (eg + dd * ag);
      f[2 * i] = sum + odd;
      f[2 * i + 1] = sum - odd;
    }
    // Rounding may leave a trifle below 0 beside a cusp.
    for (double& value : f) value = std::sqrt(std::max(value, 0.0));
    return half * ((kWeights[0] * (f[0] + f[1]) + kWeights[1] * (f[2] + f[3])) +
                   (kWeights[2] * (f[4] + f[5]) + kWeights[3] * (f[6] + f[7])));
  }

  // At u: 1/f for the speed f, and its first two derivatives beside it, f'/f and f''/f. They mean
  // nothing where the speed is 0.
  struct Jet {
    double inverse, first, second;
  };
  Jet jet(double u) const {
    const Vec3 d1 = (a_ * u + b_) * u + c_;
    const Vec3 d2 = 2.0 * a_ * u + b_;
    const double inverse = 1.0 / std::sqrt(glm::dot(d1, d1));
    const double first = glm::dot(d1, d2) * (inverse * inverse);
    const double both = (glm::dot(d2, d2) + 2.0 * glm::dot(d1, a_)) * (inverse * inverse);
    return {inverse, first, both - first * first};
  }

  // The real roots of d|Q'|^2/du inside (0, 1), ascending. Returns how many.
  int turningPoints(std::array<double, 3>& roots) const;

 private:
  Vec3 a_, b_, c_;  // Q' = a u^2 + b u + c
};

// The root of a cubic that is monotone between lo and hi and has different signs there.
double monotoneRoot(const std::array<double, 4>& c, double lo, double hi) {
  const auto value = [&](double u) { return ((c[3] * u + c[2]) * u + c[1]) * u + c[0]; };
  const bool rising = value(hi) > 0.0;
  double u = 0.5 * (lo + hi);
  for (int i = 0; i < 100; ++i) {
    const double v = value(u);
    if (v == 0.0) return u;
    ((v > 0.0) == rising ? hi : lo) = u;
    const double slope = (3.0 * c[3] * u + 2.0 * c[2]) * u + c[1];
    double next = u - v / slope;
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    if (std::abs(next - u) <= 1e-16 || next == lo || next == hi) return next;
    u = next;
  }
  return u;
}

int Speed::turningPoints(std::array<double, 3>& roots) const {
  const std::array<double, 4> c{glm::dot(b_, c_), glm::dot(b_, b_) + 2.0 * glm::dot(a_, c_),
                                3.0 * glm::dot(a_, b_), 2.0 * glm::dot(a_, a_)};
  // Between its own turning points the cubic is monotone.
  std::array<double, 4> ends{0.0, 1.0, 1.0, 1.0};
  int count = 1;
  const double qa = 3.0 * c[3], qb = c[2], qc = c[1];  // derivative qa u^2 + 2 qb u + qc
  const double discriminant = qb * qb - qa * qc;
  if (discriminant > 0.0) {
    const double q = -(qb + std::copysign(std::sqrt(discriminant), qb));
    std::array<double, 2> turns{q / qa, qc / q};
    if (turns[0] > turns[1]) std::swap(turns[0], turns[1]);
    for (const double t : turns) {
      if (t > 0.0 && t < 1.0) ends[static_cast<std::size_t>(count++)] = t;
    }
  }
  ends[static_cast<std::size_t>(count)] = 1.0;
  const auto value = [&](double u) { return ((c[3] * u + c[2]) * u + c[1]) * u + c[0]; };
  int found = 0;
  for (int i = 0; i < count; ++i) {
    const double lo = ends[static_cast<std::size_t>(i)], hi = ends[static_cast<std::size_t>(i) + 1];
    const double at0 = value(lo), at1 = value(hi);
    if ((at0 < 0.0 && at1 > 0.0) || (at0 > 0.0 && at1 < 0.0)) {
      roots[static_cast<std::size_t>(found++)] = monotoneRoot(c, lo, hi);
    }
  }
  return found;
}

// A panel seen from its start: its width, its length, the speeds at both ends.
struct Span {
  double width, length, f0, f1;
};

// Where, from the start of the panel, the length is about s (in (0, length)).
double guess(const Span& p, double s) {
  const double low = std::min(p.f0, p.f1), high = std::max(p.f0, p.f1);
  if (low > 0.4 * high) {
    // The inverse as a Hermite cubic: u(s) has the slopes 1/f.
    const double t = s / p.length;
    const double m0 = p.length / p.f0, m1 = p.length / p.f1;
    return t * (m0 + t * ((3.0 * p.width - 2.0 * m0 - m1) + t * (m0 + m1 - 2.0 * p.width)));
  }
  // Near a stop 1/f is of no use: take s(u) as the cubic, start from the square root of a linear
  // speed of the same length, and make two steps.
  const double mean = p.length / p.width;
  const double scaled = s * (0.5 * (p.f0 + p.f1) / mean);
  double x =
      2.0 * scaled /
      (p.f0 + std::sqrt(std::max(0.0, p.f0 * p.f0 + 2.0 * scaled * (p.f1 - p.f0) / p.width)));
  const double c2 = (3.0 * mean - 2.0 * p.f0 - p.f1) / p.width;
  const double c3 = (p.f0 + p.f1 - 2.0 * mean) / (p.width * p.width);
  for (int i = 0; i < 2; ++i) {
    const double value = x * (p.f0 + x * (c2 + x * c3)) - s;
    const double slope = p.f0 + x * (2.0 * c2 + x * 3.0 * c3);
    const double next = x - value / slope;
    if (!(next > 0.0 && next < p.width)) break;
    x = next;
  }
  return x;
}

}  // namespace

class ArcLength::Builder {
 public:
  explicit Builder(const CubicSegment& segment) : speed_(segment) { panels_.reserve(64); }

  void build(ArcLength& table) {
    std::array<double, 3> roots;
    const int count = speed_.turningPoints(roots);
    std::array<double, 5> ends{0.0, 1.0, 1.0, 1.0, 1.0};
    std::size_t n = 1;
    for (int i = 0; i < count; ++i) {
      const double root = roots[static_cast<std::size_t>(i)];
      if (root > ends[n - 1] && root < 1.0) ends[n++] = root;
    }
    ends[n] = 1.0;

    std::array<double, 4> sums{};
    for (std::size_t i = 0; i < n; ++i) {
      sums[i] = speed_.integral(ends[i], ends[i + 1] - ends[i]);
      scale_ += sums[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      add({ends[i], ends[i + 1], speed_.at(ends[i]), speed_.at(ends[i + 1]), sums[i]}, 0);
    }
    panels_.push_back({1.0, length_, speed_.at(1.0)});
    table.panels_.assign(panels_);
    table.length_ = length_;
  }

 private:
  struct Piece {
    double lo, hi, f0, f1, sum;
  };

  void add(const Piece& p, int depth) {
    const double width = p.hi - p.lo, middle = p.lo + 0.5 * width;
    const double left = speed_.integral(p.lo, middle - p.lo);
    const double right = speed_.integral(middle, p.hi - middle);
    const double sum = left + right;
    const bool whole = std::abs(p.sum - sum) <= kSumTolerance * scale_;
    if (depth >= kMaxDepth || (whole && (width < kNarrow || guessable(p, left, sum)))) {
      panels_.push_back({p.lo, length_, p.f0});
      length_ += sum;
      return;
    }
    const double f = speed_.at(middle);
    add({p.lo, middle, p.f0, f, left}, depth + 1);
    add({middle, p.hi, f, p.f1, right}, depth + 1);
  }

  // Whether the inverse's guess is good in the middle, where it is worst.
  static bool guessable(const Piece& p, double left, double sum) {
    const double width = p.hi - p.lo;
    if (!(sum > 0.0)) return true;
    return std::abs(guess({width, sum, p.f0, p.f1}, left) - 0.5 * width) <= kGuessTolerance * width;
  }

  Speed speed_;
  std::vector<Panel> panels_;
  double scale_ = 0.0;   // about the whole length
  double length_ = 0.0;  // of the panels so far
};

void ArcLength::PanelList::assign(const std::vector<Panel>& panels) {
  size_ = panels.size();
  if (size_ <= kInPlace) {
    std::copy(panels.begin(), panels.end(), near_.begin());
  } else {
    far_.assign(panels.begin(), panels.end());
  }
}

ArcLength::ArcLength(const CubicSegment& segment) { Builder(segment).build(*this); }

double ArcLength::lengthAt(const CubicSegment& segment, double u) const {
  if (!(u > 0.0) || panels_.empty()) return 0.0;
  if (u >= 1.0) return length_;
  const auto next = std::upper_bound(panels_.begin(), panels_.end(), u,
                                     [](double value, const Panel& p) { return value < p.u; });
  const Panel& panel = *(next - 1);
  const double s = panel.s + Speed(segment).integral(panel.u, u - panel.u);
  return std::min(s, next->s);
}

double ArcLength::parameterAt(const CubicSegment& segment, double s) const {
  if (!(s > 0.0)) return 0.0;
  if (s >= length_) return 1.0;
  // The panel that holds s: the last that starts at or before it.
  const Panel* panel = panels_.begin();
  for (std::size_t count = panels_.size() - 1; count > 1;) {
    const std::size_t half = count / 2;
    panel += panel[half].s <= s ? half : 0;
    count -= half;
  }
  const Panel& next = panel[1];
  const Speed speed(segment);
  const double tolerance = kInverseTolerance * length_;
  const double target = s - panel->s;
  double lo = 0.0, hi = next.u - panel->u;
  if (!(target > 0.0)) return panel->u;

  double x = guess({hi, next.s - panel->s, panel->speed, next.speed}, target);
  const double width = hi;
  for (int i = 0; i < 100; ++i) {
    if (!(x > lo && x < hi)) x = 0.5 * (lo + hi);
    // The jet doesn't wait for the sum: the processor does both at once.
    const Speed::Jet jet = speed.jet(panel->u + x);
    const double rest = target - speed.integral(panel->u, x);
    (rest > 0.0 ? lo : hi) = x;
    // u(s) as a series about x; e bounds the relative size of a term beside the one before.
    const double step = rest * jet.inverse;
    const double q1 = jet.first * step, q2 = jet.second * step * step;
    const double improved = x + step * (1.0 - 0.5 * q1 + (3.0 * q1 * q1 - q2) / 6.0);
    const double e = std::abs(q1) + std::sqrt(std::abs(q2)) + std::abs(step) / width;
    if (std::abs(rest) * e * e * e <= tolerance && improved >= lo && improved <= hi) {
      x = improved;
      break;
    }
    if (std::abs(rest) <= tolerance || hi - lo <= 1e-16) break;
    x = improved;
  }
  return std::min(panel->u + x, next.u);
}

}  // namespace vides
