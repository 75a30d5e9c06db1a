/// @file Cusps, inflections and double points of coupler curves, where a motion meets them.
#pragma once

#include <vector>

#include "analysis/mechanism/course.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/linkage/deadline.hpp"

namespace cognate::problems {

/// Landmarks of the reported points on the coupler of a four-bar: "cusp", "inflection", and "double
/// point" for each of its two passages, each naming the other; those that the motion along `course`
/// really comes to, in its assemblies. Nothing where curvature is not asked for, and for other
/// mechanisms. Points that are not reached before `deadline` have none.
std::vector<Landmark> curve_landmarks(const AnalysisProblem& problem, const Course& course,
                                      const Deadline& deadline);

}  // namespace cognate::problems
