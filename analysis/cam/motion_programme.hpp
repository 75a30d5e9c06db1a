/// @file The motion of a follower over a whole turn of its cam.
#pragma once

#include <optional>
#include <vector>

#include "analysis/cam/motion_law.hpp"

namespace cognate::cam {

/// A place where the motion is not smooth: its derivative `order` (0: displacement, 1: velocity, 2:
/// acceleration) goes from `before` to `after`.
struct Jump {
  double angle = 0;  ///< of the cam, rad, in [0, 2π)
  int order = 0;
  double before = 0;
  double after = 0;
};

/// A stretch of the cam angle in which the follower does not turn back. Its ends are those of a
/// segment or zeros of the velocity.
enum class Stroke { rise, fall, dwell };

/// A piece, or the part [from, to] (shares of it) in which it belongs to one stroke.
struct StrokePart {
  int piece = 0;
  double from = 0;
  double to = 1;
  Stroke stroke = Stroke::dwell;
};

/// The follower's motion over a turn of the cam, piece by piece.
class MotionProgramme {
 public:
  MotionProgramme() = default;
  /// Pieces in order from cam angle 0; the first begins at displacement 0.
  explicit MotionProgramme(std::vector<MotionPiece<double>> pieces);

  /// The pieces, in order from cam angle 0.
  const std::vector<MotionPiece<double>>& pieces() const { return pieces_; }
  /// The pieces, cut where the velocity changes its sign.
  const std::vector<StrokePart>& stroke_parts() const { return parts_; }

  /// The motion at cam angle `angle`, any number of turns; at the border of two pieces that of the
  /// later one.
  FollowerMotion<double> at(double angle) const;

  /// Least and greatest displacement of the whole turn.
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

 private:
  std::vector<MotionPiece<double>> pieces_;
  std::vector<double> begins_;  ///< of the pieces
  std::vector<StrokePart> parts_;
  double lowest_ = 0, highest_ = 0;
};

/// The programme of `segments`, or nothing where one of them has no pieces (`append_pieces`). The
/// last segment should end at 2π and at displacement 0; what is missing shows as a jump.
std::optional<MotionProgramme> programme_of(const std::vector<MotionSegment>& segments);

/// Jumps of displacement, velocity and acceleration, in order of angle, between pieces and from the
/// last to the first. Differences below 1e-9 of the greatest value of that derivative are none.
std::vector<Jump> jumps(const MotionProgramme& programme);

}  // namespace cognate::cam
