/// @file Guidance of a body near many poses as a nonlinear program.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "problems/guidance/dead_station.hpp"
#include "problems/guidance/design.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/linkage/cycle/cycle_limits.hpp"
#include "problems/linkage/driven_range.hpp"
#include "problems/linkage/linkage_constraints.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// What is chosen before dimensions are refined.
struct MotionForm {
  synthesis::DyadKind second = synthesis::DyadKind::rr;
  /// For each pose on which side the second dyad is assembled, +1 or −1: the sign of Im(K E) of
  /// MotionModel.
  std::vector<double> sides;
  std::optional<RequiredClass> confined_to;  ///< see `confining_class`
  /// For each pose the station, from 0, at whose crank angle it is met: poses that noise has put
  /// out of order share one. Empty: each has its own.
  std::vector<int> stations;
  /// Stations between which the crank is driven where limits refer to that; empty: those of the
  /// first and of the last pose.
  std::optional<std::pair<std::size_t, std::size_t>> ends;
  /// For each station the dead point at which it is held, having no crank angle of its own: there a
  /// crank angle says nothing of the body's. Empty: none is.
  std::vector<std::optional<HeldDeadPoint>> held;
  /// Whether the four-bar is kept closed where the crank is in line with the frame, towards the far
  /// pivot and away from it.
  bool closes_towards = false, closes_away = false;
};

/// The links of the four-bar of two links.
Lengths<double> lengths_of(const DyadPair& pair);

/// The form of the mechanism of two dyads, the first a link, as it stands nearest to the poses. All
/// sides are the prevailing one where the problem excludes defects of branch or circuit.
MotionForm form_of(const MotionProblem& problem, const DyadPair& pair);

/// Errors of the body's place and angle at each pose, with exact derivatives.
///
/// Dimensions, those that the file gives left out of the variables: moving pivot (body axes), fixed
/// pivot and length of the first dyad, a driven link; of the second likewise, or for a slider its
/// point of the body, the angle of the slide line's normal and the line's distance from the origin,
/// or for a block its fixed pivot and the same of the body's line. The crank's angle at each
/// station of the form, from the x axis, is a local variable. Where stations are placed, the
/// transmission angle is limited and the crank is of no class that turns it fully, those of the
/// form's ends are global ones: the limits hold between them.
///
/// The crank holds the body's first pivot at B; the second dyad turns the body about it by E =
/// e^{iψ} until its own condition F(B, E) = 0 holds: with m from the first to the second moving
/// pivot, D the second fixed pivot, and line x·n = c,
///
///     rr   ½|B + E m − D|² − ½r² = 0      pr   n·(B + E m) − c = 0
///     rp   n·(Ē (D − B) + m₁) − c = 0
///
/// each of the form Re(K E) = h, so that E = (h ± i√(|K|² − h²)) K̄/|K|². Its derivatives follow
/// from those of F. Lengths are in units of motion_scale.hpp. The finished design is evaluated by
/// the kernel, not by this.
class MotionModel final : public synthesis::Model {
 public:
  static constexpr int dimensions = 10;

