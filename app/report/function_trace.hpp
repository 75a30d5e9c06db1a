/// @file The structural error of a function generator, sampled for drawing.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "problems/chain_function/problem.hpp"
#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::app {

/// One entry in each array for each position; angles in radians.
struct FunctionTrace {
  std::vector<double> x;      ///< the function's argument; empty for angle pairs
  std::vector<double> crank;  ///< from the x axis, continuous
  std::vector<double> error;  ///< output generated less wanted; angles in [−π, π]
};

/// The structural error over the whole domain in equal steps, or at the angle pairs, by `error_at`,
/// which is empty where the mechanism does not close: such positions are left out. `start`: the
/// crank's angle at the start, from the x axis.
FunctionTrace function_trace(
    const problems::FunctionOfX* function, const problems::FunctionSamples& wanted, double start,
    const std::function<std::optional<double>(const synthesis::AnglePair&)>& error_at);

/// The structural error of `design` over the whole domain in equal steps, or at the angle pairs.
/// Positions in which the linkage does not close are left out; empty arrays where the design has no
/// start angles.
FunctionTrace function_trace(const problems::FunctionProblem& problem,
                             const problems::FunctionSamples& wanted,
                             const problems::Design& design);

/// The same of a longer chain than a four-bar.
FunctionTrace function_trace(const problems::ChainFunctionProblem& problem,
                             const problems::Design& design);

/// The trace as pages read it: `x`, null for angle pairs, `crank_deg` and `error_deg`; `error`
/// where the output slides.
nlohmann::ordered_json trace_json(const FunctionTrace& trace, bool slides = false);

}  // namespace cognate::app
