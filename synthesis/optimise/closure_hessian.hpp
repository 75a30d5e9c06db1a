/// @file Second derivatives of the angles of coupler and rocker of a four-bar.
#pragma once

#include <array>

#include "analysis/linkage/closure.hpp"

namespace cognate::synthesis {

/// By crank, coupler, rocker, frame and crank angle, in this order; symmetric.
using AngleHessian = std::array<std::array<double, 5>, 5>;

struct ClosureHessian {
  AngleHessian coupler, rocker;
};

/// The derivatives of `closure_gradient`, by dual numbers: exact to rounding, not finite at dead
/// points. `crank` is the crank's unit vector, `at` what the closure gives for it.
ClosureHessian closure_hessian(const Lengths<double>& links, const Vec2d& crank,
                               const LinkDirections<double>& at);

}  // namespace cognate::synthesis
