/// @file The straight segment as a nonlinear program: Chebyshev's approximation of a line by a
/// coupler curve, with the ends of the segment among the unknowns.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "problems/linkage/four_bar_raster.hpp"
#include "problems/linkage/linkage_constraints.hpp"
#include "problems/straight_line/segment.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// What is to be best.
enum class SegmentObjective {
  deviation,  ///< least δ/L
  length,     ///< greatest L, δ limited
  size        ///< least size over L, δ limited
};

/// By what `problem.goal` demands; `deviation` where it demands nothing, as along a front.
SegmentObjective objective_of(const StraightLineProblem& problem);

/// Largest dimension over length where the file says nothing and more would always be better.
inline constexpr double kSizeOverLength = 2;
/// In lengths of the segment: longer links are not sought.
inline constexpr double kFarthest = 1e3;

/// Where a front begins unless the file says where.
inline constexpr double kFrontSizeOverLength = 4;

/// Whether the goal names neither length nor deviation.
bool wants_front(const StraightLineProblem& problem);

/// The limit on the largest dimension over the length: the file's, or by the objective.
double size_limit(const StraightLineProblem& problem);

/// The class that keeps the crank of a start turning where the transmission angle is limited, which
/// is then that of the full turn.
std::optional<RequiredClass> class_of(const StraightLineProblem& problem,
                                      const LinkageSegment& start);

/// No closer than this to a dead point, where a linkage jams and its path has no tangent.
inline constexpr double kDeadPointMargin = 0.0175;  // 1°

/// Distances h of the curve's points from a line across it, at nodes over the segment, and the
/// limits. Least max |h|/L over the nodes for `deviation`; |h| ≤ δ at the nodes for the others. The
/// length is that between the feet of the ends. All derivatives are exact, by dual numbers.
///
/// Where the place is limited beside the ends of the line (`limits_place`), pivot and frame's
/// direction are variables that equations tie to the line; limits of the pivots are then limits of
/// the linkage's shape.
///
/// Without a scale in the file (`has_scale`) the length is 1.
class SegmentModel final : public synthesis::Model {
 public:
  /// Takes from `start` its type, assembly and class, and the half turns of its line. `nodes`:
  /// places along the segment from −1 to 1, both among them.
  SegmentModel(const StraightLineProblem& problem, const LinkageSegment& start,
               std::vector<double> nodes);

  std::vector<double> variables_of(const LinkageSegment& segment) const;
  LinkageSegment segment(std::span<const double> x) const;
  /// Where crank, coupler, rocker (of a slider-crank the offset), frame and coupler point are among
  /// the variables; of pivots it says nothing.
  FourBarPlaces places() const;

  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override;
  int constraint_count() const override { return constraint_count_; }
  int equality_count() const override { return 1 + (direction_ ? 1 : 0) + (has_place_ ? 2 : 0); }
  synthesis::Objective objective() const override;
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;

 private:
  enum Dimension {
    crank,
    coupler,
    rocker,
    frame,
    point_u,
    point_v,
    centre,
    reach,
    line,
    height,
    length,
    pivot_x,
    pivot_y,
    frame_angle,
    size,
    least_speed,
    dimension_count
  };
  static constexpr int kMoving = length;  ///< those that the curve and its line depend on
  using All = std::array<double, dimension_count>;
  template <class T>
  struct Curve;
  class Rows;

  void add_variable(Dimension dimension, std::optional<double> given, Range range,
                    const char* name);
  void list_links();
  void list_segment(const LinkageSegment& start);
  void list_places();
  All dimensions(std::span<const double> x) const;
  template <class T>
  bool trace(const All& at, Curve<T>& curve) const;
  template <class T>
  void add_rows(const All& at, Rows& rows) const;
  template <class T>
  void add_place(const Curve<T>& curve, const All& at, Rows& rows) const;
  template <class T>
  void add_band(const Curve<T>& curve, const All& at, Rows& rows) const;
  void add_sizes(const All& at, Rows& rows) const;
  void add_links(const All& at, Rows& rows) const;
  template <class T>
  void add_transmission(const Curve<T>& curve, Rows& rows) const;
  template <class T>
  void add_speeds(const Curve<T>& curve, const All& at, Rows& rows) const;
  void add_pivot(const All& at, Rows& rows) const;

  StraightLineProblem problem_;
  SegmentObjective objective_;
  MechanismType type_;
  double assembly_;
  std::optional<RequiredClass> class_;
  LinkageConstraints link_limits_;
  std::vector<double> nodes_;
  std::optional<double> direction_;  ///< of the line, either way along it
  bool has_place_ = false;           ///< the middle of the line is the origin
  double half_turns_ = 0;            ///< of the line's sense against `direction_`
  std::vector<synthesis::Variable> variables_;
  std::vector<Dimension> free_;
  All fixed_{};
  int constraint_count_ = 0;
};

/// Chebyshev's places, crowded to the ends, `cells` + 1 of them.
std::vector<double> segment_nodes(int cells);

}  // namespace cognate::problems
