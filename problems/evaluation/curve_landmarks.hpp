/// @file Cusps, inflections and double points of coupler curves, where a motion meets them.
#pragma once

#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/linkage/deadline.hpp"

namespace cognate::problems {

/// Landmarks of the reported points on the coupler of a four-bar: "cusp", "inflection", and "double
/// point" for each of its two passages, each naming the other; those that the motion along
/// `assembly_ranges` really comes to, in its assemblies. Nothing where curvature is not requested,
/// and for other mechanisms. Points that are not reached before `deadline` have none.
std::vector<Landmark> curve_landmarks(const AnalysisProblem& problem,
                                      const AssemblyRanges& assembly_ranges,
                                      const Deadline& deadline);

}  // namespace cognate::problems
