#include "app/report/column_vectors.hpp"

#include <algorithm>
#include <string>

#include "analysis/mechanism/joints.hpp"

namespace cognate::app {
namespace {

/// Whether the names differ in one letter alone, x in the first and y in the second.
bool names_of_components(const std::string& first, const std::string& second) {
  if (first.size() != second.size()) return false;
  int differences = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == second[i]) continue;
    if (first[i] != 'x' || second[i] != 'y') return false;
    ++differences;
  }
  return differences == 1;
}

bool are_components(const problems::Column& first, const problems::Column& second) {
  return first.quantity == second.quantity && first.of == second.of && first.unit == second.unit &&
         names_of_components(first.name, second.name);
}

/// The place of the point called `name`, or of the joint that is called by its two bodies.
std::optional<Attached<double>> place_of(const problems::NamedMechanism& mechanism,
                                         const std::string& name) {
  for (const auto& point : mechanism.points) {
    if (point.name == name) return point.at;
  }
  for (const Joint& joint : joints(mechanism.mechanism).joints) {
    const auto& first = mechanism.bodies[static_cast<std::size_t>(joint.first)];
    const auto& second = mechanism.bodies[static_cast<std::size_t>(joint.second)];
    if (std::string(first).append("-").append(second) == name) return joint.at;
  }
  return std::nullopt;
}

}  // namespace

std::vector<ColumnVector> column_vectors(const problems::NamedMechanism& mechanism,
                                         const std::vector<problems::Column>& columns) {
  std::vector<ColumnVector> vectors;
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    if (!are_components(columns[i], columns[i + 1])) continue;
    vectors.push_back({i, i + 1, place_of(mechanism, columns[i].of)});
    ++i;
  }
  return vectors;
}

std::vector<NormalForce> normal_forces(const problems::NamedMechanism& mechanism,
                                       const std::vector<problems::Column>& columns) {
  std::vector<NormalForce> forces;
  for (const Joint& joint : joints(mechanism.mechanism).joints) {
    if (joint.type != JointType::prismatic) continue;
    std::string name = mechanism.bodies[static_cast<std::size_t>(joint.first)];
    name.append("_on_").append(mechanism.bodies[static_cast<std::size_t>(joint.second)]);
    const auto column = std::ranges::find(columns, name.append("_N"), &problems::Column::name);
    if (column == columns.end()) continue;
    const auto index = static_cast<std::size_t>(column - columns.begin());
    forces.push_back({index, joint.at, perp(joint.direction)});
  }
  return forces;
}

}  // namespace cognate::app
