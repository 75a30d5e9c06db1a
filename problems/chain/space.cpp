#include "problems/chain/space.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "synthesis/chain/bodies.hpp"

namespace cognate::problems {
namespace {

using synthesis::ParameterRole;

/// Lengths and coordinates without a bound end at so many times the target's size, links at so
/// small a part of it: beyond, a search runs after designs that nobody builds.
constexpr double kMostSizes = 12, kLeastSize = 0.02;
/// Of |cos μ| where no limit is given: a dead point is excluded, its neighbourhood is not.
constexpr double kNearDead = 1 - 1e-4;

struct ParameterScale {
  double origin, size;
  double into(double value) const { return (value - origin) / size; }
  double out_of(double value) const { return origin + size * value; }
};

ParameterScale scale_of(const TargetScale& scale, ParameterRole role) {
  switch (role) {
    case ParameterRole::x:
      return {scale.centre.x, scale.size};
    case ParameterRole::y:
      return {scale.centre.y, scale.size};
    case ParameterRole::direction:
    case ParameterRole::body_angle:
      return {0, 1};
    default:
      return {0, scale.size};
  }
}

/// `design` with each of its parameters in the other unit.
synthesis::ChainDesign converted(const TargetScale& scale, const synthesis::Chain& chain,
                                 synthesis::ChainDesign design,
                                 double (ParameterScale::*other)(double) const) {
  for (const auto& [line, parameter] : placed_lines(chain)) {
    for (int i = 0; i < synthesis::parameter_count(line.type); ++i) {
      const ParameterScale own = scale_of(scale, parameter_role(line.type, i));
      const int place = parameter + i;
      double& value = design.parameters[static_cast<std::size_t>(place)];
      value = (own.*other)(value);
    }
  }
  return design;
}

/// What a parameter without bounds may be. Directions may turn further than they can differ.
Range open_range(ParameterRole role, double least_length, double most) {
  switch (role) {
    case ParameterRole::length:
      return {least_length, most};
    case ParameterRole::direction:
    case ParameterRole::body_angle:
      return {-kTurn, kTurn};
    default:
      return {-most, most};
  }
}

}  // namespace

TargetScale::TargetScale(std::span<const Vec2d> points) {
  for (const Vec2d& point : points) centre = centre + (1.0 / double(points.size())) * point;
  double square = 0;
  for (const Vec2d& point : points) square += squared_norm(point - centre);
  size = std::sqrt(square / double(points.size()));
}

synthesis::ChainDesign TargetScale::into(const synthesis::Chain& chain,
                                         synthesis::ChainDesign design) const {
  return converted(*this, chain, std::move(design), &ParameterScale::into);
}

synthesis::ChainDesign TargetScale::out_of(const synthesis::Chain& chain,
                                           synthesis::ChainDesign design) const {
  return converted(*this, chain, std::move(design), &ParameterScale::out_of);
}

ChainSpace::ChainSpace(const Topology& of, const TargetScale& scale, const Range& transmission)
    : topology(&of),
      chain(chain_of(of)),
      lines(placed_lines(chain)),
      joints(synthesis::joints(chain)),
      cosine_limit(std::min({kNearDead, std::cos(transmission.min), -std::cos(transmission.max)})) {
  for (const TopologyLine& line : of.lines) {
    for (int i = 0; i < synthesis::parameter_count(line.line.type); ++i) {
      const ParameterRole role = parameter_role(line.line.type, i);
      const ParameterScale own = scale_of(scale, role);
      const auto& value = line.given[static_cast<std::size_t>(i)];
      const Range bound = line.bounds[static_cast<std::size_t>(i)];
      if (!value && has_dimensions(line.line.type)) free.push_back(static_cast<int>(given.size()));
      given.push_back(value ? std::optional(own.into(*value)) : std::nullopt);
      const Range open = open_range(role, kLeastSize, kMostSizes);
      lower.push_back(std::isfinite(bound.min) ? own.into(bound.min) : open.min);
      upper.push_back(std::isfinite(bound.max) ? own.into(bound.max) : open.max);
    }
  }
}

void ChainSpace::limit_open(double least, double most) {
  std::size_t at = 0;
  for (const TopologyLine& line : topology->lines) {
    const bool has_length = has_lengths(line.line.type);
    for (int i = 0; i < synthesis::parameter_count(line.line.type); ++i, ++at) {
      if (parameter_role(line.line.type, i) == ParameterRole::direction) continue;
      const Range& bound = line.bounds[static_cast<std::size_t>(i)];
      if (!std::isfinite(bound.min)) lower[at] = has_length ? least : -most;
      if (!std::isfinite(bound.max)) upper[at] = lower[at] < most ? most : lower[at] + most;
      if (lower[at] > upper[at]) lower[at] = has_length ? upper[at] : upper[at] - most;
      if (has_length) lower[at] = std::max(lower[at], kLeastLink);
    }
  }
}

synthesis::ChainDesign within_bounds(const ChainSpace& space, synthesis::ChainDesign design) {
  for (const int parameter : space.free) {
    const auto i = static_cast<std::size_t>(parameter);
    design.parameters[i] = std::clamp(design.parameters[i], space.lower[i], space.upper[i]);
  }
  return design;
}

synthesis::ChainDesign with_guides_forward(const ChainSpace& space, synthesis::ChainDesign design) {
  const auto is_on = [&](std::size_t slider, int guide) {
    const auto& line = space.lines[slider].line;
    return line.type == synthesis::LineType::slider && line.second == guide;
  };
  for (int k = 0; k < static_cast<int>(space.lines.size()); ++k) {
    const auto& [line, parameter] = space.lines[static_cast<std::size_t>(k)];
    if (line.type != synthesis::LineType::guide) continue;
    const auto at = static_cast<std::size_t>(parameter);
    double &direction = design.parameters[at], &offset = design.parameters[at + 1];
    direction = std::remainder(direction, kTurn);
    bool is_open = !space.given[at] && (!space.given[at + 1] || offset == 0) &&
                   -offset >= space.lower[at + 1] && -offset <= space.upper[at + 1];
    for (std::size_t i = 0; i < space.lines.size(); ++i) {
      if (is_on(i, k) && space.topology->lines[i].assembly) is_open = false;
    }
    if (!is_open || std::abs(direction) <= kPi / 2) continue;
    direction -= std::copysign(kPi, direction);
    offset = -offset;
    for (std::size_t i = 0; i < space.lines.size(); ++i) {
      if (is_on(i, k)) design.side[i] = -design.side[i];
    }
  }
  return design;
}

bool is_same_chain(const synthesis::ChainDesign& known, const synthesis::ChainDesign& other,
                   double tolerance) {
  if (known.side != other.side) return false;
  const auto &a = known.parameters, &b = other.parameters;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i] - b[i]) > tolerance * std::max(1.0, std::abs(a[i]))) return false;
  }
  return true;
}

}  // namespace cognate::problems
