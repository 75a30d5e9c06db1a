/// @file What a study may ask of the designs of its base file.
#pragma once

#include <string>
#include <vector>

namespace cognate::problems {

/// A metric by its name in a study; its values are words ("crank-rocker", "true") or numbers.
struct MetricName {
  std::string name;
  bool word = false;
};

struct MetricNames {
  std::vector<MetricName> names;
  /// What is followed by names or indices known only of a design, "mechanism.dyad": every
  /// "mechanism.dyad[0].lengths[1]" may be requested, and may be a word or a number.
  std::vector<std::string> openings;
};

}  // namespace cognate::problems
