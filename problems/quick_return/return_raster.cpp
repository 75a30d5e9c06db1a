#include "problems/quick_return/return_raster.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

constexpr ReturnLength kRockerLengths[] = {ReturnLength::crank, ReturnLength::coupler,
                                           ReturnLength::rocker, ReturnLength::frame};
constexpr ReturnLength kSliderLengths[] = {ReturnLength::crank, ReturnLength::coupler,
                                           ReturnLength::offset};
constexpr ReturnLength kGuideLengths[] = {ReturnLength::crank, ReturnLength::frame};
constexpr ReturnLength kShaperLengths[] = {ReturnLength::crank, ReturnLength::frame,
                                           ReturnLength::bar, ReturnLength::rod,
                                           ReturnLength::ram_height};
/// Ratios that agree to so much are equal.
constexpr double kSameRatio = 1e-12;

std::size_t index(ReturnLength length) {
  return static_cast<std::size_t>(length);
}

std::optional<Range> bounds_of(const QuickReturnProblem& problem, ReturnLength length) {
  if (problem.type != QuickReturnType::four_bar) return problem.raster_bounds[index(length)];
  const Bounds& bounds = problem.bounds;
  const std::optional<Range>* const all[] = {&bounds.crank, &bounds.coupler, &bounds.rocker,
                                             &bounds.frame};
  return *all[index(length)];
}

/// The least value of `rule` that is a length.
double least_of(const RasterRule& rule) {
  if (rule.step) return 0.5 * *rule.step;
  const auto first = std::ranges::upper_bound(rule.values, 0.0);
  return first == rule.values.end() ? kInfinity : *first;
}

/// The greatest that a length may be: given, bounded or listed; infinite where nothing says.
double greatest(const QuickReturnProblem& problem, ReturnLength length) {
  if (const auto given = given_length(problem, length)) return *given;
  const auto bounds = bounds_of(problem, length);
  const double most = bounds ? bounds->max : kInfinity;
  const RasterRule* rule = problem.raster->rule(to_string(length));
  const bool is_listed = rule != nullptr && !rule->step;
  return is_listed ? std::min(most, rule->values.back()) : most;
}

/// How far the values of a length reach where its bounds leave them open: by what the others can
/// be. A crank is the shortest link; an offset is shorter than the coupler.
double reach_of(const QuickReturnProblem& problem, ReturnLength length) {
  double reach = kInfinity;
  if (length == ReturnLength::crank) {
    for (const ReturnLength other :
         {ReturnLength::coupler, ReturnLength::rocker, ReturnLength::frame}) {
      if (std::ranges::count(lengths_of(problem.type), other) == 0) continue;
      reach = std::min(reach, greatest(problem, other));
    }
  }
  if (length == ReturnLength::offset) reach = greatest(problem, ReturnLength::coupler);
  if (length == ReturnLength::ram_height) {
    reach = greatest(problem, ReturnLength::bar) + greatest(problem, ReturnLength::rod);
  }
  return reach;
}

synthesis::RasterValues values_of(const QuickReturnProblem& problem, ReturnLength length,
                                  const RasterRule& rule) {
  Range range = bounds_of(problem, length).value_or(Range{-kInfinity, kInfinity});
  if (length != ReturnLength::offset) range.min = std::max(range.min, least_of(rule));
  // Offsets to either side give mirror images.
  if (length == ReturnLength::offset && rule.step && std::isinf(range.min)) range.min = 0;
  const double reach = reach_of(problem, length);
  range = {std::max(range.min, -reach), std::min(range.max, reach)};
  // What no bound ends has no values, which the reader faults.
  const bool is_endless = rule.step && !(std::isfinite(range.min) && std::isfinite(range.max));
  if (is_endless || !(range.min <= range.max)) return {};
  return values_within(rule, range, range);
}

}  // namespace

std::span<const ReturnLength> lengths_of(QuickReturnType type) {
  switch (type) {
    case QuickReturnType::four_bar:
      return kRockerLengths;
    case QuickReturnType::slider_crank:
      return kSliderLengths;
    case QuickReturnType::guide_bar:
      return kGuideLengths;
    case QuickReturnType::shaper:
      break;
  }
  return kShaperLengths;
}

