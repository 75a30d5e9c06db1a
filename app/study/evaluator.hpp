/// @file How the designs of a study are evaluated.
#pragma once

#include <atomic>
#include <cstdint>

#include "problems/study/block.hpp"
#include "problems/study/study.hpp"

namespace cognate::app {

/// Solves or analyses the base file of `study` with each design's numbers, on one thread and with
/// the same seed for all, and takes the metrics from the best design. What the numbers alone decide
/// is decided first. `study` and `interrupted` outlive it.
problems::BlockEvaluator general_evaluator(const problems::Study& study, std::uint64_t seed,
                                           const std::atomic<bool>* interrupted);

/// A new evaluator, for one thread: the one for four-bars in batches where it can give all that the
/// study wants, else one that solves or analyses the base file with each design's numbers. `study`
/// and `interrupted` outlive it.
problems::BlockEvaluator study_evaluator(const problems::Study& study, std::uint64_t seed,
                                         const std::atomic<bool>* interrupted);

/// How many designs make a block of this study: what is handed to a thread and stored at once.
std::int64_t block_size(const problems::Study& study);

}  // namespace cognate::app
