// SPDX-License-Identifier: MIT
// Levenberg and Marquardt's way to the wished speeds, kept within [1, 100].
#include "math/speed_fit.hpp"

#include <algorithm>
#include <cmath>

namespace vides {
namespace {

constexpr std::size_t kLast = kSpeedValues - 1;
constexpr int kMostRounds = 40;
// A mean counts more than a share; that the values stay near where they began counts little.
constexpr double kMeanWeight = 30.0;
constexpr double kNearWeight = 1e-6;
constexpr double kStep = 1e-4;  // of the derivatives
constexpr std::size_t kRows = SpeedWish::kSteps - 1 + 1 + kSpeedValues;

using Rows = std::array<double, kRows>;

class Fit {
 public:
  explicit Fit(std::vector<SpeedWish>& wishes) : wishes_(wishes) {
    for (std::size_t w = 0; w < wishes.size(); ++w) {
      begins_.push_back(wishes[w].values);
      for (std::size_t j = 0; j < kSpeedValues; ++j) {
        const bool kept = (j == 0 && wishes[w].keepsFirst) || (j == kLast && wishes[w].keepsLast);
        if (!kept) free_.push_back({w, j});
      }
    }
  }
  void run();

 private:
  struct Place {
    std::size_t wish, value;
  };
  double& at(const Place& place) { return wishes_[place.wish].values[place.value]; }
  SpeedCurve curve(std::size_t w) const;
  Rows residuals(std::size_t w) const;
  double cost(const std::vector<Rows>& rows) const;
  std::vector<Rows> all() const;
  void normalEquations(const std::vector<Rows>& rows);
  bool improve(std::vector<Rows>& rows, double& damping);
  void meetMeans();

  std::vector<SpeedWish>& wishes_;
  std::vector<SpeedValues> begins_;
  std::vector<Place> free_;
  std::vector<double> matrix_, gradient_;  // of the free values
};

SpeedCurve Fit::curve(std::size_t w) const {
  const SpeedWish& wish = wishes_[w];
  const auto before = wish.previous ? wishes_[*wish.previous].values.back() : wish.before;
  const auto after = wish.next ? wishes_[*wish.next].values.front() : wish.after;
  return SpeedCurve(wish.values, before, after);
}

Rows Fit::residuals(std::size_t w) const {
  const SpeedWish& wish = wishes_[w];
  const SpeedCurve speed = curve(w);
  Rows rows{};
  std::size_t r = 0;
  for (std::size_t i = 0; i < wish.shares.size(); ++i) {
    const double share = speed.progress(static_cast<double>(i + 1) / SpeedWish::kSteps);
    rows[r++] = wish.weight * (share - wish.shares[i]);
  }
  rows[r++] = wish.mean ? kMeanWeight * (speed.mean() / *wish.mean - 1.0) : 0.0;
  for (std::size_t j = 0; j < kSpeedValues; ++j) {
    rows[r++] = kNearWeight * (wish.values[j] - begins_[w][j]);
  }
  return rows;
}

std::vector<Rows> Fit::all() const {
  std::vector<Rows> rows;
  for (std::size_t w = 0; w < wishes_.size(); ++w) rows.push_back(residuals(w));
  return rows;
}

double Fit::cost(const std::vector<Rows>& rows) const {
  double sum = 0.0;
  for (const Rows& part : rows) {
    for (const double r : part) sum += r * r;
  }
  return sum;
}

void Fit::normalEquations(const std::vector<Rows>& rows) {
  const std::size_t n = free_.size();
  // Derivatives by each free value, of its own curve and of those that continue it.
  std::vector<std::vector<Rows>> by(n, std::vector<Rows>(wishes_.size(), Rows{}));
  for (std::size_t a = 0; a < n; ++a) {
    double& value = at(free_[a]);
    const double old = value;
    const double step = old < 50.0 ? kStep : -kStep;
    value = old + step;
    for (std::size_t w = 0; w < wishes_.size(); ++w) {
      const bool touched = w == free_[a].wish || wishes_[w].previous == free_[a].wish ||
                           wishes_[w].next == free_[a].wish;
      if (!touched) continue;
      const Rows moved = residuals(w);
      for (std::size_t r = 0; r < kRows; ++r) by[a][w][r] = (moved[r] - rows[w][r]) / step;
    }
    value = old;
  }
  matrix_.assign(n * n, 0.0);
  gradient_.assign(n, 0.0);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t w = 0; w < wishes_.size(); ++w) {
      for (std::size_t r = 0; r < kRows; ++r) gradient_[a] += by[a][w][r] * rows[w][r];
      for (std::size_t b = 0; b <= a; ++b) {
        double sum = 0.0;
        for (std::size_t r = 0; r < kRows; ++r) sum += by[a][w][r] * by[b][w][r];
        matrix_[a * n + b] += sum;
      }
    }
  }
}

