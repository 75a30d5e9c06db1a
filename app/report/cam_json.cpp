#include "app/report/cam_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/cam/profile.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/drawing/cam_drawing.hpp"
#include "app/report/drawn_number.hpp"

namespace cognate::app {
namespace {

/// More pieces than this have no rows of their own: their borders cannot be distinguished.
constexpr std::size_t kManyPieces = 200;

using cam::CamQuantity;
using nlohmann::ordered_json;

/// Chords of a drawn curve leave it by less than this share of the cam's size: a hundredth of a
/// pixel on any screen.
constexpr double kChordTolerance = 6e-6;

/// Beyond this many times the cam's size a profile is drawn as straight.
constexpr double kStraight = 20;

/// About the greatest radius of a cam.
double size_of(const cam::Cam& cam) {
  const auto& d = cam.system.follower.dimensions;
  const double size = is_oscillating(cam.system.follower.type)
                          ? d.centre_distance
                          : std::abs(cam.system.start) + cam.programme.highest();
  return std::isfinite(size) && size > 0 ? size : 1;
}

/// The radius of curvature of the profile, positive where it is convex.
double profile_radius(const cam::CamSystem<double>& system,
                      const cam::FollowerMotion<double>& motion) {
  if (is_flat(system.follower.type)) return value_of(CamQuantity::face_radius, system, motion);
  return 1 / value_of(CamQuantity::pitch_curvature, system, motion) -
         system.follower.dimensions.roller_radius;
}

/// A cam whose table is being filled.
class TableMaker {
 public:
  TableMaker(const cam::Cam& cam, const cam::Operation& operation, std::size_t steps)
      : cam_(cam), system_(cam.system), places_(cam_places(cam.programme, steps)) {
    system_.operation = operation;
    add("deg",
        [](const cam::TurnPlace& place, const auto&) { return kDegreesInRadian * place.angle; });
  }

  /// Adds a column of what `f` gives for a place and the motion there.
  template <class F>
  void add(const char* name, F f) {
    ordered_json values = ordered_json::array();
    for (const cam::TurnPlace& place : places_) {
      values.push_back(drawn(f(place, motion_at(cam_.programme, place))));
    }
    table_[name] = std::move(values);
  }

  void add(const char* name, CamQuantity quantity, double unit = 1) {
    add(name, [&](const auto&, const auto& motion) {
      return unit * value_of(quantity, system_, motion);
    });
  }

  void add_motion() {
    const double unit = is_oscillating(system_.follower.type) ? kDegreesInRadian : 1;
    add("displacement", [&](const auto&, const auto& m) { return unit * m.displacement; });
    add("velocity", [](const auto&, const auto& m) { return m.velocity; });
    add("acceleration", [](const auto&, const auto& m) { return m.acceleration; });
    add("jerk", [](const auto&, const auto& m) { return m.jerk; });
  }

  void add_geometry() {
    const double limit = kStraight * size_of(cam_);
    add("pressure_deg", CamQuantity::pressure_angle, kDegreesInRadian);
    add("radius", [&](const auto&, const auto& motion) {
      const double radius = profile_radius(system_, motion);
      return std::abs(radius) <= limit ? radius : std::numeric_limits<double>::quiet_NaN();
    });
    if (is_flat(system_.follower.type)) {
      add("reach", CamQuantity::reach);
    } else if (system_.follower.dimensions.roller_radius > 0) {
      add("roller_speed", CamQuantity::roller_speed);
    }
  }

  /// The point of contact and the common normal, away from the cam, in the frame's axes.
  void add_contact() {
    const double radius =
        is_flat(system_.follower.type) ? 0 : system_.follower.dimensions.roller_radius;
    const cam::CamCurve profile{system_, cam_.programme, -radius};
    const auto in_frame = [&](const cam::TurnPlace& place, auto part) {
      const auto point = curve_point(profile, place.piece, place.t);
      return part(point) * Vec2d{std::cos(point.angle), std::sin(point.angle)};
    };
    const auto at = [](const cam::ProfilePoint& point) { return point.at; };
    const auto normal = [](const cam::ProfilePoint& point) { return point.normal; };
    add("contact_x", [&](const cam::TurnPlace& p, const auto&) { return in_frame(p, at).x; });
    add("contact_y", [&](const cam::TurnPlace& p, const auto&) { return in_frame(p, at).y; });
    add("normal_x", [&](const cam::TurnPlace& p, const auto&) { return in_frame(p, normal).x; });
    add("normal_y", [&](const cam::TurnPlace& p, const auto&) { return in_frame(p, normal).y; });
  }

