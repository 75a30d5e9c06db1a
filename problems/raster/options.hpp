/// @file How the raster of a problem of any kind is searched.
#pragma once

#include "problems/linkage/result.hpp"
#include "problems/raster/raster.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {

/// What file and run say of the search; `deadline` must outlive it. Limits, sizes and the search of
/// single combinations are the kind's.
inline synthesis::RasterOptions raster_options(const Solve& solve, const Raster& raster,
                                               const Run& run, const Deadline& deadline) {
  synthesis::RasterOptions options;
  options.designs = static_cast<std::size_t>(solve.designs);
  options.most_nodes = static_cast<std::uint64_t>(raster.boxes);
  options.threads = run.threads;
  options.deadline = &deadline;
  options.progress = run.progress;
  return options;
}

}  // namespace cognate::problems
