/// @file The accuracy of dyads in chains, near their dead points, against 237 bits.
#pragma once

#include <functional>
#include <random>
#include <string_view>
#include <vector>

#include "analysis/mechanism/mechanism.hpp"
#include "tests/stress/accuracy.hpp"

namespace cognate::stress {

/// A chain on a crank, and the crank's direction, of length one within rounding.
struct ChainPosition {
  Mechanism<double> mechanism;
  Vec2d crank{1, 0};
};

/// Chains whose last dyad is near its dead point: by the relative amount `distance`.
struct ChainFamily {
  std::string_view name;
  std::string_view distance_is;
  std::function<ChainPosition(double distance, std::mt19937_64&)> draw;
};

/// RRR on the crank and on another link, RRP, RPR, PRP, RPP.
std::vector<ChainFamily> chain_families();

/// Of the bodies of the last dyad: directions and origins, and angular velocities by the crank's,
/// relative to 1 + themselves. Conditions are sums over all numbers of the mechanism and the
/// crank's direction, from differences in 237 bits.
struct ChainAccuracy {
  Accuracy positions;
  Accuracy velocities;

  void include(const ChainPosition& at);
  void include(const ChainAccuracy& other);
};

}  // namespace cognate::stress