  void add_forces(bool with_stress) {
    add("force", CamQuantity::contact_force);
    add("torque", CamQuantity::torque);
    if (!with_stress) return;
    add("stress", [&](const auto&, const auto& motion) {
      return std::sqrt(std::max(0.0, value_of(CamQuantity::squared_stress, system_, motion)));
    });
  }

  ordered_json table() && { return std::move(table_); }

 private:
  const cam::Cam& cam_;
  cam::CamSystem<double> system_;
  std::vector<cam::TurnPlace> places_;
  ordered_json table_;
};

}  // namespace

std::vector<cam::TurnPlace> cam_places(const cam::MotionProgramme& programme, std::size_t steps) {
  const auto& pieces = programme.pieces();
  const bool borders = pieces.size() <= kManyPieces;
  const double step = kTurn / static_cast<double>(steps);
  std::vector<cam::TurnPlace> places;
  std::size_t next = 1;  // of the even steps
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& piece = pieces[i];
    const int index = static_cast<int>(i);
    const double end = piece.begin + piece.span;
    if (borders || i == 0) places.push_back({piece.begin, index, 0});
    for (; next < steps && static_cast<double>(next) * step < end; ++next) {
      const double angle = static_cast<double>(next) * step;
      if (angle <= piece.begin) continue;
      places.push_back({angle, index, std::min(1.0, (angle - piece.begin) / piece.span)});
    }
    if (borders || i + 1 == pieces.size()) places.push_back({std::min(end, kTurn), index, 1});
  }
  return places;
}

std::vector<CamStroke> cam_strokes(const cam::MotionProgramme& programme) {
  std::vector<CamStroke> strokes;
  for (const cam::StrokePart& part : programme.stroke_parts()) {
    const auto& piece = programme.pieces()[static_cast<std::size_t>(part.piece)];
    const double to = piece.begin + part.to * piece.span;
    if (strokes.empty() || strokes.back().stroke != part.stroke) {
      strokes.push_back({piece.begin + part.from * piece.span, to, part.stroke});
    } else {
      strokes.back().to = to;
    }
  }
  return strokes;
}

CamFineness cam_fineness(std::size_t designs) {
  const double share = std::min(1.0, 3.0 / static_cast<double>(std::max<std::size_t>(designs, 1)));
  const CamFineness finest;
  const auto part = [&](std::size_t count, std::size_t least) {
    return std::max(least, static_cast<std::size_t>(share * static_cast<double>(count)));
  };
  return {part(finest.steps, 72), part(finest.points, 144)};
}

ordered_json curve_json(const cam::Cam& cam, double distance, const CamFineness& fineness) {
  const auto points =
      cam::polygon({cam.system, cam.programme, distance}, kChordTolerance * size_of(cam));
  ordered_json deg = ordered_json::array(), x = deg, y = deg, curvature = deg;
  const std::size_t step = points.size() / fineness.points + 1;
  for (std::size_t i = 0; i < points.size(); i += step) {
    deg.push_back(drawn(kDegreesInRadian * points[i].angle));
    x.push_back(drawn(points[i].at.x));
    y.push_back(drawn(points[i].at.y));
    curvature.push_back(drawn(points[i].curvature));
  }
  return {{"deg", deg}, {"x", x}, {"y", y}, {"curvature", curvature}};
}

ordered_json cam_json(const cam::Cam& cam, const problems::CamProblem& problem,
                      const cam::Operation& operation, const CamFineness& fineness) {
  const auto& follower = cam.system.follower;
  const auto& d = follower.dimensions;
  const double profile = parallel_curves(problem, cam, CamCurveKind::profile).front().distance;
  TableMaker maker(cam, operation, fineness.steps);
  maker.add_motion();
  maker.add_geometry();
  maker.add_contact();
  if (problem.has_operation) maker.add_forces(problem.has_contact);
  return {{"side", sign_of(follower.side)},
          {"dimensions",
           {{"base_radius", drawn(d.base_radius)},
            {"offset", drawn(d.offset)},
            {"roller_radius", drawn(d.roller_radius)},
            {"centre_distance", drawn(d.centre_distance)},
            {"arm", drawn(d.arm)},
            {"face_offset", drawn(d.face_offset)}}},
          {"start", drawn(cam.system.start)},
          {"profile", curve_json(cam, profile, fineness)},
          {"pitch", is_flat(follower.type) ? ordered_json(nullptr) : curve_json(cam, 0, fineness)},
          {"table", std::move(maker).table()}};
}

}  // namespace cognate::app
