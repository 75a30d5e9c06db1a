/// @file A closed curve as the target of a path problem.
#pragma once

#include <string>

#include "problems/path/curve/closed_curve.hpp"

namespace cognate::problems {

/// `target.place`: the curve stays where it is, or may be moved, turned and enlarged.
enum class CurvePlace { given, similar };

struct TargetCurve {
  ClosedCurve curve;
  std::string svg_path;  ///< the path data it was read from, y down; empty where it was a polyline
  CurvePlace place = CurvePlace::given;
};

}  // namespace cognate::problems
