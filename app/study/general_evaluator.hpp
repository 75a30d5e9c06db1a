/// @file The designs of any study, one by one.
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

}  // namespace cognate::app
