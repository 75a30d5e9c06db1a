#include <fmt/core.h>
#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/gear/involute.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/python/arguments.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/exact.hpp"
#include "problems/task_document.hpp"
#include "synthesis/exact/cam/smallest_cam.hpp"

namespace cognate::python {
namespace {

using synthesis::BindingLimit;
using synthesis::PressureLimits;
using synthesis::SmallestCam;

PressureLimits limits_of(const py::object& pressure) {
  const double degrees = number_of(pressure, "pressure_angle_deg");
  if (!(degrees > 0 && degrees < 90)) {
    raise_fault("pressure_angle_deg",
                fmt::format("is {}; above 0 and below 90 is allowed", degrees));
  }
  return {.whole = degrees * kPi / 180};
}

/// The motion as a cam file with this follower has it.
cam::MotionProgramme programme_of(const py::object& motion, const py::dict& follower,
                                  const py::object& pressure) {
  py::dict document, constraints;
  document["kind"] = "cam";
  document["follower"] = follower;
  document["motion"] = motion;
  constraints["pressure_angle_deg_max"] = pressure;
  document["constraints"] = constraints;
  const Source source = source_of(document);
  auto read = problems::reading::read_task(source.document, source.folder);
  if (!read) raise_faults(source, read.error());
  auto programme = cam::programme_of(std::get<problems::CamProblem>(read->task).motion);
  if (!programme) raise_fault("motion", "has no programme of finite numbers");
  return std::move(*programme);
}

py::object binding_angles(const SmallestCam& found) {
  std::vector<double> binding;
  for (const BindingLimit& limit : found.binding) binding.push_back(limit.angle);
  return to_array(std::move(binding));
}

/// Of a translating roller follower.
py::object smallest_cam(const py::object& motion, const py::object& pressure,
                        const py::object& offset) {
  const PressureLimits limits = limits_of(pressure);
  py::dict follower;
  follower["type"] = "translating-roller";
  const auto programme = programme_of(motion, follower, pressure);
  double least = -std::numeric_limits<double>::infinity(), greatest = -least;
  if (!offset.is_none()) least = greatest = number_of(offset, "offset");
  const auto found = synthesis::smallest_translating(programme, limits, least, greatest);
  if (!found) return py::none();
  py::dict all;
  all["base_radius"] = found->dimensions.base_radius;
  all["offset"] = found->dimensions.offset;
  all["binding_angles"] = binding_angles(*found);
  return all;
}

py::object smallest_oscillating_cam(const py::object& motion, const py::object& pressure,
                                    const py::object& arm, const py::object& side) {
  const PressureLimits limits = limits_of(pressure);
  const double length = length_of(arm, "arm");
  const bool trailing = word_of(side, "side", {"trailing", "leading"}) == 0;
  py::dict follower;
  follower["type"] = "oscillating-roller";
  follower["arm"] = arm;
  follower["side"] = side;
  const auto programme = programme_of(motion, follower, pressure);
  const auto found = synthesis::smallest_oscillating(
      programme, limits, trailing ? cam::ArmSide::trailing : cam::ArmSide::leading, length);
  if (!found) return py::none();
  py::dict all;
  all["base_radius"] = found->dimensions.base_radius;
  all["centre_distance"] = found->dimensions.centre_distance;
  all["binding_angles"] = binding_angles(*found);
  return all;
}

py::object involute(const py::object& angle) {
  const Numbers angles(angle, "angle");
  const NewArray result = new_array(angles.shape());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double one = angles.values()[i];
    if (!(std::abs(one) < kPi / 2)) {
      raise_fault("angle", fmt::format("is {}; between -pi/2 and pi/2 is allowed", one));
    }
    result.data[i] = gear::involute(one);
  }
  return result.array;
}

py::object involute_angle(const py::object& value) {
  const Numbers values(value, "value");
  values.expect_finite("value");
  const NewArray result = new_array(values.shape());
  for (std::size_t i = 0; i < values.size(); ++i) {
    result.data[i] = gear::involute_angle(values.values()[i]);
  }
  return result.array;
}

}  // namespace

void bind_exact_cams(py::module_& module) {
  module.def("smallest_cam", &smallest_cam);
  module.def("smallest_oscillating_cam", &smallest_oscillating_cam);
  module.def("involute", &involute);
  module.def("involute_angle", &involute_angle);
}

}  // namespace cognate::python
