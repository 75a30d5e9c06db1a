#include "problems/straight_line/peaks.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "analysis/numbers/zeros.hpp"
#include "problems/straight_line/motion.hpp"
#include "problems/straight_line/search.hpp"

namespace cognate::problems {
namespace {

/// Adds the places between nodes where `value` is greater by `more` than at any node.
template <class Value>
void add_peaks(const Value& value, const std::vector<double>& nodes, double more,
               std::vector<double>& peaks) {
  double most = value(nodes.front());
  for (const double node : nodes) most = std::max(most, value(node));
  constexpr int kCells = 400;
  const std::vector<double> places = crowded(-1, 1, kCells);
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const double here = value(places[i]);
    if (here < value(places[i - 1]) || here <= value(places[i + 1])) continue;
    const auto depth = [&](double place) { return -value(place); };
    constexpr int kSteps = 40;
    const double peak = golden_section(depth, places[i - 1], places[i + 1], kSteps).middle();
    if (value(peak) > most + more + kSegmentFeasibility * std::abs(most)) peaks.push_back(peak);
  }
}

}  // namespace

std::vector<double> peaks_beyond(const LinkageSegment& segment, const std::vector<double>& nodes,
                                 const std::optional<double>& variation) {
  const CouplerMotion<double> motion(segment.type, segment.dimensions, sign(segment.assembly));
  const Vec2d along = unit_vector(segment.line);
  const auto at = [&](double node) { return motion.at(segment.centre + node * segment.reach); };
  const auto height = [&](double node) {
    const auto point = at(node);
    return point.closes ? std::abs(cross(along, point.at) - segment.height) : 0.0;
  };
  std::vector<double> peaks;
  add_peaks(height, nodes, 0, peaks);
  if (!variation) return peaks;
  constexpr double kLittle = 3e-4;
  const double unit = 2 * segment.reach / segment.length;
  for (const double sense : {1.0, -1.0}) {
    const auto speed = [&](double node) {
      const auto point = at(node);
      return point.closes ? sense * unit * dot(along, point.rate) : sense;
    };
    add_peaks(speed, nodes, kLittle * *variation, peaks);
  }
  return peaks;
}

}  // namespace cognate::problems
