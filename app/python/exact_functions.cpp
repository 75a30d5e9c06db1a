#include <fmt/core.h>
#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "app/python/arguments.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/exact.hpp"
#include "problems/task_document.hpp"
#include "synthesis/exact/cam/smallest_cam.hpp"
#include "synthesis/exact/chebyshev.hpp"
#include "synthesis/exact/freudenstein.hpp"
#include "synthesis/exact/function/four_bar_function.hpp"
#include "synthesis/exact/function/slider_crank_function.hpp"

namespace cognate::python {
namespace {

using synthesis::AnglePair;
using synthesis::BindingLimit;
using synthesis::FourBarFunction;
using synthesis::FourBarOutcome;
using synthesis::FreudensteinLinkage;
using synthesis::FreudensteinOutcome;
using synthesis::GivenStart;
using synthesis::PrecisionPoint;
using synthesis::SliderCrankOutcome;

const char* word(FreudensteinOutcome outcome) {
  switch (outcome) {
    case FreudensteinOutcome::linkage:
      return "linkage";
    case FreudensteinOutcome::imaginary_coupler:
      return "imaginary-coupler";
    case FreudensteinOutcome::no_rocker:
      return "no-rocker";
    case FreudensteinOutcome::infinite_frame:
      return "infinite-frame";
  }
  return "";
}

const char* word(FourBarOutcome outcome) {
  switch (outcome) {
    case FourBarOutcome::linkage:
      return "linkage";
    case FourBarOutcome::no_coupler:
      return "no-coupler";
    case FourBarOutcome::infinite_rocker:
      return "infinite-rocker";
    case FourBarOutcome::infinite_crank:
      return "infinite-crank";
    case FourBarOutcome::rigid:
      return "rigid";
    case FourBarOutcome::infinite_frame:
      return "infinite-frame";
  }
  return "";
}

py::object links_array(const Lengths<double>& links) {
  return to_array(std::vector<double>{links.crank, links.coupler, links.rocker, links.frame});
}

Numbers same_length(const py::object& value, const char* name, std::size_t size) {
  Numbers numbers(value, name);
  numbers.expect(name, "(n,), a number for each pair", {static_cast<py::ssize_t>(size)});
  numbers.expect_finite(name);
  return numbers;
}

py::object freudenstein(const py::object& input, const py::object& output,
                        const py::object& weights) {
  const Numbers in(input, "input");
  in.expect("input", "(n,), angles in radians", {-1});
  in.expect_finite("input");
  const Numbers out = same_length(output, "output", in.size());
  if (in.size() < 3) raise_fault("input", "has fewer than 3 angles; 3 or more are allowed");
  std::vector<AnglePair> pairs(in.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {in.values()[i], out.values()[i]};
  std::vector<double> weight;
  if (!weights.is_none()) {
    const Numbers given = same_length(weights, "weights", in.size());
    weight.assign(given.values().begin(), given.values().end());
    for (const double w : weight) {
      if (!(w > 0)) raise_fault("weights", fmt::format("have {}; numbers above 0 are allowed", w));
    }
  }
  const bool is_exact = pairs.size() == 3 && weight.empty();
  const auto ratios = is_exact ? synthesis::freudenstein_exact(std::span<const AnglePair, 3>(pairs))
                               : synthesis::freudenstein_fit(pairs, weight);
  if (!ratios) return py::none();
  const FreudensteinLinkage linkage = synthesis::freudenstein_linkage(ratios->p);
  py::dict all;
  all["ratios"] = to_array(std::span<const double>(ratios->p));
  all["residual"] = ratios->residual;
  all["condition"] = ratios->condition;
  all["outcome"] = word(linkage.outcome);
  all["links"] = links_array(linkage.links);
  all["input_turn"] = linkage.input_turn;
  all["output_turn"] = linkage.output_turn;
  return all;
}

/// The precision points in `points`, and the starts, three conditions and one for each start free.
std::vector<PrecisionPoint> precision_rows(const py::object& points, const GivenStart& start) {
  const Numbers rows(points, "points");
  rows.expect("points", "(n, 2), [[input, output], ...]", {-1, 2});
  rows.expect_finite("points");
  const std::size_t wanted = 3 + std::size_t{!start.input} + std::size_t{!start.output};
  const std::size_t count = rows.size() / 2;
  if (count != wanted) {
    raise_fault("points",
                fmt::format("are {} for {} starts given; expected {}", count, 5 - wanted, wanted));
  }
  std::vector<PrecisionPoint> list(count);
  for (std::size_t i = 0; i < count; ++i) {
    list[i].input = rows.values()[2 * i];
    list[i].output[0] = rows.values()[2 * i + 1];
  }
  return list;
}

GivenStart starts_of(const py::object& input_start, const py::object& output_start) {
  GivenStart start;
  if (!input_start.is_none()) start.input = number_of(input_start, "input_start");
  if (!output_start.is_none()) start.output = number_of(output_start, "output_start");
  return start;
}

py::list precision_points(const py::object& points, const py::object& input_start,
                          const py::object& output_start) {
  const GivenStart start = starts_of(input_start, output_start);
  const auto found = synthesis::four_bar_functions(precision_rows(points, start), start);
  py::list all;
  for (const FourBarFunction& each : found.solutions) {
    py::dict one;
    one["outcome"] = word(each.outcome);
    one["links"] = links_array(each.links);
    one["input_start"] = each.input_start;
    one["output_start"] = each.output_start;
    one["residual"] = each.residual;
    one["condition"] = each.condition;
    all.append(one);
  }
  return all;
}

const char* word(SliderCrankOutcome outcome) {
  switch (outcome) {
    case SliderCrankOutcome::linkage:
      return "linkage";
    case SliderCrankOutcome::no_coupler:
      return "no-coupler";
    case SliderCrankOutcome::no_crank:
      return "no-crank";
    case SliderCrankOutcome::scotch_yoke:
      return "scotch-yoke";
    case SliderCrankOutcome::infinite_links:
      return "infinite-links";
  }
  return "";
}

py::list slider_crank_points(const py::object& points, const py::object& input_start,
                             const py::object& output_start) {
  const GivenStart start = starts_of(input_start, output_start);
  const auto found = synthesis::slider_crank_functions(precision_rows(points, start), start);
  py::list all;
  for (const auto& each : found.solutions) {
    py::dict one;
    one["outcome"] = word(each.outcome);
    one["crank"] = each.crank;
    one["coupler"] = each.coupler;
    one["offset"] = each.offset;
    one["input_start"] = each.input_start;
    one["output_start"] = each.output_start;
    one["residual"] = each.residual;
    one["condition"] = each.condition;
    all.append(one);
  }
  return all;
}

py::object chebyshev(const py::object& first, const py::object& last, const py::object& count) {
  return to_array(
      synthesis::chebyshev_spacing(number_of(first, "first"), number_of(last, "last"),
                                   static_cast<int>(whole_of(count, "count", 1, 1'000'000))));
}

/// Of a translating roller follower.
py::object smallest_cam(const py::object& motion, const py::object& pressure,
                        const py::object& offset) {
  const double pressure_deg = number_of(pressure, "pressure_angle_deg");
  if (!(pressure_deg > 0 && pressure_deg < 90)) {
    raise_fault("pressure_angle_deg",
                fmt::format("is {}; above 0 and below 90 is allowed", pressure_deg));
  }
  py::dict document, follower, lengths;
  document["kind"] = "cam";
  follower["type"] = "translating-roller";
  document["follower"] = follower;
  document["motion"] = motion;
  py::dict constraints;
  constraints["pressure_angle_deg_max"] = pressure_deg;
  document["constraints"] = constraints;
  const Source source = source_of(document);
  auto read = problems::reading::read_task(source.document, source.folder);
  if (!read) raise_faults(source, read.error());
  const auto& problem = std::get<problems::CamProblem>(read->task);
  const auto programme = cam::programme_of(problem.motion);
  if (!programme) raise_fault("motion", "has no programme of finite numbers");
  double least = -std::numeric_limits<double>::infinity(), greatest = -least;
  if (!offset.is_none()) {
    least = greatest = number_of(offset, "offset");
  }
  const auto found = synthesis::smallest_translating(
      *programme, {.whole = pressure_deg * kPi / 180}, least, greatest);
  if (!found) return py::none();
  std::vector<double> binding;
  for (const BindingLimit& limit : found->binding) binding.push_back(limit.angle);
  py::dict all;
  all["base_radius"] = found->dimensions.base_radius;
  all["offset"] = found->dimensions.offset;
  all["binding_angles"] = to_array(binding);
  return all;
}

}  // namespace

void bind_exact_functions(py::module_& module) {
  module.def("freudenstein", &freudenstein);
  module.def("precision_points", &precision_points);
  module.def("chebyshev_spacing", &chebyshev);
  module.def("slider_crank_points", &slider_crank_points);
  module.def("smallest_cam", &smallest_cam);
}

}  // namespace cognate::python
