/// @file Where along the drive a load begins or ceases to act.
#pragma once

#include <vector>

#include "analysis/mechanism/course.hpp"
#include "problems/analysis/active_loads.hpp"

namespace cognate::problems {

/// The angles of the drive over `course`, of a crank or a floating link, at which a load with
/// `rule` may begin or cease to act whichever way the drive turns: the ends of `between`, where the
/// body that bears it turns back, and where that enters or leaves the part of its stroke. Not
/// ordered.
std::vector<double> load_breaks(const Mechanism<double>& mechanism, const Course& course,
                                const LoadRule& rule, const Stroke& stroke);

}  // namespace cognate::problems
