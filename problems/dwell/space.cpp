#include "problems/dwell/space.hpp"

#include <algorithm>

namespace cognate::problems {
namespace {

/// Of the swing: what a search may miss its limit by.
constexpr double kMargin = 3e-7;

double unit_of(const OutputSpace& space) {
  return space.slides() ? space.scale.size : 1;
}

/// On a raster the size counts, and the direction of the frame where pivots are on it; crank angles
/// that are given count from the x axis.
OutputFrame frame_of(const DwellProblem& of) {
  const bool pivots_on_raster = of.raster && of.raster->rule("pivots") != nullptr;
  const bool turns =
      std::ranges::any_of(of.dwells, [](const Dwell& one) { return bool(one.from); });
  if (slides(of)) return {true, turns || pivots_on_raster, of.swing_min};
  return {of.raster.has_value(), turns || pivots_on_raster};
}

}  // namespace

DwellSpace::DwellSpace(const DwellProblem& of, const Topology& given)
    : OutputSpace(given, of.output, of.constraints.transmission_angle, frame_of(of)),
      swing_min(of.swing_min / unit_of(*this) + kMargin),
      apart(of.apart),
      problem(&of) {
  if (apart) *apart /= unit_of(*this);
}

}  // namespace cognate::problems
