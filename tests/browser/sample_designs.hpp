/// @file Results of exact synthesis made by hand, for the pages of the browser tests.
#pragma once

#include <string>
#include <vector>

#include "problems/kinds.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

struct SampleResult {
  std::string name;
  Task problem;
  Result result;
};

/// A body guided through four poses by mechanisms of several types, with curves; a quick-return
/// family; a straight line; two hundred designs through nine points.
std::vector<SampleResult> sample_designs();

}  // namespace cognate::problems
