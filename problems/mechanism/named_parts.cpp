#include "problems/mechanism/named_parts.hpp"

#include <algorithm>
#include <ranges>

namespace cognate::problems {

std::optional<Vec2d> place_on(const PointOnLink& point, int body) {
  const auto found = std::ranges::find(point.on, body, &Attached<double>::body);
  return found == point.on.end() ? std::nullopt : std::optional(found->at);
}

std::optional<int> common_body(const PointOnLink& first, const PointOnLink& second) {
  for (const auto& place : std::views::reverse(first.on)) {
    if (place_on(second, place.body)) return place.body;
  }
  return std::nullopt;
}

}  // namespace cognate::problems
