/// @file A path model whose frame is known by its pivots.
#pragma once

#include <vector>

#include "problems/path/model.hpp"

namespace cognate::problems {

/// As PathModel, whose variables frame and frame angle are replaced, in their places, by x and y of
/// the pivot that is not the anchor: then both coordinates of both pivots can lie on a raster. Only
/// where the file gives neither frame nor frame angle. Bounds of these become constraints.
class PivotPathModel final : public synthesis::Model {
 public:
  /// `problem`: already scaled.
  PivotPathModel(const PathProblem& problem, Assembly assembly, bool clockwise);

  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override { return inner_.residual_count(); }
  int constraint_count() const override { return inner_.constraint_count() + limit_count(); }
  std::span<const int> local_of_residual() const override { return inner_.local_of_residual(); }
  int local_count() const override { return inner_.local_count(); }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;

  /// The variables of the path model, and back.
  std::vector<double> inwards(std::span<const double> x) const;
  std::vector<double> outwards(std::span<const double> x) const;

 private:
  struct Frame;

  int place_of(int dimension) const;
  Vec2d anchor(std::span<const double> x) const;
  Frame frame(std::span<const double> x) const;
  int limit_count() const;
  void exchange_columns(const Frame& frame, std::span<double> row) const;
  void limit_frame(const Frame& frame, std::span<double> c, std::span<double> jacobian) const;

  PathModel inner_;
  std::optional<Range> length_, angle_;  ///< bounds of the frame
  bool other_is_d_;                      ///< of the two pivots the one that is not the anchor
  Vec2d fixed_anchor_;                   ///< where the file gives it
  int anchor_x_, other_x_, other_y_;     ///< places among the variables; −1: the anchor is given
  std::vector<synthesis::Variable> variables_;
};

}  // namespace cognate::problems
