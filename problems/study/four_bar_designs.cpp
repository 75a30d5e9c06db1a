#include "problems/study/four_bar_designs.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace cognate::problems {
namespace {

std::array<double, kDesignVariables> dimensions_of(const FourBar& linkage) {
  const Vec2d point = linkage.coupler_point.value_or(Vec2d{});
  return {linkage.pivot_a.x, linkage.pivot_a.y, linkage.pivot_d.x,
          linkage.pivot_d.y, linkage.crank,     linkage.coupler,
          linkage.rocker,    point.x,           point.y};
}

bool is(const KeyPath& path, std::size_t place, std::string_view name) {
  const auto* const text = std::get_if<std::string>(&path[place]);
  return text && *text == name;
}

/// The entry that `path` names at `place`, less than 2.
std::optional<int> entry(const KeyPath& path, std::size_t place) {
  const auto* const index = std::get_if<std::size_t>(&path[place]);
  return index && *index < 2 ? std::optional(static_cast<int>(*index)) : std::nullopt;
}

}  // namespace

std::optional<DesignVariable> four_bar_dimension(const KeyPath& path) {
  using enum DesignVariable;
  if (path.size() < 2 || !is(path, 0, "mechanism")) return std::nullopt;
  const auto from = [](DesignVariable first, int place) {
    return static_cast<DesignVariable>(static_cast<int>(first) + place);
  };
  if (path.size() == 2) {
    if (is(path, 1, "crank")) return crank;
    if (is(path, 1, "coupler")) return coupler;
    if (is(path, 1, "rocker")) return rocker;
  } else if (path.size() == 3 && is(path, 1, "coupler_point")) {
    if (const auto axis = entry(path, 2)) return from(point_u, *axis);
  } else if (path.size() == 4 && is(path, 1, "fixed_pivots")) {
    const auto pivot = entry(path, 2), axis = entry(path, 3);
    if (pivot && axis) return from(pivot_a_x, 2 * *pivot + *axis);
  }
  return std::nullopt;
}

void FourBarDesigns::fill(const FourBar& base, std::span<const DesignVariable> dimensions,
                          std::span<const double> values) {
  const std::size_t count = values.size() / dimensions.size();
  const auto fixed = dimensions_of(base);
  for (std::size_t k = 0; k < kDesignVariables; ++k) columns_[k].assign(count, fixed[k]);
  for (std::size_t k = 0; k < dimensions.size(); ++k) {
    auto& column = columns_[static_cast<std::size_t>(dimensions[k])];
    for (std::size_t i = 0; i < count; ++i) column[i] = values[i * dimensions.size() + k];
  }
  frame_.resize(count);
  const auto &ax = columns_[0], &ay = columns_[1], &dx = columns_[2], &dy = columns_[3];
  for (std::size_t i = 0; i < count; ++i) {
    const double x = dx[i] - ax[i], y = dy[i] - ay[i];
    frame_[i] = std::sqrt(x * x + y * y);
  }
}

FourBar FourBarDesigns::design(const FourBar& base, std::size_t i) const {
  using enum DesignVariable;
  const auto value = [&](DesignVariable dimension) { return of(dimension)[i]; };
  FourBar linkage{{value(pivot_a_x), value(pivot_a_y)},
                  {value(pivot_d_x), value(pivot_d_y)},
                  value(crank),
                  value(coupler),
                  value(rocker),
                  base.assembly,
                  std::nullopt};
  if (base.coupler_point) linkage.coupler_point = Vec2d{value(point_u), value(point_v)};
  return linkage;
}

}  // namespace cognate::problems
