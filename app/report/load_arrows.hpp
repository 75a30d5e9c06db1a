/// @file Loads, weights and the drive's effort as the page of an analysis draws them.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "problems/evaluation/result.hpp"

namespace cognate::app {

/// A list of what acts on the bodies from outside; empty unless `problem` requests torque or
/// reactions. Each entry has `kind`, `body` (its number) and `at` (the place in the body's axes).
/// - "load": `force` [x, y] (N, global axes), `torque` (N·m, counter-clockwise) and `acts`, for
/// each
///   of `rows` whether it acts there (null: in all rows). It does not where the mechanism cannot be
///   assembled.
/// - "weight": the same, at the centre of mass, of what has a mass in a field of gravity.
/// - "drive": `column`, the index of the driving torque or force among the columns of `result`, and
///   `direction`, the unit vector in global axes along which a force acts (null: it is a torque).
/// `rows` are those of the table that are drawn.
nlohmann::ordered_json load_arrows(const problems::AnalysisProblem& problem,
                                   const problems::AnalysisResult& result,
                                   std::span<const std::size_t> rows);

}  // namespace cognate::app
