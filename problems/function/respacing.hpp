/// @file Exact function generators whose precision points are spaced anew.
#pragma once

#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Takes each four-bar of `result`, through Chebyshev's points, to level peaks of its structural
/// error (see synthesis/exact/respacing.hpp) and puts the designs in order of their greatest error.
/// Those whose peaks cannot be levelled stay as good as they were, or better; `notes` tell of them.
void level_peaks(const FunctionProblem& problem, const FunctionSamples& wanted, Result& result);

}  // namespace cognate::problems
