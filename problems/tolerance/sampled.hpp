/// @file Figures of mechanisms whose dimensions are drawn at random.
#pragma once

#include "problems/tolerance/dimensions.hpp"
#include "problems/tolerance/figures.hpp"

namespace cognate::problems {

/// Sets mean, standard deviation, quantiles, histogram and yield; where there are no figures of
/// first order, how many samples can be assembled alone.
void add_samples(const TolerancedMechanism& toleranced, const Tolerances& tolerances,
                 const ToleranceQuestion& question, const ToleranceRun& run,
                 ToleranceResult& result);

}  // namespace cognate::problems
