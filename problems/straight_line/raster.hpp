/// @file Straight lines by linkages whose dimensions lie on a raster.
#pragma once

#include <functional>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/raster/report.hpp"
#include "problems/straight_line/problem.hpp"
#include "problems/straight_line/search.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {

/// Linkages on the raster with their segments, in the file's unit, best first; their dimensions are
/// exactly those of the raster.
struct SegmentRasterResult {
  std::vector<SegmentDesign> designs;
  synthesis::RasterResult search;
};

/// Whether a segment in the file's unit meets every constraint of the file. Called from many
/// threads at once.
using SegmentAcceptance = std::function<bool(const SegmentDesign& design)>;

/// The links that `problem` (in the file's unit) leaves to its raster lie within these: its own
/// bounds, and what the segment's length and `size_limit` allow.
Bounds raster_bounds(const StraightLineProblem& problem);

/// Searches the raster of `problem` from minima of the same problem without one: `scaled`, its
/// lengths divided by `unit`, as the search has them. Where dimensions are free beside the raster,
/// the best combinations are searched as problems of their own too. Counts that in `work`.
SegmentRasterResult search_segment_raster(const StraightLineProblem& problem,
                                          const StraightLineProblem& scaled, double unit,
                                          const std::vector<SegmentDesign>& minima,
                                          const SegmentAcceptance& accepts, const Run& run,
                                          const Deadline& deadline, Work& work);

/// What is best by the goal, as results name it: the deviation at a length, the length, or the size
/// over the length.
RasterMeasure segment_measure(const StraightLineProblem& problem, double unit);

}  // namespace cognate::problems
