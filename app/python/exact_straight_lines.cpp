#include <fmt/core.h>
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "app/python/arguments.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/exact.hpp"
#include "app/python/mechanism.hpp"
#include "synthesis/exact/straight_line/contact_search.hpp"
#include "synthesis/exact/straight_line/straight_points.hpp"

namespace cognate::python {
namespace {

using synthesis::CouplerLinkage;
using synthesis::NoStraightPoint;
using synthesis::StraightLineSolution;
using synthesis::StraightPoint;

const char* word(NoStraightPoint why) {
  switch (why) {
    case NoStraightPoint::none:
      return "none";
    case NoStraightPoint::not_closed:
      return "not-closed";
    case NoStraightPoint::change_point:
      return "change-point";
    case NoStraightPoint::parallel_motion:
      return "parallel-motion";
    case NoStraightPoint::at_infinity:
      return "at-infinity";
    case NoStraightPoint::at_pole:
      return "at-pole";
    case NoStraightPoint::at_slider:
      return "at-slider";
    case NoStraightPoint::too_few:
      return "too-few";
    case NoStraightPoint::misses_coupler_line:
      return "misses-coupler-line";
  }
  return "";
}

CouplerLinkage linkage_of(const py::object& given) {
  const auto& mechanism =
      object_of<Moved>(given, "mechanism", "a cognate.FourBar or cognate.SliderCrank");
  const auto& description = mechanism.named().description;
  if (const auto* bar = std::get_if<FourBar>(&description)) return *bar;
  if (const auto* slider = std::get_if<SliderCrank>(&description)) return *slider;
  raise_fault("mechanism", "is neither a four-bar nor a slider-crank; expected one");
}

py::dict point_table(const StraightPoint& point) {
  py::dict all;
  all["kind"] = std::string(synthesis::name(point.kind));
  all["coupler_point"] = to_array(point.coupler_point);
  all["contact"] = point.contact.points;
  all["tangent"] = to_array(point.contact.tangent);
  all["coefficient"] = point.contact.coefficient;
  all["residual"] = point.contact.residual;
  all["condition"] = point.condition;
  return all;
}

py::dict straight_points(const py::object& mechanism, const py::object& angle,
                         const py::object& contact) {
  const auto found =
      synthesis::straight_points(linkage_of(mechanism), number_of(angle, "angle"),
                                 static_cast<int>(whole_of(contact, "contact", 3, 5)));
  py::list points;
  for (const StraightPoint& point : found.points) points.append(point_table(point));
  py::dict all;
  all["why"] = word(found.why);
  all["points"] = points;
  return all;
}

/// A four-bar with the point as its coupler point.
py::object tables_with(const CouplerLinkage& linkage, const Vec2d& point) {
  if (const auto* slider = std::get_if<SliderCrank>(&linkage)) {
    return tables_of(problems::named(*slider));
  }
  FourBar bar = std::get<FourBar>(linkage);
  bar.coupler_point = point;
  return tables_of(problems::named(bar));
}

py::list solutions_list(const std::vector<StraightLineSolution>& found) {
  py::list all;
  for (const auto& each : found) {
    py::dict one = point_table(each.point);
    one["mechanism"] = tables_with(each.linkage, each.point.coupler_point);
    one["crank_angle"] = each.crank_angle;
    all.append(one);
  }
  return all;
}

py::list straight_positions(const py::object& mechanism, const py::object& contact) {
  const CouplerLinkage linkage = linkage_of(mechanism);
  const int points = static_cast<int>(whole_of(contact, "contact", 4, 5));
  const auto found = [&] {
    const py::gil_scoped_release unlocked;
    return synthesis::straight_positions(linkage, points);
  }();
  return solutions_list(found);
}

py::list straight_lengths(const py::object& mechanism, const py::object& angle,
                          const py::object& length) {
  const CouplerLinkage linkage = linkage_of(mechanism);
  const auto* bar = std::get_if<FourBar>(&linkage);
  if (bar == nullptr) raise_fault("mechanism", "is no four-bar; expected one");
  constexpr std::array kLengths = {&Lengths<double>::crank, &Lengths<double>::coupler,
                                   &Lengths<double>::rocker, &Lengths<double>::frame};
  const auto which = word_of(length, "length", {"crank", "coupler", "rocker", "frame"});
  const double at = number_of(angle, "angle");
  const auto found = [&] {
    const py::gil_scoped_release unlocked;
    return synthesis::straight_lengths(*bar, kLengths[which], at);
  }();
  return solutions_list(found);
}

}  // namespace

void bind_exact_straight_lines(py::module_& module) {
  module.def("straight_points", &straight_points);
  module.def("straight_positions", &straight_positions);
  module.def("straight_lengths", &straight_lengths);
}

}  // namespace cognate::python
