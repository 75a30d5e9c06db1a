#include "problems/chain/output/space.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

using synthesis::LineType;

/// Without a bound lengths and coordinates are at most so many units, links at least so many.
constexpr double kMostUnits = 8, kLeastUnits = 0.05;
/// Of a cosine: what a search may miss its limit by.
constexpr double kMargin = 3e-7;

bool is_pivot(const TopologyLine& line) {
  return line.line.type == LineType::pivot;
}

bool has_number(const TopologyLine& line) {
  return line.given[0] || line.given[1];
}

bool is_bound(const Range& range) {
  return std::isfinite(range.min) || std::isfinite(range.max);
}

/// Whether the file says where the pivot is, or is not.
bool is_placed(const TopologyLine& pivot) {
  const bool is_bounded = is_bound(pivot.bounds[0]) || is_bound(pivot.bounds[1]);
  return has_number(pivot) || is_bounded;
}

template <class Lines>
auto& crank_of(Lines& lines) {
  return *std::ranges::find(lines, LineType::crank,
                            [](const TopologyLine& line) { return line.line.type; });
}

/// The pivot of the crank.
TopologyLine& own_pivot(Topology& topology) {
  return topology.lines[static_cast<std::size_t>(crank_of(topology.lines).line.first)];
}

/// Whether nothing fixes the size of the mechanism.
bool has_any_size(const Topology& topology) {
  std::ptrdiff_t places = 0;
  for (const TopologyLine& line : topology.lines) {
    if (!is_pivot(line) && has_number(line)) return false;
    if (is_pivot(line) && is_placed(line)) ++places;
  }
  return places < 2;
}

/// The pivot about which the whole mechanism may be turned: the only one that the file places, else
/// that of the crank. What the file leaves open of its place is 0. Null where there is none, or
/// where its height is not known.
TopologyLine* turning_pivot(Topology& topology) {
  TopologyLine* placed = nullptr;
  for (TopologyLine& line : topology.lines) {
    if (!is_pivot(line) || !is_placed(line)) continue;
    if (placed != nullptr) return nullptr;
    placed = &line;
  }
  TopologyLine& still = placed != nullptr ? *placed : own_pivot(topology);
  for (std::size_t i = 0; i < 2; ++i) {
    if (!still.given.at(i) && !is_bound(still.bounds.at(i))) still.given.at(i) = 0.0;
  }
  return still.given[1] ? &still : nullptr;
}

/// The topology with what may be chosen without loss. Crank angles that are given count from the x
/// axis: the mechanism must be free to turn.
Topology framed(const Topology& from, const OutputFrame& frame) {
  Topology topology = from;
  TopologyLine& crank = crank_of(topology.lines);
  if (!frame.keeps_size && has_any_size(from)) {
    crank.given[0] = std::clamp(1.0, crank.bounds[0].min, crank.bounds[0].max);
  }
  const TopologyLine* still = turning_pivot(topology);
  if (frame.keeps_direction || still == nullptr) return topology;
  const auto is_guide = [](const TopologyLine& line) { return line.line.type == LineType::guide; };
  const auto guide = std::ranges::find_if(topology.lines, is_guide);
  if (guide != topology.lines.end()) {
    const bool is_directed = std::ranges::any_of(from.lines, [&](const TopologyLine& line) {
      return is_guide(line) && line.given[0].has_value();
    });
    if (!is_directed) guide->given[0] = 0.0;
    return topology;
  }
  const auto other = std::ranges::find_if(
      topology.lines, [&](const TopologyLine& line) { return is_pivot(line) && &line != still; });
  if (other != topology.lines.end()) other->given[1] = still->given[1];
  return topology;
}

/// Where the file has pivots, in the middle of their bounds where it bounds them; a pivot that is
/// level with another by choice is nowhere.
std::vector<Vec2d> placed_pivots(const Topology& topology) {
  std::vector<Vec2d> places;
  for (const TopologyLine& line : topology.lines) {
    if (!is_pivot(line)) continue;
    const auto is_known = [&](std::size_t i) {
      return line.given.at(i) || is_bound(line.bounds.at(i));
    };
    if (!is_known(0) || !is_known(1)) continue;
    const auto coordinate = [&](std::size_t i) {
      const auto& [least, greatest] = line.bounds.at(i);
      const double middle = 0.5 * (least + greatest);
      return line.given.at(i).value_or(std::isfinite(middle) ? middle : 0);
    };
    places.push_back({coordinate(0), coordinate(1)});
  }
  return places;
}

