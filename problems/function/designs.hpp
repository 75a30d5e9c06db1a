/// @file Function generators as designs: checked, without repetition, best first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/linkage/defects.hpp"
#include "problems/function/generator.hpp"
#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The design that `generator` is, with its error over `wanted` and everything that the analysis
/// kernel says of it, the transmission angle over the whole of `wanted.sweep`. `positions`: the
/// crank positions it is judged at, each with its own side.
Design function_design(const FunctionProblem& problem, const FunctionSamples& wanted,
                       const FunctionGenerator& generator,
                       const std::vector<CrankPosition>& positions, std::string origin);

/// Adds whether a start angle is the one that the file gives and within the bounds it sets, whole
/// turns aside: "mechanism.KEY" and "bounds.KEY".
void check_start_angle(std::vector<ConstraintCheck>& checks, const std::string& key, double angle,
                       const std::optional<double>& given, const std::optional<Range>& bounds);

/// The crank positions of `generator` at all of `pairs`, in its own assembly.
std::vector<CrankPosition> positions_of(const FunctionGenerator& generator,
                                        const std::vector<synthesis::AnglePair>& pairs);

/// The crank positions of `generator` at `points`, with the side on which its joint C stands where
/// crank and rocker have the angles wanted.
std::vector<CrankPosition> sides_at(const FunctionGenerator& generator,
                                    const std::vector<synthesis::PrecisionPoint>& points);

/// max |output error| at `pairs`, each on the side of its position, radians. Empty where the
/// linkage does not close at one of them.
std::optional<double> largest_error(FunctionGenerator generator,
                                    const std::vector<synthesis::AnglePair>& pairs,
                                    const std::vector<CrankPosition>& positions);

/// The at most `count` best of `designs`, equal ones merged: those that satisfy every constraint,
/// or if there are none the rest, by `objective`; sound ones without an objective in their order.
std::vector<Design> best_designs(std::vector<Design> designs,
                                 std::optional<FunctionObjective> objective, int count);

}  // namespace cognate::problems
