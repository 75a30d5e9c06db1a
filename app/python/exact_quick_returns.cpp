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
#include "problems/quick_return/designs.hpp"
#include "synthesis/exact/quick_return/guide.hpp"
#include "synthesis/exact/quick_return/limit_angle.hpp"
#include "synthesis/exact/quick_return/rocker.hpp"
#include "synthesis/exact/quick_return/shaper.hpp"
#include "synthesis/exact/quick_return/slider.hpp"

namespace cognate::python {
namespace {

double time_ratio_of(const py::object& value) {
  constexpr double kMost = 1e100;
  const double ratio = number_of(value, "time_ratio");
  if (!(ratio >= 1 && ratio <= kMost)) {
    raise_fault("time_ratio", fmt::format("is {}; 1 to {} is allowed", ratio, kMost));
  }
  return ratio;
}

/// An angle between 0 and `most`.
double angle_of(const py::object& value, const char* name, double most) {
  const double angle = number_of(value, name);
  if (!(angle > 0 && angle < most)) {
    raise_fault(name, fmt::format("is {}; above 0 and below {:.6g} is allowed", angle, most));
  }
  return angle;
}

const char* word(synthesis::RockerDegeneracy degeneracy) {
  switch (degeneracy) {
    case synthesis::RockerDegeneracy::none:
      return "none";
    case synthesis::RockerDegeneracy::any_coupler:
      return "any-coupler";
    case synthesis::RockerDegeneracy::one_frame:
      return "one-frame";
    case synthesis::RockerDegeneracy::line_is_the_arc:
      return "line-is-the-arc";
  }
  return "";
}

const char* word(synthesis::SliderDegeneracy degeneracy) {
  switch (degeneracy) {
    case synthesis::SliderDegeneracy::none:
      return "none";
    case synthesis::SliderDegeneracy::any_coupler:
      return "any-coupler";
    case synthesis::SliderDegeneracy::no_offset:
      return "no-offset";
    case synthesis::SliderDegeneracy::no_quick:
      return "no-quick";
  }
  return "";
}

const char* word(synthesis::ShaperOutcome outcome) {
  switch (outcome) {
    case synthesis::ShaperOutcome::solved:
      return "solved";
    case synthesis::ShaperOutcome::no_swing:
      return "no-swing";
    case synthesis::ShaperOutcome::short_rod:
      return "short-rod";
    case synthesis::ShaperOutcome::overshoot:
      return "overshoot";
  }
  return "";
}

synthesis::PivotLine pivot_line_of(const py::object& value) {
  const Numbers numbers(value, "line");
  numbers.expect("line", "(3,), [a, b, c] of a x + b y = c", {3});
  numbers.expect_finite("line");
  const auto row = numbers.values();
  if (row[0] == 0 && row[1] == 0) raise_fault("line", "has a and b 0; expected a line");
  return {row[0], row[1], row[2]};
}

synthesis::RockerLimitAngle limit_angle_of(synthesis::RockerLimit limit, const py::object& value) {
  return {
      limit,
      angle_of(value, limit == synthesis::RockerLimit::outer ? "outer_limit" : "inner_limit", kPi)};
}

/// `given`: crank, coupler, frame, line, outer_limit, inner_limit, or best, for which `value` is
/// None.
synthesis::RockerSolutions rockers(const synthesis::RockerTask& task, std::size_t given,
                                   const py::object& value) {
  switch (given) {
    case 0:
      return rockers_with_crank(task, length_of(value, "crank"));
    case 1:
      return rockers_with_coupler(task, length_of(value, "coupler"));
    case 2:
      return rockers_with_frame(task, length_of(value, "frame"));
    case 3:
      return rockers_on_line(task, pivot_line_of(value));
    case 4:
      return rockers_at_limit(task, limit_angle_of(synthesis::RockerLimit::outer, value));
    case 5:
      return rockers_at_limit(task, limit_angle_of(synthesis::RockerLimit::inner, value));
    default:
      return best_rockers(task, {});
  }
}

py::dict rockers_of(const synthesis::RockerSolutions& found) {
  py::list designs;
  for (const auto& each : found.designs) {
    py::dict one;
    one["mechanism"] = tables_of(problems::named(each.linkage));
    one["arc"] = each.arc == synthesis::PivotArc::near ? "near" : "far";
    one["mirror"] = each.mirror;
    one["outer"] = each.outer;
    one["inner"] = each.inner;
    one["residual"] = each.residual;
    one["condition"] = each.condition;
    one["transmission_min"] = each.transmission.min;
    one["transmission_max"] = each.transmission.max;
    designs.append(one);
  }
  py::dict all;
  all["designs"] = designs;
  all["degeneracy"] = word(found.degeneracy);
  all["circuit_defects"] = found.circuit_defects;
  return all;
}

py::dict quick_return_rockers(const py::object& time_ratio, const py::object& rocker,
                              const py::object& swing, const std::string& given,
                              const py::object& value) {
  const synthesis::RockerTask task{time_ratio_of(time_ratio), length_of(rocker, "rocker"),
                                   angle_of(swing, "swing", kPi)};
  const std::size_t which =
      word_of(py::str(given), "given",
              {"crank", "coupler", "frame", "line", "outer_limit", "inner_limit", "best"});
  return rockers_of(rockers(task, which, value));
}

py::dict quick_return_rockers_by_frame(const py::object& time_ratio, const py::object& rocker,
                                       const py::object& frame, const std::string& given,
                                       const py::object& value) {
  const synthesis::RockerFrameTask task{time_ratio_of(time_ratio), length_of(rocker, "rocker"),
                                        length_of(frame, "frame")};
  const bool outer = word_of(py::str(given), "given", {"outer_limit", "inner_limit"}) == 0;
  const auto limit = outer ? synthesis::RockerLimit::outer : synthesis::RockerLimit::inner;
  return rockers_of(rockers_with_frame_at_limit(task, limit_angle_of(limit, value)));
}

/// `given`: offset, crank, coupler, or best, for which `value` is None.
py::dict quick_return_sliders(const py::object& time_ratio, const py::object& stroke,
                              const std::string& given, const py::object& value) {
  const synthesis::SliderTask task{time_ratio_of(time_ratio), length_of(stroke, "stroke")};
  const auto found = [&] {
    switch (word_of(py::str(given), "given", {"offset", "crank", "coupler", "best"})) {
      case 0:
        return sliders_with_offset(task, number_of(value, "offset"));
      case 1:
        return sliders_with_crank(task, length_of(value, "crank"));
      case 2:
        return sliders_with_coupler(task, length_of(value, "coupler"));
      default:
        return best_sliders(task);
    }
  }();
  py::list designs;
  for (const auto& each : found.designs) {
    py::dict one;
    one["mechanism"] = tables_of(problems::named(each.mechanism));
    one["mirror"] = each.mirror;
    one["outer"] = each.outer;
    one["inner"] = each.inner;
    one["residual"] = each.residual;
    one["condition"] = each.condition;
    one["pressure_angle"] = each.pressure;
    designs.append(one);
  }
  py::dict all;
  all["designs"] = designs;
  all["degeneracy"] = word(found.degeneracy);
  return all;
}

py::list quick_return_guides(const py::object& time_ratio, const py::object& frame,
                             const py::object& crank, const py::object& offset) {
  const double ratio = time_ratio_of(time_ratio), aside = number_of(offset, "offset");
  if (frame.is_none() == crank.is_none()) {
    raise_fault("frame", "and crank are both given, or neither is; expected one of them");
  }
  const auto found = frame.is_none()
                         ? synthesis::guides_with_crank(ratio, length_of(crank, "crank"), aside)
                         : synthesis::guides_with_frame(ratio, length_of(frame, "frame"), aside);
  py::list designs;
  for (const auto& each : found) {
    py::dict one;
    one["mechanism"] = tables_of(problems::named(each.mechanism));
    one["mirror"] = each.mirror;
    one["left"] = each.left;
    one["right"] = each.right;
    one["residual"] = each.residual;
    one["condition"] = each.condition;
    designs.append(one);
  }
  return designs;
}

std::optional<double> length_or_none(const py::object& value, const char* name) {
  if (value.is_none()) return std::nullopt;
  return length_of(value, name);
}

py::dict quick_return_shaper(const py::object& time_ratio, const py::object& stroke,
                             const py::object& frame, const py::object& crank,
                             const py::object& rod, const py::object& pressure,
                             const py::object& ram_height) {
  if (frame.is_none() == crank.is_none()) {
    raise_fault("frame", "and crank are both given, or neither is; expected one of them");
  }
  if (rod.is_none() == pressure.is_none()) {
    raise_fault("rod", "and pressure_angle are both given, or neither is; expected one of them");
  }
  synthesis::ShaperTask task{.time_ratio = time_ratio_of(time_ratio),
                             .stroke = length_of(stroke, "stroke"),
                             .frame = length_or_none(frame, "frame"),
                             .crank = length_or_none(crank, "crank"),
                             .rod = length_or_none(rod, "rod"),
                             .pressure = std::nullopt,
                             .ram_height = length_or_none(ram_height, "ram_height")};
  if (!pressure.is_none()) task.pressure = angle_of(pressure, "pressure_angle", kPi / 2);
  const auto found = synthesis::shaper(task);
  py::dict all;
  all["outcome"] = word(found.outcome);
  if (found.outcome != synthesis::ShaperOutcome::solved) return all;
  all["mechanism"] = tables_of(problems::named_shaper(found.shaper));
  all["crank"] = found.shaper.crank;
  all["frame"] = found.shaper.frame;
  all["bar"] = found.shaper.bar;
  all["rod"] = found.shaper.rod;
  all["ram_height"] = found.shaper.ram_height;
  all["pressure_angle"] = found.shaper.pressure;
  return all;
}

}  // namespace

void bind_exact_quick_returns(py::module_& module) {
  module.def("quick_return_rockers", &quick_return_rockers);
  module.def("quick_return_rockers_by_frame", &quick_return_rockers_by_frame);
  module.def("quick_return_sliders", &quick_return_sliders);
  module.def("quick_return_guides", &quick_return_guides);
  module.def("quick_return_shaper", &quick_return_shaper);
}

}  // namespace cognate::python