double greatest_distance(const std::vector<Vec2d>& places) {
  double greatest = 0;
  for (const Vec2d& a : places) {
    for (const Vec2d& b : places) greatest = std::max(greatest, norm(b - a));
  }
  return greatest;
}

/// Centre: the crank's pivot where it is known, else the middle of the others. Size: the crank,
/// else a third of the longest link, else of the greatest distance of pivots.
TargetScale scale_of(const Topology& framed, const OutputFrame& frame) {
  TargetScale scale;
  const TopologyLine& crank = crank_of(framed.lines);
  const auto& pivot = framed.lines[static_cast<std::size_t>(crank.line.first)].given;
  const std::vector<Vec2d> places = placed_pivots(framed);
  for (const Vec2d& place : places) {
    scale.centre = scale.centre + (1.0 / double(places.size())) * place;
  }
  if (pivot[0] && pivot[1]) scale.centre = {*pivot[0], *pivot[1]};
  double longest = 0;
  for (const TopologyLine& line : framed.lines) {
    if (!has_lengths(line.line.type)) continue;
    for (const auto& length : line.given) longest = std::max(longest, length.value_or(0) / 3);
  }
  if (longest == 0) longest = greatest_distance(places) / 3;
  if (longest > 0) scale.size = longest;
  const Range& bound = crank.bounds[0];
  if (longest == 0 && std::isfinite(bound.max)) scale.size = 0.5 * (bound.min + bound.max);
  if (crank.given[0]) scale.size = *crank.given[0];
  const bool is_known = crank.given[0] || longest > 0 || std::isfinite(bound.max);
  if (!is_known && frame.keeps_size) scale.size = frame.size;
  return scale;
}

int named_line(const Topology& topology, const std::string& name) {
  const auto found = std::ranges::find(topology.lines, name, &TopologyLine::name);
  return static_cast<int>(found - topology.lines.begin());
}

}  // namespace

OutputSpace::OutputSpace(const Topology& given, const std::array<std::string, 2>& output,
                         const Range& transmission, const OutputFrame& frame)
    : OutputSpace(given, output, transmission, framed(given, frame), frame) {}

OutputSpace::OutputSpace(const Topology& given, const std::array<std::string, 2>& output,
                         const Range& transmission, const Topology& framed,
                         const OutputFrame& frame)
    : ChainSpace(framed, scale_of(framed, frame), transmission),
      scale(scale_of(framed, frame)),
      from(named_line(given, output[0])),
      to(named_line(given, output[1])) {
  limit_open(kLeastUnits, kMostUnits);
  topology = &given;
  cosine_limit -= kMargin;
}

bool OutputSpace::slides() const {
  return lines[static_cast<std::size_t>(from)].line.type == LineType::guide;
}

double OutputSpace::most_level() const {
  constexpr double kMostDisplaced = 20;
  return slides() ? kMostDisplaced : kPi;
}

WantedOutput OutputSpace::wanted(double output) const {
  if (slides()) return {.displacement = output};
  return {.direction = unit_vector(output)};
}

WantedOutput OutputSpace::output(const FreeChain& chain) const {
  if (slides()) return {.displacement = chain.displacement(from, to)};
  return {.direction = chain.way(from, to)};
}

double OutputSpace::error(const FreeChain& chain, const WantedOutput& of) const {
  return slides() ? chain.displacement(from, to) - of.displacement
                  : relative_angle(chain.way(from, to), of.direction);
}

double OutputSpace::output_slope(FreeChain& chain, double* row) const {
  return slides() ? chain.displacement_slope(from, to, row) : chain.angle_slope(from, to, row);
}

double relative_angle(const Vec2d& way, const Vec2d& reference) {
  return std::atan2(cross(reference, way), dot(reference, way));
}

}  // namespace cognate::problems
