#include "problems/quick_return/raster.hpp"

#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/raster/report.hpp"

namespace cognate::problems {
namespace {

using synthesis::RasterPoint;

std::size_t place(ReturnLength length) {
  return static_cast<std::size_t>(length);
}

/// What a four-bar and a guide-bar miss is an angle; a stroke counts relative to it.
bool is_angle(QuickReturnType type) {
  return type == QuickReturnType::four_bar || type == QuickReturnType::guide_bar;
}

RasterMeasure return_measure(QuickReturnType type) {
  if (is_angle(type)) return {[](double error) { return degrees(error); }, "error_deg"};
  return {[](double error) { return error; }, "error_relative"};
}

RasterPoint point_of(double error) {
  RasterPoint point;
  point.objective = error;
  return point;
}

/// The lengths of an exact design; what cannot be read off it is that of `best`.
ReturnLengths lengths_of_design(const Design& design, const ReturnLengths& best) {
  ReturnLengths all = best;
  const auto set = [&](ReturnLength length, double value) { all[place(length)] = value; };
  if (const FourBar* four_bar = design.mechanism.four_bar()) {
    const Lengths<double> links = lengths(*four_bar);
    set(ReturnLength::crank, links.crank);
    set(ReturnLength::coupler, links.coupler);
    set(ReturnLength::rocker, links.rocker);
    set(ReturnLength::frame, links.frame);
  } else if (const auto* slider = std::get_if<SliderCrank>(&design.mechanism.description)) {
    set(ReturnLength::crank, slider->crank);
    set(ReturnLength::coupler, slider->coupler);
    set(ReturnLength::offset, slider->offset);
  } else if (const auto* guide = std::get_if<GuideBar>(&design.mechanism.description)) {
    set(ReturnLength::crank, guide->crank);
    set(ReturnLength::frame, norm(guide->pivot_a - guide->pivot_c));
  }
  return all;
}

/// Crank and bar of the shaper that does the task with the frame of `best`.
ReturnLengths exact_shaper(const QuickReturnProblem& problem, ReturnLengths best) {
  const double half_sine = synthesis::return_angle(problem.time_ratio).half_sine;
  best[place(ReturnLength::crank)] = best[place(ReturnLength::frame)] * half_sine;
  best[place(ReturnLength::bar)] = 0.5 * *problem.stroke / half_sine;
  return best;
}

/// In the form of other searches on a raster; `exact` and its rounding beside the best.
synthesis::RasterResult comparison(const QuickReturnProblem& problem,
                                   const ReturnRasterAnswer& answer,
                                   const std::vector<Design>& exact) {
  const synthesis::BoundedRasterResult& search = answer.search;
  synthesis::RasterResult found;
  found.combinations = search.combinations;
  found.covered = search.covered;
  found.evaluated = search.evaluated;
  found.boxes = search.boxes;
  found.bound = search.bound;
  found.is_complete = found.is_enumerated = search.is_complete;
  for (const auto& kept : search.best) found.designs.push_back(point_of(kept.merit.error));
  if (exact.empty()) return found;
  found.relaxed = point_of(0);
  const auto raster = return_raster(problem);
  const ReturnLengths between = problem.type == QuickReturnType::shaper
                                    ? exact_shaper(problem, answer.best)
                                    : lengths_of_design(exact.front(), answer.best);
  const synthesis::RasterNumbers at = raster->nearest(between);
  if (const auto merit = raster->evaluate(at)) {
    found.rounded = point_of(merit->error);
    found.rounded_is_accepted = raster->accepts(at);
  }
  return found;
}

std::string coverage_of_returns(const synthesis::BoundedRasterResult& search) {
  if (!search.is_complete) {
    return fmt::format(
        "{:.6g} of {:.6g} combinations on the raster are covered, {} of them evaluated; "
        "raster.boxes ended the search at {} boxes, or its time did.",
        search.covered, search.combinations, search.evaluated, search.boxes);
  }
  return fmt::format(
      "No {} on the raster is better: of its {:.6g} combinations {} were evaluated, the others are "
      "excluded by bounds of their error and limits.",
      search.best.empty() ? "combination meets every constraint, so none" : "other combination",
      search.combinations, search.evaluated);
}

std::string comparison_of_returns(const QuickReturnProblem& problem,
                                  const synthesis::RasterResult& found) {
  const RasterMeasure measure = return_measure(problem.type);
  const std::string unit = is_angle(problem.type) ? " degrees" : "";
  const std::string of = problem.type == QuickReturnType::four_bar ? "of theta and swing"
                         : problem.type == QuickReturnType::guide_bar
                             ? "of theta"
                             : "of theta (radians) and stroke (relative)";
  std::string text = fmt::format("Largest error {} on the raster {:.6g}{}", of,
                                 measure.of(found.designs.front().objective), unit);
  if (!found.relaxed) return text + "; no such mechanism meets them exactly.";
  text += found.rounded ? fmt::format("; the exact design rounded has {:.6g}{}{}",
                                      measure.of(found.rounded->objective), unit,
                                      found.rounded_is_accepted ? "" : " and breaks a constraint")
                        : "; the exact design cannot be rounded";
  return text + ".";
}

}  // namespace

ReturnRasterAnswer search_return_raster(const QuickReturnProblem& problem, const Run& run,
                                        const Deadline& deadline) {
  const auto raster = return_raster(problem);
  ReturnRasterAnswer answer;
  answer.search = synthesis::search_bounded_raster(
      *raster, {.designs = static_cast<std::size_t>(problem.solve.designs),
                .most_boxes = static_cast<std::uint64_t>(problem.raster->boxes),
                .deadline = &deadline,
                .progress = run.progress});
  for (const auto& kept : answer.search.best) {
    const ReturnLengths at = raster->lengths(kept.at);
    if (answer.designs.empty()) answer.best = at;
    Design design = *raster->design(at);
    design.origin = "raster";
    // Nothing was solved for.
    design.metrics.precision_residual.reset();
    design.metrics.condition.reset();
    answer.designs.push_back(std::move(design));
  }
  return answer;
}

QuickReturnProblem exact_problem(const QuickReturnProblem& problem, const ReturnLengths& best) {
  QuickReturnProblem exact = problem;
  exact.raster.reset();
  exact.raster_bounds = {};
  exact.solve.designs = 1;
  exact.given = {};
  if (problem.type == QuickReturnType::four_bar) {
    exact.given.rocker = best[place(ReturnLength::rocker)];
    if (problem.given.crank) {
      exact.given.crank = problem.given.crank;
    } else if (problem.given.coupler) {
      exact.given.coupler = problem.given.coupler;
    } else {
      exact.given.frame = problem.given.frame;
    }
  } else if (problem.type == QuickReturnType::slider_crank) {
    if (!problem.offset) {
      exact.given.crank = problem.given.crank;
      if (!exact.given.crank) exact.given.coupler = problem.given.coupler;
    }
  } else if (problem.given.crank && problem.type == QuickReturnType::guide_bar) {
    exact.given.crank = problem.given.crank;
  } else {
    exact.given.frame = best[place(ReturnLength::frame)];
    exact.rod = best[place(ReturnLength::rod)];
    exact.ram_height = best[place(ReturnLength::ram_height)];
  }
  return exact;
}

void tell_return_raster(const QuickReturnProblem& problem, const ReturnRasterAnswer& answer,
                        const std::vector<Design>& exact, Result& result) {
  const synthesis::RasterResult found = comparison(problem, answer, exact);
  result.designs = answer.designs;
  result.quantities = raster_quantities(found, return_measure(problem.type));
  result.notes.push_back(coverage_of_returns(answer.search));
  if (!found.designs.empty()) result.notes.push_back(comparison_of_returns(problem, found));
}

}  // namespace cognate::problems
