#include "problems/mechanism/part_index.hpp"

#include <utility>

namespace cognate::problems::reading {

PartNames::PartNames(NamedParts parts) : parts_(std::move(parts)) {
  for (std::size_t i = 0; i < parts_.bodies.size(); ++i) {
    bodies_.emplace(parts_.bodies[i].name, static_cast<int>(i));
  }
  for (std::size_t i = 0; i < parts_.points.size(); ++i) {
    points_.emplace(parts_.points[i].name, i);
    announce(parts_.points[i].name);
  }
}

std::optional<std::size_t> PartNames::point(const std::string& name) const {
  const auto found = points_.find(name);
  return found == points_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<int> PartNames::body(const std::string& name) const {
  const auto found = bodies_.find(name);
  return found == bodies_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string_view> PartNames::all_points() const {
  std::vector<std::string_view> names;
  for (const PointOnLink& point : parts_.points) names.push_back(point.name);
  for (const std::string& name : announced_) {
    if (!point(name)) names.emplace_back(name);
  }
  return names;
}

void PartNames::announce(const std::string& point) {
  if (announced_index_.insert(point).second) announced_.push_back(point);
}

void PartNames::add_body(Body body) {
  bodies_.emplace(body.name, static_cast<int>(parts_.bodies.size()));
  parts_.bodies.push_back(std::move(body));
}

void PartNames::place(const std::string& point, const Attached<double>& on) {
  const auto [place, is_new] = points_.emplace(point, parts_.points.size());
  if (is_new) parts_.points.push_back({point, {}});
  parts_.points[place->second].on.push_back(on);
}

}  // namespace cognate::problems::reading
