/// @file Quick returns whose lengths lie on a raster.
#pragma once

#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/quick_return/problem.hpp"
#include "problems/quick_return/return_raster.hpp"
#include "synthesis/raster/bounded_raster.hpp"

namespace cognate::problems {

/// The best quick returns on a raster, best first.
struct ReturnRasterAnswer {
  std::vector<Design> designs;
  ReturnLengths best{};  ///< of the first, if there is one
  synthesis::BoundedRasterResult search;
};
ReturnRasterAnswer search_return_raster(const QuickReturnProblem& problem, const Run& run,
                                        const Deadline& deadline);

/// `problem` without its raster, with as many lengths of `best` as leave what it desires to be met:
/// of a four-bar the rocker, of a guide-bar the frame, of a shaper all but crank and bar.
QuickReturnProblem exact_problem(const QuickReturnProblem& problem, const ReturnLengths& best);

/// Designs, facts and sentences of `answer`; `exact`: the designs without a raster, best first.
void tell_return_raster(const QuickReturnProblem& problem, const ReturnRasterAnswer& answer,
                        const std::vector<Design>& exact, Result& result);

}  // namespace cognate::problems
