#include "problems/leg/space.hpp"

#include <algorithm>
#include <cmath>

#include "problems/leg/known.hpp"
#include "synthesis/chain/sweep.hpp"

namespace cognate::problems {
namespace {

using synthesis::LineType;

/// Without a bound lengths and coordinates are at most so many strides, links at least so many.
constexpr double kMostStrides = 4, kLeastStrides = 0.02;

std::size_t crank_pivot(const Topology& topology) {
  const auto crank = std::ranges::find(topology.lines, LineType::crank,
                                       [](const TopologyLine& line) { return line.line.type; });
  return static_cast<std::size_t>(crank->line.first);
}

bool is_free(const TopologyLine& line) {
  const auto is_bound = [](const Range& range) {
    return std::isfinite(range.min) || std::isfinite(range.max);
  };
  return !line.given[0] && !line.given[1] && std::ranges::none_of(line.bounds, is_bound);
}

Topology with_origin(Topology topology) {
  TopologyLine& pivot = topology.lines[crank_pivot(topology)];
  if (is_free(pivot)) pivot.given = {0.0, 0.0};
  return topology;
}

TargetScale leg_scale(const LegProblem& problem, const Topology& framed) {
  TargetScale scale;
  scale.size = problem.target.stride;
  const auto& pivot = framed.lines[crank_pivot(framed)].given;
  if (pivot[0] && pivot[1]) scale.centre = {*pivot[0], *pivot[1]};
  return scale;
}

/// Published dimensions where the file gives none.
std::optional<synthesis::ChainDesign> known_with(const ChainSpace& space,
                                                 const Topology& topology) {
  auto known = known_leg(topology.name);
  if (!known) return known;
  for (std::size_t i = 0; i < space.given.size(); ++i) {
    known->parameters[i] = space.given[i].value_or(known->parameters[i]);
  }
  for (std::size_t k = 0; k < topology.lines.size(); ++k) {
    const auto& assembly = topology.lines[k].assembly;
    if (assembly) known->side[k] = *assembly == Assembly::open ? 1 : -1;
  }
  return known;
}

}  // namespace

LegSpace::LegSpace(const LegProblem& of, const Topology& given)
    : LegSpace(of, given, with_origin(given)) {}

LegSpace::LegSpace(const LegProblem& of, const Topology& given, const Topology& framed)
    : ChainSpace(framed, leg_scale(of, framed), of.constraints.transmission_angle),
      scale(leg_scale(of, framed)),
      foot(given.trace),
      known(known_with(*this, given)),
      is_movable(std::ranges::all_of(given.lines, is_free)),
      problem(&of) {
  limit_open(kLeastStrides, kMostStrides);
  topology = &given;
  cosine_limit -= kLegMargin;
  const double unit = of.target.stride;
  if (of.target.height_min) height_min = *of.target.height_min / unit;
  if (of.target.height_max) height_max = *of.target.height_max / unit;
  if (of.near) stay_near();
}

/// Links by bounds of their lengths, whose distances are the rest; the coordinates of these have
/// the bounds that follow.
void LegSpace::stay_near() {
  const auto published = *known_leg(topology->name);
  // Less what scaling a leg to its stride may change.
  const double factor = std::max(std::sqrt(*problem->near), *problem->near / (1 + kLegMargin));
  for (const auto& [line, parameter] : lines) {
    const auto at = static_cast<std::size_t>(parameter);
    const double* own = published.parameters.data() + at;
    const bool is_length = has_lengths(line.type);
    for (int k = 0; k < synthesis::parameter_count(line.type); ++k) {
      const std::size_t i = at + static_cast<std::size_t>(k);
      const double most = factor * (is_length ? own[k] : std::hypot(own[0], own[1]));
      // Where the file's own bounds are elsewhere, these go first.
      lower[i] = std::min(upper[i], std::max(lower[i], is_length ? own[k] / factor : -most));
      upper[i] = std::max(lower[i], std::min(upper[i], most));
    }
  }
  limit_distances(published, factor);
}

/// Of pivots from the crank's pivot, and of points of plates from both points that carry them.
void LegSpace::limit_distances(const synthesis::ChainDesign& published, double factor) {
  const std::vector<double> side(published.side.begin(), published.side.end());
  const synthesis::ChainView<double> view{lines.data(), static_cast<int>(lines.size()),
                                          published.parameters.data(), side.data()};
  synthesis::ChainPlace<double> place;
  synthesis::place(view, Vec2d{1, 0}, place);
  const auto limit = [&](int from, int to) {
    const double own = norm(place.at[to] - place.at[from]);
    distances.push_back({from, to, own / factor, own * factor});
  };
  const int crank = static_cast<int>(crank_pivot(*topology));
  for (int k = 0; k < static_cast<int>(lines.size()); ++k) {
    const auto& line = lines[static_cast<std::size_t>(k)].line;
    if (!is_free(topology->lines[static_cast<std::size_t>(k)])) continue;
    if (line.type == LineType::pivot && k != crank) limit(crank, k);
    if (line.type != LineType::attached) continue;
    limit(line.first, k);
    limit(line.second, k);
  }
}

}  // namespace cognate::problems
