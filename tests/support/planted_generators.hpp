/// @file Function generators drawn at random, and what they do by the textbook's triangles: answers
/// from which problems of exact synthesis are made.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/function/precision_point.hpp"
#include "tests/support/taylor.hpp"

namespace cognate::test {

using Random = std::mt19937_64;

inline double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// cos and sin of angle + t as series in t.
inline std::array<Taylor, 2> turning(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {Taylor{c, -s, -c / 2, s / 6}, Taylor{s, c, -s / 2, -c / 6}};
}

/// A four-bar with crank 1 and where it starts; `side` ±1 is its assembly.
struct PlantedFourBar {
  double coupler = 0, rocker = 0, frame = 0, side = 1;
  double input_start = 0, output_start = 0;
};

/// A slider-crank and where it starts; `side` +1: the pin is ahead of the crank pin.
struct PlantedSliderCrank {
  double crank = 0, coupler = 0, offset = 0, side = 1;
  double input_start = 0, output_start = 0;
};

/// The output and its first three derivatives by the input; empty where the linkage does not close
/// or barely does.
inline std::optional<std::array<double, 5>> output(const PlantedFourBar& planted, double input) {
  const auto [bx, by] = turning(planted.input_start + input);
  const Taylor one(1), two(2), dx = Taylor(planted.frame) - bx, dy = -by;
  const Taylor square = dx * dx + dy * dy;
  const double l = planted.coupler, m = planted.rocker;
  const Taylor along = (Taylor(l * l - m * m) + square) / (two * square);
  const Taylor height = Taylor(l * l) / square - along * along;
  if (!(height.c[0] > 1e-3)) return std::nullopt;
  const Taylor across = Taylor(planted.side) * sqrt(height);
  const Taylor x = (bx + along * dx - across * dy - Taylor(planted.frame)) / Taylor(m);
  const Taylor y = (by + along * dy + across * dx) / Taylor(m);
  // The angle of (x, y): its rate is x y′ − y x′.
  const auto rate = [](const Taylor& a) { return Taylor{a.c[1], 2 * a.c[2], 3 * a.c[3], 0}; };
  const Taylor turn = x * rate(y) - y * rate(x);
  const double angle = std::atan2(y.c[0], x.c[0]) - planted.output_start;
  return std::array{std::remainder(angle, kTurn), turn.c[0], turn.c[1], 2 * turn.c[2], 0.0};
}

inline std::optional<std::array<double, 5>> output(const PlantedSliderCrank& planted,
                                                   double input) {
  const auto [c, s] = turning(planted.input_start + input);
  const Taylor r(planted.crank), across = r * s - Taylor(planted.offset);
  const Taylor square = Taylor(planted.coupler * planted.coupler) - across * across;
  if (!(square.c[0] > 1e-3 * planted.coupler * planted.coupler)) return std::nullopt;
  const Taylor along = r * c + Taylor(planted.side) * sqrt(square);
  return std::array{along.c[0] - planted.output_start, along.derivative(1), along.derivative(2),
                    along.derivative(3), 0.0};
}

inline PlantedFourBar random_four_bar(Random& random) {
  const auto length = [&] { return std::exp(between(random, -1, 1.2)); };
  return {length(),
          length(),
          length(),
          random() % 2 == 0 ? 1.0 : -1.0,
          between(random, -3, 3),
          between(random, -3, 3)};
}

inline PlantedSliderCrank random_slider_crank(Random& random) {
  const double unit = std::exp(between(random, -5, 5));
  const double crank = unit, coupler = unit * std::exp(between(random, -0.7, 1.5));
  return {crank,
          coupler,
          unit * between(random, -0.9, 0.9),
          random() % 2 == 0 ? 1.0 : -1.0,
          between(random, -3, 3),
          unit * between(random, -2, 2)};
}

/// Points of `planted` with the given multiplicities (at most 4 each) at inputs in even steps of
/// about `step`; empty where it does not close at all of them.
template <class Planted>
std::vector<synthesis::PrecisionPoint> planted_points(const Planted& planted,
                                                      const std::vector<int>& multiplicities,
                                                      double step, Random& random) {
  std::vector<synthesis::PrecisionPoint> points;
  double input = between(random, 0, 1);
  for (const int multiplicity : multiplicities) {
    const auto values = output(planted, input);
    if (!values) return {};
    points.push_back({input, *values, static_cast<std::size_t>(multiplicity)});
    input += step * between(random, 0.7, 1.3);
  }
  return points;
}

}  // namespace cognate::test
