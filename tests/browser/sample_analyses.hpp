// Mechanisms whose analysis the browser tests look at.
#pragma once

#include <string>
#include <vector>

#include "problems/evaluation/result.hpp"

struct SampleAnalysis {
  std::string name;
  cognate::problems::AnalysisProblem problem;
};

/// Four-bar with a coupler point, slider-crank, guide-bar, Scotch yoke, elliptic trammel, tangent
/// generator, Oldham coupling, a four-bar that closes over part of the turn only, one driven by its
/// slider, a shaper with forces, and a chain of a hundred links.
std::vector<SampleAnalysis> sample_analyses();
