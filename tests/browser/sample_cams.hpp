/// @file Cams for the tests of their report page, with what solving them would give.
#pragma once

#include <string>
#include <vector>

#include "problems/cam/result.hpp"

namespace cognate::problems {

struct SampleCam {
  std::string name;
  CamProblem problem;
  CamResult result;
};

/// A cam of each type of follower and closure. The first is the example of the specification: base
/// radius 40, offset 15, roller 10, rise 60 over 100° by constant acceleration, return over 90° by
/// harmonic motion.
std::vector<SampleCam> sample_cams();

}  // namespace cognate::problems
