#include "problems/chain/output/dyad.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"

namespace cognate::problems {
namespace {

using synthesis::LineType;

/// The lines of a topology before that of the output's joint, with the point that carries it as the
/// traced one.
Topology carrying(const OutputSpace& space) {
  Topology part = *space.topology;
  part.trace = space.lines[static_cast<std::size_t>(space.to)].line.first;
  part.lines.resize(static_cast<std::size_t>(space.to));
  return part;
}

}  // namespace

CircleNear circle_near(std::span<const Vec2d> points) {
  const auto count = static_cast<double>(points.size());
  Vec2d mean;
  for (const Vec2d& point : points) mean = mean + (1 / count) * point;
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;
  for (const Vec2d& point : points) {
    const Vec2d p = point - mean;
    const double square = squared_norm(p);
    xx += p.x * p.x;
    xy += p.x * p.y;
    yy += p.y * p.y;
    xz += p.x * square;
    yz += p.y * square;
    zz += square;
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-12 * zz * zz)) return {};
  const Vec2d centre{(xz * yy - yz * xy) / (2 * determinant),
                     (yz * xx - xz * xy) / (2 * determinant)};
  CircleNear circle{mean + centre, std::sqrt(zz / count + squared_norm(centre)), 0};
  for (const Vec2d& point : points) {
    // Its square has been taken above: hypot would guard against nothing.
    const double distance = std::sqrt(squared_norm(point - circle.centre));
    circle.deviation = std::max(circle.deviation, std::abs(distance - circle.radius));
  }
  return circle;
}

bool ends_in_free_dyad(const OutputSpace& space) {
  const auto& lines = space.lines;
  const auto to = static_cast<std::size_t>(space.to), from = static_cast<std::size_t>(space.from);
  const auto& dyad = lines[to].line;
  if (dyad.type != LineType::dyad || lines[from].line.type != LineType::pivot) return false;
  if (dyad.second != space.from) return false;
  const auto is_given = [&](std::size_t k, int count) {
    for (int i = 0; i < count; ++i) {
      const int place = lines[k].parameter + i;
      if (space.given[static_cast<std::size_t>(place)]) return true;
    }
    return false;
  };
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto& line = lines[k].line;
    const bool uses = line.first == space.from || line.second == space.from;
    if (k != to && uses) return false;
  }
  const bool is_last = to + 1 == lines.size() && from + 1 == to;
  return is_last && !is_given(to, 2) && !is_given(from, 2);
}

OutputCarrier::OutputCarrier(const OutputSpace& of, const Range& transmission)
    : topology_(carrying(of)), space_(topology_, TargetScale{}, transmission) {
  const std::size_t count = space_.given.size();
  space_.given.assign(of.given.begin(), of.given.begin() + static_cast<std::ptrdiff_t>(count));
  space_.free.clear();
  std::ranges::copy_if(of.free, std::back_inserter(space_.free),
                       [&](int parameter) { return static_cast<std::size_t>(parameter) < count; });
}

std::optional<synthesis::ChainDesign> hung(const OutputSpace& space,
                                           const synthesis::ChainDesign& carrier,
                                           const Vec2d& pivot, const CircleNear& circle,
                                           const Vec2d& point) {
  const auto to = static_cast<std::size_t>(space.to), from = static_cast<std::size_t>(space.from);
  synthesis::ChainDesign chain = carrier;
  chain.parameters.resize(space.given.size());
  chain.side.resize(space.lines.size(), 0);
  double* at = chain.parameters.data();
  at[space.lines[from].parameter] = pivot.x;
  at[space.lines[from].parameter + 1] = pivot.y;
  at[space.lines[to].parameter] = circle.radius;
  at[space.lines[to].parameter + 1] = norm(circle.centre - pivot);
  chain.side[to] = cross(pivot - point, circle.centre - point) > 0 ? 1 : -1;
  const auto& assembly = space.topology->lines[to].assembly;
  if (assembly && (*assembly == Assembly::open) != (chain.side[to] > 0)) return std::nullopt;
  return chain;
}

bool ends_in_free_slider(const OutputSpace& space) {
  const auto to = static_cast<std::size_t>(space.to), from = static_cast<std::size_t>(space.from);
  const auto is_given = [&](std::size_t line, int index) {
    const int place = space.lines[line].parameter + index;
    return space.given[static_cast<std::size_t>(place)].has_value();
  };
  const bool is_last = to + 1 == space.lines.size() && from + 1 == to;
  return is_last && !is_given(from, 1) && !is_given(to, 0);
}

std::optional<double> guide_direction(const OutputSpace& space) {
  const int place = space.lines[static_cast<std::size_t>(space.from)].parameter;
  return space.given[static_cast<std::size_t>(place)];
}

bool has_free_carrier(const OutputSpace& space) {
  const auto before = std::span(space.lines).first(static_cast<std::size_t>(space.from));
  return std::ranges::all_of(before, [&](const synthesis::PlacedLine& line) {
    for (int i = 0; i < synthesis::parameter_count(line.line.type); ++i) {
      const auto& given = space.given[static_cast<std::size_t>(line.parameter + i)];
      if (given && (line.line.type != LineType::pivot || *given != 0)) return false;
    }
    return true;
  });
}

std::optional<synthesis::ChainDesign> with_slider(const OutputSpace& space,
                                                  const synthesis::ChainDesign& carrier,
                                                  const Vec2d& guide, const CircleNear& circle,
                                                  const Vec2d& point) {
  const auto to = static_cast<std::size_t>(space.to), from = static_cast<std::size_t>(space.from);
  synthesis::ChainDesign chain = carrier;
  chain.parameters.resize(space.given.size());
  chain.side.resize(space.lines.size(), 0);
  double* at = chain.parameters.data();
  const auto pivot = static_cast<std::size_t>(space.lines[from].line.first);
  const double* through = at + space.lines[pivot].parameter;
  at[space.lines[from].parameter] = angle_of(guide);
  at[space.lines[from].parameter + 1] = cross(guide, circle.centre - Vec2d{through[0], through[1]});
  at[space.lines[to].parameter] = circle.radius;
  chain.side[to] = dot(guide, circle.centre - point) > 0 ? 1 : -1;
  const auto& assembly = space.topology->lines[to].assembly;
  if (assembly && (*assembly == Assembly::open) != (chain.side[to] > 0)) return std::nullopt;
  return chain;
}

}  // namespace cognate::problems
