#include <fmt/core.h>
#include <pybind11/stl.h>

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/python/arguments.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/exact.hpp"
#include "synthesis/exact/chebyshev.hpp"
#include "synthesis/exact/freudenstein.hpp"
#include "synthesis/exact/function/four_bar_function.hpp"
#include "synthesis/exact/function/slider_crank_function.hpp"
#include "synthesis/exact/respacing.hpp"

namespace cognate::python {
namespace {

using synthesis::AnglePair;
using synthesis::FourBarFunction;
using synthesis::FourBarOutcome;
using synthesis::FreudensteinLinkage;
using synthesis::FreudensteinOutcome;
using synthesis::GeneratingFourBar;
using synthesis::GivenStart;
using synthesis::PrecisionPoint;
using synthesis::RespacingOutcome;
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
/// `lengths`: how many ratios of the lengths the pairs determine beside the starts.
std::vector<PrecisionPoint> precision_rows(const py::object& points, const GivenStart& start,
                                           std::size_t lengths = 3) {
  const Numbers rows(points, "points");
  rows.expect("points", "(n, 2), [[input, output], ...]", {-1, 2});
  rows.expect_finite("points");
  const std::size_t wanted = lengths + std::size_t{!start.input} + std::size_t{!start.output};
  const std::size_t count = rows.size() / 2;
  if (count != wanted) {
    raise_fault("points", fmt::format("are {} for {} starts given; expected {}", count,
                                      lengths + 2 - wanted, wanted));
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

/// With the offset given one condition less.
synthesis::SliderCrankFunctions slider_cranks(const py::object& points, const GivenStart& start,
                                              const py::object& offset) {
  if (offset.is_none()) {
    return synthesis::slider_crank_functions(precision_rows(points, start), start);
  }
  if (start.input && start.output) {
    raise_fault("offset",
                "is given beside both starts; expected input_start, output_start or neither");
  }
  const double value = number_of(offset, "offset");
  return synthesis::slider_crank_functions(precision_rows(points, start, 2), start, value);
}

py::list slider_crank_points(const py::object& points, const py::object& input_start,
                             const py::object& output_start, const py::object& offset) {
  const GivenStart start = starts_of(input_start, output_start);
  const auto found = slider_cranks(points, start, offset);
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

const char* word(RespacingOutcome outcome) {
  switch (outcome) {
    case RespacingOutcome::level:
      return "level";
    case RespacingOutcome::not_alternating:
      return "not-alternating";
    case RespacingOutcome::not_closing:
      return "not-closing";
    case RespacingOutcome::stalled:
      return "stalled";
  }
  return "";
}

/// The four-bar of `links` (4,) with its start angles.
GeneratingFourBar generator_of(const py::object& links, const py::object& input_start,
                               const py::object& output_start, const py::object& assembly) {
  const Numbers lengths(links, "links");
  lengths.expect("links", "(4,), crank, coupler, rocker, frame", {4});
  lengths.expect_finite("links");
  const auto of = lengths.values();
  for (const double length : of) {
    if (!(length > 0))
      raise_fault("links", fmt::format("have {}; lengths above 0 are allowed", length));
  }
  const bool open = word_of(assembly, "assembly", {"open", "crossed"}) == 0;
  return {{of[0], of[1], of[2], of[3]},
          open ? Assembly::open : Assembly::crossed,
          number_of(input_start, "input_start"),
          number_of(output_start, "output_start")};
}

py::dict equal_peaks(const py::object& output, const py::object& interval, const py::object& links,
                     const py::object& input_start, const py::object& output_start,
                     const py::object& assembly, bool input_start_free, bool output_start_free) {
  if (!PyCallable_Check(output.ptr())) {
    raise_fault("output", "is not a function; expected one of the input, both in radians");
  }
  const Numbers range(interval, "interval");
  range.expect("interval", "(2,), first and last input in radians", {2});
  range.expect_finite("interval");
  synthesis::RespacingTask task;
  task.output = [&](double input) { return number_of(output(input), "output(input)"); };
  task.from = range.values()[0];
  task.to = range.values()[1];
  if (task.from == task.to) raise_fault("interval", "is empty; expected two different inputs");
  task.input_start_free = input_start_free;
  task.output_start_free = output_start_free;
  const synthesis::Respacing found =
      synthesis::equal_peaks(task, generator_of(links, input_start, output_start, assembly));
  py::dict all;
  all["outcome"] = word(found.outcome);
  all["links"] = links_array(found.linkage.links);
  all["input_start"] = found.linkage.input_start;
  all["output_start"] = found.linkage.output_start;
  all["greatest"] = found.greatest;
  all["unevenness"] = found.unevenness;
  all["peaks"] = to_array(std::span<const double>(found.peaks));
  all["precision_inputs"] = to_array(std::span<const double>(found.precision_inputs));
  all["exchanges"] = found.exchanges;
  return all;
}

}  // namespace

void bind_exact_functions(py::module_& module) {
  module.def("freudenstein", &freudenstein);
  module.def("precision_points", &precision_points);
  module.def("chebyshev_spacing", &chebyshev);
  module.def("slider_crank_points", &slider_crank_points);
  module.def("equal_peaks", &equal_peaks);
}

}  // namespace cognate::python
