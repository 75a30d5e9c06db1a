/// @file One arc of crank pivots in its own coordinates: the machinery of rocker.hpp.
#pragma once

#include <optional>

#include "synthesis/exact/quick_return/pivot.hpp"
#include "synthesis/exact/quick_return/rocker.hpp"

namespace cognate::synthesis {

/// What was given beside K, rocker and swing, and fixes the pivot on its arc.
enum class RockerGiven { crank, coupler, frame, line, limit };

/// An arc of pivots; formulas and notation are those of rocker.hpp.
class RockerArc {
 public:
  RockerArc(const RockerTask& task, PivotArc arc);

  double h() const { return h_; }
  double y0() const { return y0_; }
  double rocker() const { return task_.rocker; }
  const ReturnAngle& angle() const { return angle_; }

  /// q̂, infinite at K = 1; not positive where the arc has no pivots.
  double end() const { return end_; }

  /// q of the length given, of either sign; empty where that length is the same on all of the arc:
  /// the crank at K = 1, the frame where D is the centre of the circle.
  std::optional<double> of_crank(double crank) const;
  std::optional<double> of_coupler(double coupler) const;
  std::optional<double> of_frame(double frame) const;

  /// κ of `best_rockers`.
  double kappa() const;

  ArcPoint at(double q) const;
  ArcLimits limits() const;

  /// The linkage with its pivot at (±l₁ l₂/h, y₀ ± height), `side` = −1 for A left of the bisector.
  QuickReturnRocker design(const ArcPoint& point, int side) const;

  /// As `design`, with residual, condition and transmission angles; empty where the analysis kernel
  /// does not find the desired swing and time ratio. `normal`: of the line, for `line`; for `limit`
  /// the gradient of the rocker's angle by A over h.
  std::optional<QuickReturnRocker> confirmed(const ArcPoint& point, int side, RockerGiven given,
                                             const Vec2d& normal = {}) const;

 private:
  double condition(const QuickReturnRocker& design, const ArcPoint& point, RockerGiven given,
                   const Vec2d& normal) const;

  RockerTask task_;
  PivotArc arc_;
  ReturnAngle angle_;
  double half_swing_ = 0;
  double h_ = 0, y0_ = 0, end_ = 0, frame_slope_ = 0;
};

/// Adds the linkage at `point` and its mirror image, as far as they are confirmed.
void add_pair(const RockerArc& arc, const ArcPoint& point, RockerGiven given,
              RockerSolutions& found);

}  // namespace cognate::synthesis
