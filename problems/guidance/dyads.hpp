/// @file Dyads near many poses from which a search begins.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// A dyad and its error in guiding the body: see `synthesis::squared_misfit`.
struct DyadCandidate {
  synthesis::GuidingDyad dyad;
  double misfit = 0;
};

/// Whether the file gives or bounds the two dyads alike, so that either may take either role.
bool roles_are_alike(const MotionProblem& problem);

/// `dyad` (a link) with what the file gives for its role, its pivots within their bounds, and the
/// length that suits these best.
DyadCandidate conformed(const MotionProblem& problem, DyadRole role,
                        const synthesis::GuidingDyad& dyad);

/// Links drawn from a space-filling sequence over the body (or, where its moving pivot is given,
/// over the frame), each with the partner that the nearest circle gives. The sequence is shifted by
/// `seed`.
std::vector<DyadCandidate> drawn_links(const MotionProblem& scaled, DyadRole role, int count,
                                       std::uint64_t seed);

/// The different links of locally least misfit that `starts` lead to, best first. Where the file
/// gives a pivot, the starts themselves.
std::vector<DyadCandidate> nearest_links(const MotionProblem& scaled, DyadRole role,
                                         const std::vector<DyadCandidate>& starts,
                                         const Deadline& deadline);

/// Sliders and blocks that the file allows as second dyads: the nearest of each kind and the best
/// ones along some other directions.
std::vector<DyadCandidate> nearest_slides(const MotionProblem& scaled);

}  // namespace cognate::problems
