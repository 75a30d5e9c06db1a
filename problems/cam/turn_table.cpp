#include "problems/cam/turn_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/cam/profile.hpp"
#include "analysis/cam/turn_extremes.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

using cam::CamQuantity;
using cam::TurnPlace;

/// The place at `angle` of a turn, on the later piece at a border.
TurnPlace place_at(const cam::MotionProgramme& programme, double angle) {
  const auto& pieces = programme.pieces();
  const double within = angle < kTurn ? angle : 0;
  const auto behind =
      std::ranges::upper_bound(pieces, within, {}, [](const auto& piece) { return piece.begin; });
  const auto index = std::max<std::ptrdiff_t>(behind - pieces.begin(), 1) - 1;
  const auto& piece = pieces[static_cast<std::size_t>(index)];
  return {angle, static_cast<int>(index), std::min(1.0, (within - piece.begin) / piece.span)};
}

/// Curves with a radius so many times the cam's size are straight but for rounding.
constexpr double kStraight = 1e9;

class TurnTable {
 public:
  TurnTable(const CamProblem& problem, const CamDesign& design, int steps)
      : problem_(problem), design_(design), system_(design.cam.system) {
    system_.operation = design.operation;
    Column angles{"cam_deg", "cam", "cam", "deg", {}};
    for (int i = 0; i <= steps; ++i) {
      angles.values.push_back(360.0 * i / steps);
      places_.push_back(place_at(design.cam.programme, kTurn * i / steps));
    }
    columns_.push_back(std::move(angles));
  }

  void add_motion() {
    const bool swings = is_oscillating(problem_.follower);
    const char* const unit = swings ? "rad" : "length";
    if (swings) {
      add("displacement_deg", "deg",
          [](const auto&, const auto& m) { return m.displacement * 180 / kPi; });
    } else {
      add("displacement", unit, [](const auto&, const auto& m) { return m.displacement; });
    }
    const auto by = [&](const char* of) { return std::string(unit) + of; };
    add("velocity_per_rad", by("/rad"), [](const auto&, const auto& m) { return m.velocity; });
    add("acceleration_per_rad2", by("/rad²"),
        [](const auto&, const auto& m) { return m.acceleration; });
    add("jerk_per_rad3", by("/rad³"), [](const auto&, const auto& m) { return m.jerk; });
    const double speed = design_.operation.speed;
    if (!(speed > 0)) return;
    add("velocity_per_s", by("/s"), [&](const auto&, const auto& m) { return speed * m.velocity; });
    add("acceleration_per_s2", by("/s²"),
        [&](const auto&, const auto& m) { return speed * speed * m.acceleration; });
  }

  void add_curves() {
    add("pressure_angle_deg", "deg", [&](const auto&, const auto& m) {
      return value_of(CamQuantity::pressure_angle, system_, m) * 180 / kPi;
    });
    const bool flat = is_flat(problem_.follower);
    const double radius = flat ? 0 : system_.follower.dimensions.roller_radius;
    add_curve("profile", -radius);
    add("curvature_radius", "length", [&, radius](const auto&, const auto& m) {
      if (is_flat(problem_.follower)) return value_of(CamQuantity::face_radius, system_, m);
      const double pitch = 1 / value_of(CamQuantity::pitch_curvature, system_, m);
      return std::abs(pitch) < kStraight * size() ? pitch - radius : kNaN;
    });
    if (radius > 0) add_curve("centre", 0);
  }

  void add_forces() {
    add("contact_force_N", "N", CamQuantity::contact_force);
    add("torque_N_m", "N m", CamQuantity::torque);
    if (!(design_.operation.width > 0)) return;
    add("contact_stress", "N/length²", [&](const auto&, const auto& m) {
      return std::sqrt(std::max(0.0, value_of(CamQuantity::squared_stress, system_, m)));
    });
  }

  std::vector<Column> take() && { return std::move(columns_); }

 private:
  double size() const {
    const auto& lengths = system_.follower.dimensions;
    return lengths.base_radius + lengths.roller_radius + design_.cam.programme.highest();
  }

  /// Adds a column of what `value` gives for a place and the motion there.
  template <class Value>
  void add(std::string name, std::string unit, Value value) {
    Column column{std::move(name), "cam", "follower", std::move(unit), {}};
    for (const TurnPlace& place : places_) {
      column.values.push_back(value(place, motion_at(design_.cam.programme, place)));
    }
    columns_.push_back(std::move(column));
  }

  void add(const char* name, const char* unit, CamQuantity quantity) {
    add(name, unit, [&](const auto&, const auto& m) { return value_of(quantity, system_, m); });
  }

  /// The curve at `distance` from that which the follower gives, mirrored where the cam turns
  /// clockwise.
  void add_curve(const std::string& name, double distance) {
    const cam::CamCurve curve{system_, design_.cam.programme, distance};
    const double side = problem_.clockwise ? -1 : 1;
    add(name + "_x", "length", [&](const TurnPlace& place, const auto&) {
      return side * curve_point(curve, place.piece, place.t).at.x;
    });
    add(name + "_y", "length", [&](const TurnPlace& place, const auto&) {
      return curve_point(curve, place.piece, place.t).at.y;
    });
  }

  const CamProblem& problem_;
  const CamDesign& design_;
  cam::CamSystem<double> system_;
  std::vector<TurnPlace> places_;
  std::vector<Column> columns_;
};

}  // namespace

std::vector<Column> turn_table(const CamProblem& problem, const CamDesign& design, int steps) {
  TurnTable table(problem, design, steps);
  table.add_motion();
  table.add_curves();
  if (problem.has_operation) table.add_forces();
  return std::move(table).take();
}

}  // namespace cognate::problems
