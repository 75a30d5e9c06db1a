/// @file Studies of four-bars, thousands of designs at a time.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "problems/study/block.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems {

/// The evaluator of a study whose base analyses a four-bar over a turn of its crank at least, whose
/// varied keys are dimensions of it, and whose metrics and filters are among the quantities of an
/// analysis that follow from the dimensions (`four_bar_quantity`); empty for any other study.
///
/// Designs go through the filters in stages, the cheapest first: varied keys, lengths of links,
/// closed forms, and of the curve the sums over its samples, widths, descriptors, straight
/// stretches, features. What fails goes no further; what neither a filter nor a column names is not
/// computed. Values are those of `analyse` but for roundings. `study` and `interrupted` outlive it.
std::optional<BlockEvaluator> four_bar_evaluator(const Study& study, std::uint64_t seed,
                                                 const std::atomic<bool>* interrupted);

}  // namespace cognate::problems
