#include "problems/dwell/space.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::problems {
namespace {

using synthesis::LineType;

/// Without a bound lengths and coordinates are at most so many units, links at least so many.
constexpr double kMostUnits = 8, kLeastUnits = 0.05;
/// Of a link whose bound is 0, so that it has a direction.
constexpr double kLeastLink = 1e-4;
/// Of a cosine and of the swing: what a search may miss its limit by.
constexpr double kMargin = 3e-7;

bool is_of_length(const TopologyLine& line) {
  return line.line.type == LineType::crank || line.line.type == LineType::dyad;
}

bool is_pivot(const TopologyLine& line) {
  return line.line.type == LineType::pivot;
}

bool has_number(const TopologyLine& line) {
  return line.given[0] || line.given[1];
}

bool is_bound(const TopologyLine& line) {
  return std::ranges::any_of(line.bounds, [](const Range& range) {
    return std::isfinite(range.min) || std::isfinite(range.max);
  });
}

template <class Lines>
auto& crank_of(Lines& lines) {
  return *std::ranges::find(lines, LineType::crank,
                            [](const TopologyLine& line) { return line.line.type; });
}

/// Whether nothing fixes the size of the mechanism.
bool has_any_size(const Topology& topology) {
  std::ptrdiff_t places = 0;
  for (const TopologyLine& line : topology.lines) {
    if (!is_pivot(line) && has_number(line)) return false;
    if (is_pivot(line) && (has_number(line) || is_bound(line))) ++places;
  }
  return places < 2;
}

/// The topology with what may be chosen without loss. Crank angles that are given count from the x
/// axis: the mechanism must be free to turn.
Topology framed(const DwellProblem& of, const Topology& from) {
  Topology topology = from;
  TopologyLine& crank = crank_of(topology.lines);
  if (has_any_size(from)) {
    crank.given[0] = std::clamp(1.0, crank.bounds[0].min, crank.bounds[0].max);
  }
  const auto is_open = [](const TopologyLine& line) {
    return !has_number(line) && !is_bound(line);
  };
  TopologyLine& own = topology.lines[static_cast<std::size_t>(crank.line.first)];
  for (const TopologyLine& line : topology.lines) {
    if (is_pivot(line) && &line != &own && !is_open(line)) return topology;
  }
  if (is_open(own)) own.given = {0.0, 0.0};
  const bool turns =
      std::ranges::any_of(of.dwells, [](const Dwell& one) { return bool(one.from); });
  if (turns || !own.given[1]) return topology;
  const auto other = std::ranges::find_if(
      topology.lines, [&](const TopologyLine& line) { return is_pivot(line) && &line != &own; });
  if (other != topology.lines.end()) other->given[1] = own.given[1];
  return topology;
}

/// Centre: the crank's pivot where it is known. Size: the crank, else a third of the longest link.
TargetScale scale_of(const Topology& framed) {
  TargetScale scale;
  const TopologyLine& crank = crank_of(framed.lines);
  const auto& pivot = framed.lines[static_cast<std::size_t>(crank.line.first)].given;
  if (pivot[0] && pivot[1]) scale.centre = {*pivot[0], *pivot[1]};
  double longest = 0;
  for (const TopologyLine& line : framed.lines) {
    if (!is_of_length(line)) continue;
    for (const auto& length : line.given) longest = std::max(longest, length.value_or(0) / 3);
  }
  if (longest > 0) scale.size = longest;
  if (crank.given[0]) scale.size = *crank.given[0];
  return scale;
}

int named_line(const Topology& topology, const std::string& name) {
  const auto found = std::ranges::find(topology.lines, name, &TopologyLine::name);
  return static_cast<int>(found - topology.lines.begin());
}

}  // namespace

DwellSpace::DwellSpace(const DwellProblem& of, const Topology& given)
    : DwellSpace(of, given, framed(of, given)) {}

DwellSpace::DwellSpace(const DwellProblem& of, const Topology& given, const Topology& framed)
    : ChainSpace(framed, scale_of(framed), of.constraints.transmission_angle),
      scale(scale_of(framed)),
      from(named_line(given, of.output[0])),
      to(named_line(given, of.output[1])),
      swing_min(of.swing_min + kMargin),
      problem(&of) {
  topology = &given;
  cosine_limit -= kMargin;
  std::size_t at = 0;
  for (const TopologyLine& line : framed.lines) {
    const bool is_length = is_of_length(line);
    for (int i = 0; i < synthesis::parameter_count(line.line.type); ++i, ++at) {
      const Range& bound = line.bounds[static_cast<std::size_t>(i)];
      if (!std::isfinite(bound.min)) lower[at] = is_length ? kLeastUnits : -kMostUnits;
      if (!std::isfinite(bound.max)) upper[at] = kMostUnits;
      if (is_length) lower[at] = std::max(lower[at], kLeastLink);
    }
  }
}

double relative_angle(const Vec2d& way, const Vec2d& reference) {
  return std::atan2(cross(reference, way), dot(reference, way));
}

}  // namespace cognate::problems
