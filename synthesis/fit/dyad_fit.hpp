/// @file Dyads nearest to many poses: circles and lines of least squared distance.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/exact/motion/dyad.hpp"
#include "synthesis/exact/motion/pose.hpp"
#include "synthesis/optimise/model.hpp"
#include "synthesis/optimise/solver.hpp"

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

/// How far a dyad is from guiding the body through the poses, as a sum of squares: the deviations
/// of the moving pivot's distance from the link's length (rr), of the moving pivot from the slide
/// line (pr), or of the fixed pivot from the body's line (rp).
double squared_misfit(const GuidingDyad& dyad, std::span<const Pose> poses);

/// The link of locally least misfit that is reached from `start`'s pivots. Empty where that
/// solver finds no value, or the pivots leave for infinity. `poses`: at least three.
std::optional<GuidingDyad> nearest_link(const GuidingDyad& start, std::span<const Pose> poses,
                                        const Options& options = {});

/// The slider and the block of least misfit: for a slide line of normal n the point of the body and
/// the line follow from a linear problem, n·(d + e m) = c, and what that leaves of n·d is least for
/// an eigenvector of a symmetric 2×2 matrix. There is one minimum. A block is a slider of the
/// inverse motion.
GuidingDyad nearest_slider(std::span<const Pose> poses);
GuidingDyad nearest_block(std::span<const Pose> poses);

/// The slider whose line has the direction given (a unit vector), and its best point.
GuidingDyad slider_along(std::span<const Pose> poses, const Vec2d& direction);
/// The block on a line of the body of the direction given (a unit vector, body axes).
GuidingDyad block_along(std::span<const Pose> poses, const Vec2d& direction);

}  // namespace cognate::synthesis