// Solves (matrix + damping * diagonal) x = right for the values that are not held, by Cholesky;
// false where rounding made the matrix indefinite.
bool solve(std::vector<double> matrix, const std::vector<bool>& held, double damping,
           std::vector<double>& x) {
  const std::size_t n = x.size();
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (held[a] || held[b]) matrix[a * n + b] = 0.0;
    }
    double& own = matrix[a * n + a];
    own = held[a] ? 1.0 : own * (1.0 + damping) + 1e-14;
    if (held[a]) x[a] = 0.0;
  }
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      double sum = matrix[a * n + b];
      for (std::size_t k = 0; k < b; ++k) sum -= matrix[a * n + k] * matrix[b * n + k];
      if (a != b) {
        matrix[a * n + b] = sum / matrix[b * n + b];
      } else if (sum > 0.0) {
        matrix[a * n + a] = std::sqrt(sum);
      } else {
        return false;
      }
    }
  }
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t k = 0; k < a; ++k) x[a] -= matrix[a * n + k] * x[k];
    x[a] /= matrix[a * n + a];
  }
  for (std::size_t a = n; a-- > 0;) {
    for (std::size_t k = a + 1; k < n; ++k) x[a] -= matrix[k * n + a] * x[k];
    x[a] /= matrix[a * n + a];
  }
  return true;
}

// One round: a step that lowers the cost, more and more damped until one does.
bool Fit::improve(std::vector<Rows>& rows, double& damping) {
  normalEquations(rows);
  const std::size_t n = free_.size();
  std::vector<bool> held(n);
  for (std::size_t a = 0; a < n; ++a) {
    const double value = at(free_[a]);
    held[a] =
        (value <= kMinSpeed && gradient_[a] > 0.0) || (value >= kMaxSpeed && gradient_[a] < 0.0);
  }
  const double before = cost(rows);
  std::vector<SpeedValues> old;
  for (const SpeedWish& wish : wishes_) old.push_back(wish.values);
  for (; damping < 1e8; damping *= 8.0) {
    std::vector<double> x(n);
    for (std::size_t a = 0; a < n; ++a) x[a] = -gradient_[a];
    if (!solve(matrix_, held, damping, x)) continue;
    for (std::size_t a = 0; a < n; ++a) {
      at(free_[a]) = std::clamp(at(free_[a]) + x[a], kMinSpeed, kMaxSpeed);
    }
    std::vector<Rows> now = all();
    const double after = cost(now);
    if (after < before) {
      rows = std::move(now);
      damping = std::max(damping / 16.0, 1e-12);
      return before - after > 1e-9 * before;
    }
    for (std::size_t w = 0; w < wishes_.size(); ++w) wishes_[w].values = old[w];
  }
  return false;
}

// What least squares leave of a mean's error is taken out by moving the inner values alike: no
// other curve continues with them.
void Fit::meetMeans() {
  for (std::size_t w = 0; w < wishes_.size(); ++w) {
    SpeedWish& wish = wishes_[w];
    for (int round = 0; wish.mean && round < 8; ++round) {
      const double missing = *wish.mean - curve(w).mean();
      if (std::abs(missing) <= 1e-14 * *wish.mean) break;
      for (std::size_t j = 1; j < kLast; ++j) {
        wish.values[j] = std::clamp(wish.values[j] + missing * 9.0 / 8.0, kMinSpeed, kMaxSpeed);
      }
    }
  }
}

void Fit::run() {
  std::vector<Rows> rows = all();
  double damping = 1e-3;
  for (int round = 0; round < kMostRounds && improve(rows, damping); ++round) {
  }
  meetMeans();
}

}  // namespace

double shareError(const SpeedCurve& curve, const SpeedWish& wish) {
  double most = 0.0;
  for (std::size_t i = 0; i < wish.shares.size(); ++i) {
    const double share = curve.progress(static_cast<double>(i + 1) / SpeedWish::kSteps);
    most = std::max(most, std::abs(share - wish.shares[i]));
  }
  return most;
}

void fitSpeeds(std::vector<SpeedWish>& wishes) { Fit(wishes).run(); }

}  // namespace vides
