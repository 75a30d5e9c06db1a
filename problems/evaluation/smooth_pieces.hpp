/// @file The pieces of a motion over which the forces of an analysis are smooth.
#pragma once

#include <span>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "problems/evaluation/problem.hpp"

namespace cognate::problems {

/// What bounds a piece: nothing in the mechanism's way; a dead point or parallel guides, where a
/// range of the drive ends and rates by the drive may grow without bound; a change point, where the
/// reactions of the dyad in line may.
enum class PieceEnd { smooth, dead, change };

/// A piece of the drive's path, from < to, in which the same loads act throughout. At its ends they
/// are what they are inside, so that values there are those from this side.
struct SmoothPiece {
  double from = 0, to = 0;
  PieceEnd at_from = PieceEnd::smooth, at_to = PieceEnd::smooth;
  std::vector<Load> loads;
};

/// Cuts `assembly_ranges` at every place where a load may begin or cease to act, at dead and change
/// points, and in quarters of a turn (of a driving slider's path). In the order of the drive's
/// coordinate.
std::vector<SmoothPiece> smooth_pieces(const AnalysisProblem& problem,
                                       const AssemblyRanges& assembly_ranges,
                                       std::span<const Stroke> strokes);

}  // namespace cognate::problems
