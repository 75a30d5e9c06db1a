#include <fmt/core.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/coupler_curve/path_curvature.hpp"
#include "analysis/coupler_curve/pole.hpp"
#include "analysis/coupler_curve/stationary_curvature.hpp"
#include "analysis/linkage/cognates.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "app/python/arguments.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/exact.hpp"
#include "app/python/mechanism.hpp"
#include "problems/guidance/design.hpp"
#include "synthesis/exact/motion/burmester_curves.hpp"
#include "synthesis/exact/motion/dyad.hpp"
#include "synthesis/exact/motion/five_poses.hpp"
#include "synthesis/exact/motion/guided_mechanism.hpp"
#include "synthesis/exact/motion/three_poses.hpp"
#include "synthesis/exact/motion/two_poses.hpp"

namespace cognate::python {
namespace {

using synthesis::DyadSolutions;
using synthesis::GuidingDyad;
using synthesis::Line;
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

/// A direction of any length but 0, as a unit vector.
Vec2d direction_of(const py::object& value, const char* name) {
  const Vec2d given = point_of(value, name);
  const double length = norm(given);
  if (!(length > 0) || !std::isfinite(length)) {
    raise_fault(name, "has no direction; expected [x, y], not both 0");
  }
  return (1 / length) * given;
}

/// `value`: a point and a direction.
Line line_of(const py::object& value) {
  const Numbers numbers(value, "line");
  numbers.expect("line", "(2, 2), [[x, y] of a point, [x, y] of the direction]", {2, 2});
  const auto rows = numbers.values();
  const py::object direction = to_array(Vec2d{rows[2], rows[3]});
  numbers.expect_finite("line");
  return {{rows[0], rows[1]}, direction_of(direction, "line")};
}

/// Raises ProblemError unless one of the arguments is given.
void expect_one(std::initializer_list<std::pair<const char*, const py::object*>> arguments) {
  std::string names;
  int given = 0;
  for (const auto& [name, value] : arguments) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
    given += int{!value->is_none()};
  }
  if (given == 1) return;
  raise_fault(
      arguments.begin()->first,
      fmt::format("is one of the arguments {}, of which exactly one is allowed; {} are given",
                  names, given));
}

py::dict three_poses(const py::object& value, const py::object& moving, const py::object& fixed,
                     const py::object& slide, const py::object& line) {
  const auto poses = poses_of<3>(value);
  expect_one({{"in_body", &moving}, {"fixed", &fixed}, {"slide", &slide}, {"body_line", &line}});
  if (!moving.is_none()) {
    return dyads_table(synthesis::dyads_with_moving_pivot(poses, point_of(moving, "in_body")));
  }
  if (!fixed.is_none()) {
    return dyads_table(synthesis::dyads_with_fixed_pivot(poses, point_of(fixed, "fixed")));
  }
  return dyads_table(
      slide.is_none() ? synthesis::dyads_with_line_direction(poses, direction_of(line, "body_line"))
                      : synthesis::dyads_with_slide_direction(poses, direction_of(slide, "slide")));
}

/// Of the displacements 1→2, 2→3 and 3→1, (3, 2); NaN at infinity.
py::object pole_triangle(const py::object& value) {
  const auto poles = synthesis::pole_triangle(poses_of<3>(value));
  constexpr double kFar = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vec2d> rows;
  for (const auto& pole : {poles.p12, poles.p23, poles.p31}) {
    rows.push_back(pole.value_or(Vec2d{kFar, kFar}));
  }
  return to_array(rows);
}

py::dict two_poses(const py::object& value, const py::object& moving, const py::object& fixed,
                   const py::object& line, const py::object& length) {
  const auto poses = poses_of<2>(value);
  expect_one({{"in_body", &moving}, {"fixed", &fixed}});
  if (!fixed.is_none()) {
    if (line.is_none() || !length.is_none()) {
      raise_fault("line", "is missing, or length is given; a fixed pivot goes with a line alone");
    }
    return dyads_table(
        synthesis::dyads_with_moving_pivot_on(poses, point_of(fixed, "fixed"), line_of(line)));
  }
  const Vec2d pivot = point_of(moving, "in_body");
  if (!line.is_none() && !length.is_none()) {
    raise_fault("line", "and length are both given; expected one of them, or none");
  }
  if (!line.is_none()) {
    return dyads_table(synthesis::dyads_with_fixed_pivot_on(poses, pivot, line_of(line)));
  }
  return dyads_table(length.is_none()
                         ? synthesis::slider_of(poses, pivot)
                         : synthesis::dyads_of_length(poses, pivot, length_of(length, "length")));
}

/// Where the other pivot may stand, as (2, 2): a point and the direction. None: anywhere.
py::object pivot_line(const py::object& value, const py::object& moving, const py::object& fixed) {
  const auto poses = poses_of<2>(value);
  expect_one({{"in_body", &moving}, {"fixed", &fixed}});
  const auto line = fixed.is_none() ? synthesis::fixed_pivots_of(poses, point_of(moving, "in_body"))
                                    : synthesis::moving_pivots_of(poses, point_of(fixed, "fixed"));
  if (!line) return py::none();
  return to_array(std::vector<Vec2d>{line->point, line->direction});
}

GuidingDyad dyad_of(const py::dict& row, std::span<const Pose> poses) {
  const auto value = [&](const char* key) {
    if (!row.contains(key)) raise_fault("dyads", fmt::format("have no \"{}\"", key));
    return py::object(row[key]);
  };
  const std::size_t kind = word_of(value("kind"), "kind", {"rr", "pr", "rp"});
  if (kind == 0) {
    return synthesis::rr_dyad(poses, point_of(value("in_body"), "in_body"),
                              point_of(value("fixed"), "fixed"));
  }
  const Vec2d direction = direction_of(value("direction"), "direction");
  return kind == 1 ? synthesis::pr_dyad(poses, point_of(value("in_body"), "in_body"), direction)
                   : synthesis::rp_dyad(poses, point_of(value("fixed"), "fixed"), direction);
}

/// `poses`: (n, 3); `first` and `second`: rows of tables of dyads.
py::dict guided_mechanism(const py::object& value, const py::dict& first, const py::dict& second) {
  const Numbers rows(value, "poses");
  rows.expect("poses", "(n, 3), [[x, y, angle in radians], ...]", {-1, 3});
  rows.expect_finite("poses");
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < rows.size(); i += 3) {
    poses.push_back({{rows.values()[i], rows.values()[i + 1]}, rows.values()[i + 2]});
  }
  if (poses.empty()) raise_fault("poses", "are none; expected one at least");
  const auto made =
      synthesis::guided_mechanism(dyad_of(first, poses), dyad_of(second, poses), poses);
  if (made.fault != synthesis::PairingFault::none) {
    raise_fault("dyads", fmt::format("make no mechanism: {}", synthesis::sentence(made.fault)));
  }
  const problems::NamedMechanism named = problems::named_mechanism(made);
  std::vector<double> drive;
  py::list assembly;
  for (const auto& station : made.stations) {
    drive.push_back(station.drive);
    assembly.append(station.side == Assembly::open ? "open" : "crossed");
  }
  py::dict all;
  all["mechanism"] = tables_of(named);
  all["body"] = named.bodies[static_cast<std::size_t>(made.body)];
  all["drive"] = to_array(drive);
  all["assembly"] = assembly;
  return all;
}