  /// `problem`: already scaled.
  MotionModel(const MotionProblem& problem, MotionForm form);

  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override { return 3 * static_cast<int>(problem_.poses.size()); }
  int constraint_count() const override;
  std::span<const int> local_of_residual() const override { return local_of_residual_; }
  int local_count() const override { return local_count_; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;

  /// The variables that stand for `pair`, the form having no stations; each crank angle that
  /// nearest to its pose at which the mechanism closes. What the file gives replaces what the pair
  /// has.
  std::vector<double> variables_of(const DyadPair& pair) const;

  /// The dimension of each global variable that is one, in order: see dimensions.hpp.
  std::span<const int> free_dimensions() const { return free_; }

  /// Number of the station of a pose, and how many there are.
  std::size_t station_of(std::size_t pose) const {
    return form_.stations.empty() ? pose : static_cast<std::size_t>(form_.stations[pose]);
  }

  std::size_t station_count() const { return variable_of_station_.size(); }

  /// Of each pose the derivative of its squared error by the crank angle of its station; empty
  /// where the mechanism does not close at some pose.
  std::vector<double> angle_slopes(std::span<const double> x) const;

  /// The crank angles of the stations, and `x` with others, but for those of stations held.
  std::vector<double> station_angles(std::span<const double> x) const;
  std::vector<double> with_angles(std::span<const double> x,
                                  std::span<const double> station_angles) const;

  /// Whether the limits of the transmission angle hold between the ends of the motion.
  bool limits_driven_range() const;

  /// Where the body stands at a crank angle, on the side of the first pose; empty where the
  /// mechanism does not close.
  std::optional<synthesis::Pose> body_at(std::span<const double> x, double crank_angle) const;

  /// The form with that station held, too, which is nearest to a dead point, coupler and rocker
  /// being in line there but for `angle` at most. Empty where there is none, and where limits refer
  /// to the ends of the motion.
  std::optional<MotionForm> with_held(std::span<const double> x, double angle) const;
  /// The form that is kept closed in line with the frame, where the crank goes through that line on
  /// its way from the first pose to the last and the linkage closes there by less than `share` of
  /// its links. Empty where that is the form already, and where limits refer to the ends.
  std::optional<MotionForm> kept_closed(std::span<const double> x, double share) const;
  /// A station that is held although its poses would be nearer before the dead point, if any.
  std::optional<std::size_t> pressed_inwards(std::span<const double> x) const;
  /// The form with that station at a crank angle of its own, which is put in `angles`.
  std::optional<MotionForm> released(std::span<const double> x, std::size_t station,
                                     std::vector<double>& angles) const;

  /// The dyads, and where the body stands at each pose; `x` must have a value.
  DyadPair pair(std::span<const double> x) const;
  std::vector<synthesis::Pose> reached(std::span<const double> x) const;

 private:
  using Full = std::array<double, dimensions>;
  /// The mechanism at one crank angle.
  struct Station {
    Vec2d crank, pin, turn;  ///< crank and turn: unit vectors
  };
  static constexpr std::size_t kHeld = static_cast<std::size_t>(-1);  ///< for a variable

  void list_variables();
  void add_variable(int dimension, std::optional<double> given, Range range, const char* name);
  void add_point(int dimension, const std::optional<Vec2d>& given, const std::optional<Box>& box,
                 const char* name);
  void list_distance_limits();
  void list_stations();
  void limit_driven_range(std::span<const double> x, const Full& v, std::span<double> c,
                          std::span<double> jacobian) const;
  Full full(std::span<const double> x) const;
  Full dimensions_of(const DyadPair& pair) const;
  struct ClosingSlack {
    double value = 0, links = 0;  ///< the slack, and the sum of all links
    Full slopes{};
  };
  ClosingSlack closing_slack(const Full& v, bool towards) const;
  void limit_closing(const Full& v, std::span<double> c, std::span<double> jacobian) const;
  void limit_turn(const Full& v, std::span<double> c, std::span<double> jacobian) const;
  std::optional<Station> station(const Full& v, std::size_t pose, double crank_angle) const;
  std::optional<Station> station_of_pose(std::span<const double> x, const Full& v,
                                         std::size_t pose) const;
  const std::optional<HeldDeadPoint>& held(std::size_t station) const;
  void set_slopes_of_held(const DeadStation& at, const Vec2d& arm, std::size_t pose,
                          std::span<double> jacobian, std::span<double> local) const;
  double nearest_crank_angle(const Full& v, std::size_t pose) const;

  /// A limit of the distance of two points among the dimensions, c = sign·(distance − limit).
  struct DistanceLimit {
    int from = 0, to = 0;
    double sign = 1, limit = 0;
  };

  MotionProblem problem_;
  MotionForm form_;
  Full fixed_{};           ///< values of the dimensions that are not variables
  std::vector<int> free_;  ///< dimension of each global variable
  std::vector<synthesis::Variable> variables_;
  std::vector<int> local_of_residual_;
  int local_count_ = 0;
  std::vector<std::size_t> variable_of_station_;
  LinkageConstraints linkage_constraints_;
  CycleLimits cycle_limits_;
  DrivenRange driven_range_;  ///< empty unless the ends of the motion are global variables
  std::vector<DistanceLimit> distance_limits_;
};

}  // namespace cognate::problems
