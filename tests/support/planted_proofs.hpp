/// @file Timed paths with a design whose error is known, and boxes of proportions that hold it:
/// what a proof must never discard.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "tests/support/box_linkages.hpp"

namespace cognate::test {

struct PlantedProof {
  synthesis::TimedPath path;
  synthesis::Proportions proportions = synthesis::Proportions::crank_shortest;
  int assembly = 1;
  BoxPoint at{};
  double error = 0;  ///< of the design at `at`
};

inline synthesis::ProportionLimits no_limits() {
  synthesis::ProportionLimits limits;
  limits.greatest_ratio = std::numeric_limits<double>::infinity();
  limits.transmission_max = kPi;
  return limits;
}

/// Between which values the sides of boxes lie.
inline std::pair<BoxPoint, BoxPoint> side_limits(synthesis::Proportions proportions) {
  const bool crank = proportions == synthesis::Proportions::crank_shortest;
  return {{crank ? 0.5 : 0.003, 0, 0, 0}, {crank ? 0.997 : 0.5, kPi, kRightAngle, kTurn}};
}

/// A path of 4 to 18 samples near a random design's, or anywhere. A fifth of the designs lie at a
/// change point. Empty where the design has no finite links.
inline std::optional<PlantedProof> planted_proof(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  PlantedProof planted;
  if (uniform(0, 1) < 0.4) planted.proportions = synthesis::Proportions::frame_shortest;
  planted.assembly = uniform(0, 1) < 0.5 ? 1 : -1;
  const auto [low, high] = side_limits(planted.proportions);
  for (int i = 0; i < synthesis::kBoxSides; ++i) planted.at[i] = uniform(low[i], high[i]);
  if (uniform(0, 1) < 0.4) {  // short cranks or frames
    const double k = std::pow(10.0, uniform(-2.5, -0.4));
    planted.at[0] = planted.proportions == synthesis::Proportions::crank_shortest ? 1 - k : k;
  }
  if (uniform(0, 1) < 0.2) {
    const double where = uniform(0, 3);
    if (where < 1) planted.at[1] = 0;
    if (where >= 1 && where < 2) planted.at[1] = kPi;
    if (where >= 2) planted.at[2] = 0;
  }
  synthesis::ProportionBox box;
  box.proportions = planted.proportions;
  const auto links = links_at(box, planted.at);
  if (!links) return std::nullopt;
  synthesis::TimedPath& path = planted.path;
  const int count = 4 + int(uniform(0, 15));
  const double blur = std::pow(10.0, uniform(-4, 0.5));
  const Complex s = std::polar(uniform(0.2, 2), uniform(0, kTurn));
  const Complex q = std::polar(uniform(0.2, 2), uniform(0, kTurn));
  const double first = uniform(0, 1) < 0.3 ? -planted.at[3] : uniform(-kPi, kPi);
  const bool even = uniform(0, 1) < 0.5;
  path.pivot_fixed = uniform(0, 1) < 0.3;
  std::vector<Complex> u;
  for (int j = 0; j < count; ++j) {
    const double angle = even ? first + kTurn * j / count : j == 0 ? first : uniform(-kPi, kPi);
    path.crank_angles.push_back(std::remainder(angle, kTurn));
    const auto direction = directions_at(*links, planted.assembly,
                                         Quad(path.crank_angles.back()) + Quad(planted.at[3]));
    if (!direction) return std::nullopt;
    u.push_back(direction->coupler);
    path.points.push_back(s * std::polar(1.0, angle) + q * u.back() +
                          blur * Complex(uniform(-1, 1), uniform(-1, 1)));
    path.weights.push_back(uniform(0, 1) < 0.3 ? uniform(0.1, 3) : 1.0);
  }
  path.lengths.greatest.fill(std::numeric_limits<double>::infinity());
  path.farthest_point = std::numeric_limits<double>::infinity();
  Fit fit = best_fit(path, u, std::nullopt);
  // A limit that the design just satisfies.
  if (uniform(0, 1) < 0.4) path.farthest_point = std::abs(fit.q) * (1 + 1e-9);
  planted.error = error_of(path, u, fit);
  return planted;
}

/// A box of widths from 1e-9 to 0.5 that holds the point, often at its edge.
inline synthesis::ProportionBox box_with(const BoxPoint& at, int assembly,
                                         synthesis::Proportions proportions,
                                         std::mt19937_64& random) {
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const auto [low, high] = side_limits(proportions);
  synthesis::ProportionBox box;
  box.proportions = proportions;
  box.assembly = assembly;
  const double scale = std::pow(10.0, uniform(0, 1) < 0.1 ? uniform(-9, -4) : uniform(-4, -0.3));
  for (int i = 0; i < synthesis::kBoxSides; ++i) {
    const double width = scale * std::pow(10.0, uniform(-1, 0));
    const double below = uniform(0, 1) < 0.2 ? 0 : uniform(0, 1) < 0.2 ? width : uniform(0, width);
    box.side[i] = {std::max(low[i], at[i] - below), std::min(high[i], at[i] + width - below)};
    box.side[i].low = std::min(box.side[i].low, at[i]);
    box.side[i].high = std::max(box.side[i].high, at[i]);
  }
  return box;
}

}  // namespace cognate::test