std::optional<double> given_length(const QuickReturnProblem& problem, ReturnLength length) {
  const Given& given = problem.given;
  switch (length) {
    case ReturnLength::crank:
      return given.crank;
    case ReturnLength::coupler:
      return given.coupler;
    case ReturnLength::rocker:
      return given.rocker;
    case ReturnLength::frame:
      return given.frame;
    case ReturnLength::offset:
      return problem.offset;
    case ReturnLength::rod:
      return problem.rod;
    case ReturnLength::ram_height:
      return problem.ram_height;
    case ReturnLength::bar:
      break;
  }
  return std::nullopt;
}

ReturnAxes return_axes(const QuickReturnProblem& problem) {
  ReturnAxes all;
  for (const ReturnLength length : lengths_of(problem.type)) {
    const std::string name(to_string(length));
    const RasterRule* rule = problem.raster->rule(name);
    if (given_length(problem, length) || rule == nullptr) continue;
    all.lengths.push_back(length);
    all.axes.push_back({name, values_of(problem, length, *rule)});
  }
  return all;
}

ReturnRaster::ReturnRaster(const QuickReturnProblem& problem)
    : problem_(problem), axes_(return_axes(problem)) {
  for (const ReturnLength length : lengths_of(problem.type)) {
    const double given = given_length(problem, length).value_or(0);
    given_[index(length)] = {given, given};
  }
}

double ReturnRaster::bound(const synthesis::RasterBox& box) const {
  ReturnRanges ranges = given_;
  for (std::size_t i = 0; i < axes_.lengths.size(); ++i) {
    const auto& values = axes_.axes[i].values;
    ranges[index(axes_.lengths[i])] = {values.at(box.first[i]), values.at(box.last[i])};
  }
  return least_error(ranges);
}

ReturnLengths ReturnRaster::lengths(const synthesis::RasterNumbers& at) const {
  ReturnLengths all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = given_[i].min;
  for (std::size_t i = 0; i < axes_.lengths.size(); ++i) {
    all[index(axes_.lengths[i])] = axes_.axes[i].values.at(at[i]);
  }
  return all;
}

synthesis::RasterNumbers ReturnRaster::nearest(const ReturnLengths& between) const {
  synthesis::RasterNumbers at;
  for (std::size_t i = 0; i < axes_.lengths.size(); ++i) {
    at.push_back(axes_.axes[i].values.nearest(between[index(axes_.lengths[i])]));
  }
  return at;
}

std::optional<synthesis::RasterMerit> ReturnRaster::evaluate(
    const synthesis::RasterNumbers& at) const {
  return merit(lengths(at));
}

bool ReturnRaster::accepts(const synthesis::RasterNumbers& at) const {
  const auto made = design(lengths(at));
  return made && all_satisfied(made->constraints);
}

bool ReturnRaster::is_same(const synthesis::RasterNumbers& a,
                           const synthesis::RasterNumbers& b) const {
  return is_same_design(lengths(a), lengths(b));
}

double distance_from(const Range& range, double wanted) {
  return std::max({0.0, range.min - wanted, wanted - range.max});
}

bool are_proportional(std::span<const double> a, std::span<const double> b) {
  const double ratio = a[0] / b[0];
  for (std::size_t i = 1; i < a.size(); ++i) {
    if (std::abs(a[i] - ratio * b[i]) > kSameRatio * std::abs(a[i])) return false;
  }
  return true;
}

std::unique_ptr<ReturnRaster> return_raster(const QuickReturnProblem& problem) {
  switch (problem.type) {
    case QuickReturnType::four_bar:
      return rocker_raster(problem);
    case QuickReturnType::slider_crank:
      return slider_raster(problem);
    case QuickReturnType::guide_bar:
      return guide_raster(problem);
    case QuickReturnType::shaper:
      break;
  }
  return shaper_raster(problem);
}

}  // namespace cognate::problems
