/// @file Random six-bars, and what is wrong with the layers that they are given.
#pragma once

#include <random>
#include <string>

#include "problems/layers/layers.hpp"
#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::test {

struct LayerCase {
  problems::NamedMechanism mechanism;
  problems::LayerSizes sizes;
  double from = 0, to = 0;  ///< of the one range in which it can be assembled
};

/// A Watt or Stephenson six-bar with plates of random widths, driven by its crank over the one
/// range in which it can be assembled.
LayerCase random_six_bar(std::mt19937& random);

/// How the layers of cases came out.
struct LayerCounts {
  int assigned = 0, impossible = 0, unresolved = 0;
  double greatest_interference = -1;  ///< of all assignments, by samples
};

/// What brute force at `samples` positions says against the layers of `given`; empty where nothing.
/// `enumerate`: whether it tries all assignments as well.
std::string fault_of_layers(const LayerCase& given, int samples, bool enumerate,
                            LayerCounts& counts);

}  // namespace cognate::test
