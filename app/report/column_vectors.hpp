/// @file Which columns of an analysis are the components of vectors, and where those act.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/mechanism/mechanism.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::app {

/// Two neighbouring columns whose names differ in one letter, x and y.
struct ColumnVector {
  std::size_t x = 0;
  std::size_t y = 0;
  /// Where it is drawn: the point or the joint that the columns are of; empty where the mechanism
  /// has no such place (the shaking force).
  std::optional<Attached<double>> at;
};

/// All vectors among `columns`, in their order.
std::vector<ColumnVector> column_vectors(const problems::NamedMechanism& mechanism,
                                         const std::vector<problems::Column>& columns);

/// The normal force of a sliding joint: column · `normal`, a unit vector in the axes of `at.body`.
struct NormalForce {
  std::size_t column = 0;
  Attached<double> at;
  Vec2d normal{};
};

/// The normal forces among `columns`, known by their names: "frame_on_slider_N".
std::vector<NormalForce> normal_forces(const problems::NamedMechanism& mechanism,
                                       const std::vector<problems::Column>& columns);

}  // namespace cognate::app
