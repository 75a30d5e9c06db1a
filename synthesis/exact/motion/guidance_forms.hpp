/// @file Poses as bilinear forms in the two pivots of a dyad.
///
/// A pose turned by e and moved by d from the first keeps the distance of moving pivot w and fixed
/// pivot g where
///
///     |d|²/2 + Re(e d̄ w) − Re(d̄ g) + Re((1 − e) w ḡ) = 0        (w at the first pose)
///
/// (half of Burmester's condition). In homogeneous coordinates u = (w₁, w₂, α), v = (g₁, g₂, β) it
/// is uᵀBv = 0: bilinear, and true at infinity as well: β = 0 is a slider on the frame across the
/// direction (g₁, g₂), α = 0 a block on a line of the body across (w₁, w₂). A fixed pivot maps the
/// poses to lines of the body, and a moving pivot to lines of the frame.
///
/// Coordinates are about the mean pole and in units of the poles' spread, so nothing depends on
/// where the frame and the body have their origins.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>

#include "synthesis/exact/motion/dyad.hpp"
#include "synthesis/exact/motion/null_space_pivots.hpp"

namespace cognate::synthesis {

class GuidanceForms {
 public:
  static constexpr int kMost = 4;

  /// Two to five poses, which must outlive the forms.
  explicit GuidanceForms(std::span<const Pose> poses);

  /// `found` where the poses are in general position; else what is degenerate (see
  /// GuidanceStatus). `family` where the conditions are dependent.
  GuidanceStatus status() const { return status_; }

  /// One form for each pose after the first, of norm 1.
  int count() const { return count_; }
  const Eigen::Matrix3d& form(int j) const { return forms_[static_cast<std::size_t>(j)]; }

  /// An orthonormal basis of the forms: the same dyads, better posed where poses are close.
  const Eigen::Matrix3d& basis(int j) const { return basis_[static_cast<std::size_t>(j)]; }

  /// For five poses: what satisfies the four conditions in (h, w, g, q), q = w ḡ, three orthonormal
  /// columns.
  const PivotNullSpace& null_space() const { return null_space_; }

  /// Homogeneous coordinates, unit vectors, of a point in body axes and one in the frame.
  Eigen::Vector3d moving(const Vec2d& in_body) const;
  Eigen::Vector3d fixed(const Vec2d& at) const;

  /// The line a·x = 0 of moving (body axes) or fixed pivots as the points p·x + q·y.
  std::array<Eigen::Vector3d, 2> moving_line(const Line& line) const;
  std::array<Eigen::Vector3d, 2> fixed_line(const Line& line) const;

  /// `pair` moved onto the curve (four poses: by the least step) or to the solution (five) by
  /// Newton's method, to rounding.
  PivotPair refined(const PivotPair& pair) const;

  /// The dyad of a refined pair, its condition included: pr or rp where a pivot is at infinity
  /// within rounding. Empty where both are (that holds the body's angle and is no dyad), or so far
  /// away that numbers no longer hold them.
  std::optional<GuidingDyad> dyad(const PivotPair& pair) const;

  /// The greatest |uᵀBv| over the forms.
  double residual(const PivotPair& pair) const;

 private:
  void place(std::span<const Displacement> displacements);
  void orthogonalise(std::span<const Displacement> displacements);
  Vec2d point(const Eigen::Vector3d& homogeneous) const;
  Vec2d body_point(const Eigen::Vector3d& moving) const;
  Vec2d frame_point(const Eigen::Vector3d& fixed) const;
  GuidingDyad straightened(const PivotPair& pair, bool fixed_at_infinity) const;
  bool is_slide(const GuidingDyad& slide, const GuidingDyad& link, bool at_infinity) const;

  std::span<const Pose> poses_;
  Vec2d first_direction_;  ///< e^{i·angle} of the first pose
  Vec2d origin_;           ///< from the body's origin at the first pose
  double unit_ = 1;
  double straight_ = 0;  ///< the residual to which rounding lets a slide fit the poses
  int count_ = 0;
  GuidanceStatus status_ = GuidanceStatus::found;
  std::array<Eigen::Matrix3d, kMost> forms_;
  std::array<Eigen::Matrix3d, kMost> basis_;
  PivotNullSpace null_space_;
};

}  // namespace cognate::synthesis
