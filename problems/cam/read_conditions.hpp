/// @file What a polynomial or a spline of `[[motion]]` goes through.
#pragma once

#include "analysis/cam/motion_law.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// `conditions` of a polynomial over `over_deg`, whose rise is known; false with a fault where they
/// are wrong, or where no polynomial, or more than one, meets them.
bool read_conditions(TableReader& table, bool oscillating, double over_deg,
                     cam::MotionSegment& segment);

/// `points`, `degree`, `velocity`, `acceleration` and `periodic` of a spline, in the same way.
bool read_spline(TableReader& table, bool oscillating, double over_deg,
                 cam::MotionSegment& segment);

}  // namespace cognate::problems::reading