py::list four_poses(const py::object& value, const py::object& space, const py::object& most) {
  const auto poses = poses_of<4>(value);
  const double spacing = number_of(space, "spacing"), reach = number_of(most, "reach");
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
py::object instant_geometry(const py::object& given, const py::object& drive,
                            const py::object& of) {
  const auto& mechanism = object_of<Moved>(given, "mechanism", "a cognate.Mechanism");
  const double angle = number_of(drive, "angle");
  const std::string body = text_of(of, "body");
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

const FourBar& coupler_four_bar(const py::handle& given) {
  const auto& mechanism = object_of<Moved>(given, "mechanism", "a cognate.FourBar");
  const FourBar* linkage = mechanism.named().four_bar();
  if (linkage == nullptr || !linkage->coupler_point) {
    raise_fault("mechanism", "is no four-bar with a coupler_point; others have no cognates");
  }
  return *linkage;
}

py::list cognates(const py::object& mechanism, const py::object& crank_angle) {
  const double angle = number_of(crank_angle, "angle");
  const FourBar& linkage = coupler_four_bar(mechanism);
  py::list all;
  if (const auto timed = timed_cognate(linkage)) {
    const double turned = angle - frame_angle(linkage) + frame_angle(*timed);
    all.append(py::make_tuple(tables_of(problems::named(*timed)), turned));
  }
  if (const auto other = coupler_cognate(linkage, angle)) {
    all.append(py::make_tuple(tables_of(problems::named(other->linkage)), other->crank_angle));
  }
  return all;
}

}  // namespace

void bind_exact_motion(py::module_& module) {
  module.def("five_poses", &five_poses);
  module.def("three_poses", &three_poses);
  module.def("four_poses", &four_poses);
  module.def("two_poses", &two_poses);
  module.def("pivot_line", &pivot_line);
  module.def("pole_triangle", &pole_triangle);
  module.def("guided_mechanism", &guided_mechanism);
  module.def("instant_geometry", &instant_geometry);
  module.def("cognates", &cognates);
}

}  // namespace cognate::python
