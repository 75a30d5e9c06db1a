/// @file A link that is to keep a point of a body at one distance, as a nonlinear program.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "synthesis/exact/motion/pose.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::synthesis {

/// Residuals |d + e m − g| − r, one for each pose; variables m (body axes), g, r.
class LinkModel final : public Model {
 public:
  /// `unit`: typical length. Pivots are sought within `kReach` units of the origins.
  LinkModel(std::span<const Pose> poses, double unit);

  std::span<const Variable> variables() const override { return variables_; }
  int residual_count() const override { return static_cast<int>(at_.size()); }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;

  static constexpr double kReach = 1e5;

 private:
  std::vector<Vec2d> at_, direction_;
  std::array<Variable, 5> variables_;
};

}  // namespace cognate::synthesis
