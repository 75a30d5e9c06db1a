/// @file Four-bars with tolerances, at random, and their extremes by a dense search in 113 bits.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/tolerance/affine_mechanism.hpp"
#include "analysis/tolerance/response.hpp"
#include "synthesis/bounds/interval.hpp"
#include "tests/support/quad_four_bar.hpp"

namespace cognate::test {

/// Lengths from 1 to 4 with tolerances up to some per cent, at a crank angle at which the nominal
/// linkage is assembled.
class TolerancedFourBar {
 public:
  TolerancedFourBar(const QuadDimensions& dimensions, double angle, int side, double tolerance)
      : quad_(dimensions), angle_(angle), side_(side), tolerance_(tolerance) {
    make();
  }

  explicit TolerancedFourBar(std::mt19937_64& random) {
    std::uniform_real_distribution<double> length(1, 4), turn(-3.1, 3.1), exponent(-4, -1.5);
    do {
      for (std::size_t i = 0; i < 4; ++i) quad_[i] = length(random);
      angle_ = turn(random);
    } while (!closes());
    side_ = random() % 2 == 0 ? 1 : -1;
    tolerance_ = std::pow(10, exponent(random));
    make();
  }

  const AffineMechanism& mechanism() const { return mechanism_; }
  const Station& station() const { return station_; }
  const QuadDimensions& quad() const { return quad_; }
  double angle() const { return angle_; }
  int side() const { return side_; }
  double tolerance() const { return tolerance_; }
  std::vector<synthesis::Interval> box() const {
    return std::vector<synthesis::Interval>(4, {-tolerance_, tolerance_});
  }

 private:
  bool closes() const {
    const auto at = quad_position(quad_, angle_, 1);
    return std::isfinite(static_cast<double>(at.rocker)) &&
           std::isfinite(static_cast<double>(at.x));
  }

  FourBar linkage(int changed) const {
    const auto of = [&](int i) {
      return static_cast<double>(quad_[static_cast<std::size_t>(i)]) + (changed == i ? 1 : 0);
    };
    FourBar linkage;
    linkage.crank = of(0);
    linkage.coupler = of(1);
    linkage.rocker = of(2);
    linkage.pivot_d = {of(3), 0};
    linkage.assembly = side_ > 0 ? Assembly::open : Assembly::crossed;
    return linkage;
  }

  void make() {
    const MechanismWithPoints<double> nominal{as_mechanism(linkage(-1)), {}};
    const auto numbers = AffineMechanism::numbers(nominal);
    std::vector<std::vector<double>> slopes;
    for (int i = 0; i < 4; ++i) {
      const auto moved = AffineMechanism::numbers({as_mechanism(linkage(i)), {}});
      std::vector<double>& slope = slopes.emplace_back();
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        slope.push_back(std::round(moved[k] - numbers[k]));
      }
    }
    mechanism_ = AffineMechanism(nominal, slopes);
    station_ = {drive_position(nominal.mechanism, angle_), {static_cast<double>(side_)}};
  }

  QuadDimensions quad_{};
  double angle_ = 0;
  int side_ = 1;
  double tolerance_ = 0;
  AffineMechanism mechanism_;
  Station station_;
};

struct DenseExtremes {
  double low = 0, high = 0;
};

/// Of the rocker's angle over the box: all corners, points in every face and inside; empty where
/// one of them cannot be assembled.
inline std::optional<DenseExtremes> dense_extremes(const TolerancedFourBar& linkage,
                                                   std::mt19937_64& random, int points) {
  const Quad nominal = quad_position(linkage.quad(), linkage.angle(), linkage.side()).rocker;
  DenseExtremes found;
  bool open = false;
  const auto consider = [&](const QuadDimensions& at) {
    const Quad angle = quad_position(at, linkage.angle(), linkage.side()).rocker;
    open = open || !std::isfinite(static_cast<double>(angle));
    const double change =
        std::remainder(static_cast<double>(Quad(angle - nominal)), 2 * std::acos(-1.0));
    found.low = std::min(found.low, change);
    found.high = std::max(found.high, change);
  };
  each_corner(linkage.quad(), linkage.tolerance(), 4, consider);
  std::uniform_int_distribution<int> place(0, 8);
  for (int k = 0; k < points; ++k) {
    QuadDimensions at = linkage.quad();
    for (std::size_t i = 0; i < 4; ++i) {
      at[i] += linkage.tolerance() * (place(random) / 4.0 - 1);
    }
    consider(at);
  }
  return open ? std::nullopt : std::optional(found);
}

}  // namespace cognate::test
