#include <fmt/core.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/coupler_curve/path_curvature.hpp"
#include "analysis/coupler_curve/pole.hpp"
#include "analysis/coupler_curve/stationary_curvature.hpp"
#include "analysis/linkage/cognates.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/exact.hpp"
#include "app/python/mechanism.hpp"
#include "synthesis/exact/motion/burmester_curves.hpp"
#include "synthesis/exact/motion/dyad.hpp"
#include "synthesis/exact/motion/five_poses.hpp"
#include "synthesis/exact/motion/three_poses.hpp"

namespace cognate::python {
namespace {

using synthesis::DyadSolutions;
using synthesis::GuidingDyad;
using synthesis::Pose;

template <std::size_t Count>
std::array<Pose, Count> poses_of(const py::object& value) {
  const Numbers rows(value, "poses");
  const std::string form = fmt::format("({}, 3), [[x, y, angle in radians], ...]", Count);
  rows.expect("poses", form.c_str(), {py::ssize_t{Count}, 3});
  rows.expect_finite("poses");
  std::array<Pose, Count> poses;
  for (std::size_t i = 0; i < Count; ++i) {
    const auto row = rows.values().subspan(3 * i, 3);
    poses[i] = {{row[0], row[1]}, row[2]};
  }
  return poses;
}

const char* word(synthesis::DyadKind kind) {
  switch (kind) {
    case synthesis::DyadKind::rr:
      return "rr";
    case synthesis::DyadKind::pr:
      return "pr";
    case synthesis::DyadKind::rp:
      return "rp";
  }
  return "";
}

/// The dyads as columns.
py::dict dyads_table(std::span<const GuidingDyad> dyads, std::string_view status) {
  std::vector<Vec2d> in_body, moving, fixed, direction;
  std::vector<double> length, residual, condition;
  py::list kinds;
  for (const GuidingDyad& dyad : dyads) {
    kinds.append(word(dyad.kind));
    in_body.push_back(dyad.in_body);
    moving.push_back(dyad.moving);
    fixed.push_back(dyad.fixed);
    direction.push_back(dyad.direction);
    length.push_back(dyad.length);
    residual.push_back(dyad.residual);
    condition.push_back(dyad.condition);
  }
  py::dict all;
  all["status"] = std::string(status);
  all["kind"] = kinds;
  all["in_body"] = to_array(in_body);
  all["moving"] = to_array(moving);
  all["fixed"] = to_array(fixed);
  all["direction"] = to_array(direction);
  all["length"] = to_array(length);
  all["residual"] = to_array(residual);
  all["condition"] = to_array(condition);
  return all;
}

py::dict dyads_table(const DyadSolutions& found) {
  return dyads_table(found.dyads(), synthesis::sentence(found.status));
}

py::dict five_poses(const py::object& value) {
  return dyads_table(synthesis::dyads_of_five_poses(poses_of<5>(value)));
}

py::dict three_poses(const py::object& value, const py::object& moving, const py::object& fixed) {
  const auto poses = poses_of<3>(value);
  if (moving.is_none() == fixed.is_none()) {
    raise_fault("in_body", "and fixed are both given, or neither is; expected one of them");
  }
  return dyads_table(moving.is_none()
                         ? synthesis::dyads_with_fixed_pivot(poses, point_of(fixed, "fixed"))
                         : synthesis::dyads_with_moving_pivot(poses, point_of(moving, "in_body")));
}

py::list four_poses(const py::object& value, double spacing, double reach) {
  const auto poses = poses_of<4>(value);
  if (!(spacing >= 1e-4 && spacing <= 1)) {
    raise_fault("spacing", fmt::format("is {}; 0.0001 to 1 is allowed", spacing));
  }
  if (!(reach > 0 && reach <= 1e6)) {
    raise_fault("reach", fmt::format("is {}; above 0, at most 1000000 is allowed", reach));
  }
  std::vector<std::vector<GuidingDyad>> branches;
  std::string status;
  {
    const py::gil_scoped_release unlocked;
    const synthesis::BurmesterCurves curves(poses);
    status = synthesis::sentence(curves.status());
    for (int branch = 0; branch < curves.branch_count(); ++branch) {
      std::vector<GuidingDyad>& dyads = branches.emplace_back();
      for (const auto& point : curves.trace(branch, spacing, reach)) dyads.push_back(point.dyad);
    }
  }
  py::list all;
  for (const auto& dyads : branches) all.append(dyads_table(dyads, status));
  return all;
}

py::dict circle_table(const Circle& circle) {
  py::dict all;
  all["centre"] = to_array(circle.centre);
  all["radius"] = circle.radius;
  return all;
}

/// The local geometry of a body of a mechanism; None where it has no pole.
py::object instant_geometry(const Moved& mechanism, double angle, const std::string& body) {
  const auto names = mechanism.body_names();
  const auto found = std::ranges::find(names, body);
  if (found == names.end() || found == names.begin()) {
    raise_fault("body", fmt::format("is \"{}\", no moving body of this mechanism", body));
  }
  MechanismMotion<3> motion(mechanism.named().mechanism);
  if (!motion.move_to(angle)) return py::none();
  const auto at = pole(motion.bodies()[static_cast<std::size_t>(found - names.begin())]);
  if (!at) return py::none();
  py::dict all;
  all["pole"] = to_array(at->at);
  all["inflection_circle"] = circle_table(inflection_circle(*at));
  all["inflection_pole"] = to_array(inflection_pole(*at));
  all["return_circle"] = circle_table(return_circle(*at));
  all["ball_point"] = py::none();
  if (const auto cubic = circling_points(*at)) {
    if (const auto ball = ball_point(*cubic)) all["ball_point"] = to_array(*ball);
  }
  return all;
}

/// The mechanism table of a four-bar.
py::object table_of(const FourBar& linkage) {
  return Moved(problems::named(linkage)).tables();
}

const FourBar& coupler_four_bar(const Moved& mechanism) {
  const FourBar* linkage = mechanism.named().four_bar();
  if (linkage == nullptr || !linkage->coupler_point) {
    raise_fault("mechanism", "is no four-bar with a coupler_point; others have no cognates");
  }
  return *linkage;
}

py::list cognates(const Moved& mechanism, double angle) {
  const FourBar& linkage = coupler_four_bar(mechanism);
  py::list all;
  if (const auto timed = timed_cognate(linkage)) {
    const double turned = angle - frame_angle(linkage) + frame_angle(*timed);
    all.append(py::make_tuple(table_of(*timed), turned));
  }
  if (const auto other = coupler_cognate(linkage, angle)) {
    all.append(py::make_tuple(table_of(other->linkage), other->crank_angle));
  }
  return all;
}

}  // namespace

void bind_exact_motion(py::module_& module) {
  module.def("five_poses", &five_poses);
  module.def("three_poses", &three_poses);
  module.def("four_poses", &four_poses);
  module.def("instant_geometry", &instant_geometry);
  module.def("cognates", &cognates);
}

}  // namespace cognate::python
