#include "app/documents/json_values.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::Box;
using problems::Range;
using problems::reading::Array;
using problems::reading::Node;
using problems::reading::Table;

bool is_finite(const Range& range) {
  return std::isfinite(range.min) && std::isfinite(range.max);
}

std::optional<Range> as_range(const Node& min, const Node& max) {
  const auto* first = std::get_if<double>(&min.value);
  const auto* second = std::get_if<double>(&max.value);
  return first && second ? std::optional(Range{*first, *second}) : std::nullopt;
}

std::optional<Box> as_box(const Node& min, const Node& max) {
  const auto* first = std::get_if<Array>(&min.value);
  const auto* second = std::get_if<Array>(&max.value);
  if (!first || !second || first->size() != 2 || second->size() != 2) return std::nullopt;
  const auto x = as_range(first->front(), second->front());
  const auto y = as_range(first->back(), second->back());
  return x && y ? std::optional(Box{{x->min, y->min}, {x->max, y->max}}) : std::nullopt;
}

struct NodeJson {
  ordered_json operator()(const Array& array) const {
    if (array.size() == 2) {
      if (const auto range = as_range(array.front(), array.back())) return to_json(*range);
      if (const auto box = as_box(array.front(), array.back())) return to_json(*box);
    }
    ordered_json all = ordered_json::array();
    for (const Node& node : array) all.push_back(std::visit(*this, node.value));
    return all;
  }
  ordered_json operator()(const Table& table) const { return to_json(table); }
  ordered_json operator()(problems::reading::DateOrTime) const { return nullptr; }
  template <class Scalar>
  ordered_json operator()(const Scalar& scalar) const {
    return scalar;
  }
};

}  // namespace

ordered_json to_json(const Vec2d& point) {
  return ordered_json::array({point.x, point.y});
}

ordered_json to_json(const Range& range) {
  if (is_finite(range)) return ordered_json::array({range.min, range.max});
  ordered_json sides = ordered_json::object();
  if (std::isfinite(range.min)) sides["min"] = range.min;
  if (std::isfinite(range.max)) sides["max"] = range.max;
  return sides;
}

ordered_json to_json_deg(const Range& range) {
  return to_json(Range{degrees(range.min), degrees(range.max)});
}

ordered_json to_json(const Box& box) {
  const Range x{box.min.x, box.max.x};
  const Range y{box.min.y, box.max.y};
  if (!is_finite(x) || !is_finite(y)) return {{"x", to_json(x)}, {"y", to_json(y)}};
  return ordered_json::array({to_json(box.min), to_json(box.max)});
}

ordered_json to_json(const Table& document) {
  ordered_json table = ordered_json::object();
  for (const auto& [key, where, node] : document) table[key] = std::visit(NodeJson{}, node.value);
  return table;
}

void add_quantities(ordered_json& table, std::span<const problems::Quantity> quantities) {
  for (const auto& quantity : quantities) {
    const auto value =
        std::visit([](const auto& any) { return ordered_json(any); }, quantity.value);
    const auto dot = quantity.name.find('.');
    if (dot == std::string::npos) {
      table[quantity.name] = value;
    } else {
      table[quantity.name.substr(0, dot)][quantity.name.substr(dot + 1)] = value;
    }
  }
}

std::optional<std::string> find_non_finite(const ordered_json& document) {
  if (document.is_number_float() && !std::isfinite(document.get<double>())) return "";
  if (!document.is_structured()) return std::nullopt;
  for (const auto& [key, value] : document.items()) {
    if (const auto below = find_non_finite(value)) return "/" + key + *below;
  }
  return std::nullopt;
}

}  // namespace cognate::app
