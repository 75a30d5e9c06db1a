/// @file One table of `[[motion]]`.
#pragma once

#include <optional>
#include <vector>

#include "problems/cam/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// A segment as its table gives it, with what the sums over all segments need, in the file's units.
struct CamSegment {
  cam::MotionSegment segment;
  Range over_deg;                                ///< equal ends where the angle is given
  double rise = 0;                               ///< length, or degrees of an oscillating follower
  std::vector<FreeMotionParameter> free_shares;  ///< of the universal law; `segment` is not set

  bool is_free() const { return over_deg.min < over_deg.max; }
};

/// Reads `table`; what is wrong is faulted. Nothing where its angle, its law or its rise is wrong.
std::optional<CamSegment> read_cam_segment(TableReader& table, bool oscillating);

}  // namespace cognate::problems::reading
