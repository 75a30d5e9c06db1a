/// @file Figures of mechanisms whose dimensions are drawn at random.
#pragma once

#include "problems/tolerance/dimensions.hpp"
#include "problems/tolerance/figures.hpp"

namespace cognate::problems {

/// Notes that the samples are too few for a quantile, and what share of them cannot be assembled.
void note_samples(ToleranceResult& result);

/// Sets quantiles, mean and histogram by the greatest error of each sample that can be assembled;
/// of a transmission angle by its difference from a right angle. Of all `samples` the others count
/// as worse than any: a quantile that falls among them is not a number.
void set_extremes_of_samples(ResponseType type, std::vector<double> extremes, std::size_t samples,
                             ToleranceFigures& figures);

/// Sets yield and its standard error by the greatest errors of the samples, in radians or a length.
void set_yield(const Tolerances& tolerances, bool angle, const std::vector<double>& extremes,
               ToleranceResult& result);

/// Sets mean, standard deviation, quantiles, histogram and yield; where there are no figures of
/// first order, how many samples can be assembled alone.
void add_samples(const TolerancedMechanism& toleranced, const Tolerances& tolerances,
                 const ToleranceQuestion& question, const ToleranceRun& run,
                 ToleranceResult& result);

}  // namespace cognate::problems
