#include "problems/tolerance/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "problems/tolerance/keys.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr int kMostSamples = 10'000'000;

constexpr NumberRule kDeviation{[](double x) { return x >= 0 && is_magnitude(x); },
                                "a length, 0 or from 1e-100 to 1e100"};
constexpr NumberRule kValue{
    kDeviation.accepts,
    "a length, 0 or from 1e-100 to 1e100, {plus, minus}, or a grade as \"IT8\" or \"m\""};
constexpr NumberRule kCost{is_positive_magnitude, "a factor from 1e-100 to 1e100"};
constexpr NumberRule kErrorLimit{is_positive_magnitude, "an error from 1e-100 to 1e100"};

std::optional<ToleranceValue> read_value(TableReader& table, std::string_view key) {
  if (!table.has(key)) return std::nullopt;
  if (table.has_text(key)) {
    if (const auto grade = table.choice<ToleranceGrade>(key)) return *grade;
    return std::nullopt;
  }
  if (table.has_table(key)) {
    TableReader sides = table.table(key);
    const Deviation deviation{sides.number("plus", kDeviation).value_or(0),
                              sides.number("minus", kDeviation).value_or(0)};
    if (!sides.has("plus") && !sides.has("minus")) {
      table.fault(key, "is an empty table; expected {plus, minus}");
    }
    sides.finish();
    return deviation;
  }
  if (const auto both = table.number(key, kValue)) return Deviation{*both, *both};
  return std::nullopt;
}

void read_grade(TableReader& table, Tolerances& tolerances) {
  if (!table.has(kGrade)) return;
  const auto grade = table.choice<ToleranceGrade>(kGrade);
  if (table.has(kLengthTolerance)) {
    table.fault(kGrade,
                "is given beside tolerance.length; give one of them, and single "
                "dimensions by their names");
  } else if (grade) {
    tolerances.length = *grade;
  }
}

void read_clearances(TableReader& table, const ToleranceScope& scope, Tolerances& tolerances) {
  if (!table.has(kPinClearance)) return;
  TableReader pins = table.table(kPinClearance);
  for (const std::string& joint : scope.joints) {
    if (const auto radial = pins.number(joint, kDeviation)) {
      tolerances.clearances.push_back({joint, *radial});
    }
  }
  if (scope.joints.empty()) {
    table.fault(kPinClearance, "is given where no pin has a name; remove it");
    return;
  }
  pins.finish();
}

/// The limit of an error, under `key` of a length and under that with "_deg" of an angle.
std::optional<double> read_error_limit(TableReader& table, std::string_view key,
                                       const ToleranceScope& scope) {
  const std::string of_angle = fmt::format("{}_deg", key);
  const bool angle = scope.unit == "deg";
  const std::string_view right = angle ? of_angle : key, other = angle ? key : of_angle;
  if (table.has(other)) {
    table.fault(other,
                fmt::format("is of {} here; expected {}", angle ? "an angle" : "a length", right));
  } else if (!table.has(right)) {
    table.fault(right, "is missing; expected the error that must not be exceeded");
  }
  return table.number(right, kErrorLimit);
}

void read_yield(TableReader& table, const ToleranceScope& scope, Tolerances& tolerances) {
  if (!table.has(kYield)) return;
  TableReader limits = table.table(kYield);
  if (!table.has_table(kYield)) return;
  tolerances.max_error = read_error_limit(limits, "max_error", scope);
  limits.finish();
  if (tolerances.samples == 0) {
    table.fault(kYield, fmt::format("is a share of samples, of which there are none; expected {} "
                                    "above 0, or no yield",
                                    table.name(kSampleCount)));
  }
}

void read_allocation(TableReader& table, const ToleranceScope& scope, Tolerances& tolerances) {
  if (!table.has(kAllocate)) return;
  TableReader keys = table.table(kAllocate);
  if (!table.has_table(kAllocate)) return;
  Allocation allocation;
  allocation.limit = read_error_limit(keys, "limit", scope).value_or(allocation.limit);
  allocation.basis = keys.choice<AllocationBasis>("by").value_or(allocation.basis);
  TableReader costs = keys.table("cost");
  std::vector<std::string> named = scope.dimensions;
  if (scope.has_pivots) named.emplace_back(kPivotTolerance);
  for (const std::string& dimension : named) {
    if (const auto factor = costs.number(dimension, kCost)) {
      allocation.costs.push_back({dimension, *factor});
    }
  }
  costs.finish();
  keys.finish();
  tolerances.allocation = std::move(allocation);
}

void read_judged(TableReader& table, const ToleranceScope& scope, Tolerances& tolerances) {
  if (scope.points.empty() || !table.has(kJudged)) return;
  const std::vector<std::string_view> allowed(scope.points.begin(), scope.points.end());
  if (const auto place = table.choice_of(kJudged, allowed)) tolerances.of = scope.points[*place];
}

/// A dimension whose name is a key of the table itself cannot be named.
bool is_own_key(std::string_view name) {
  return std::ranges::any_of(kToleranceKeys,
                             [&](const ToleranceKey& key) { return key.name == name; });
}

bool has_tolerance(const ToleranceValue& value) {
  const auto* deviation = std::get_if<Deviation>(&value);
  return deviation == nullptr || deviation->plus > 0 || deviation->minus > 0;
}

void check_says_something(TableReader& table, const Tolerances& tolerances) {
  const bool any =
      (tolerances.length && has_tolerance(*tolerances.length)) ||
      (tolerances.pivots && has_tolerance(*tolerances.pivots)) ||
      std::ranges::any_of(tolerances.dimensions,
                          [](const NamedTolerance& of) { return has_tolerance(of.value); }) ||
      std::ranges::any_of(tolerances.clearances,
                          [](const PinClearance& pin) { return pin.radial > 0; });
  if (any) return;
  table.faults().add(table.where(),
                     "[tolerance] lets nothing vary; expected length, a dimension, "
                     "pivots, grade or clearance");
}

}  // namespace

ToleranceScope four_bar_scope() {
  return {.dimensions = {"crank", "coupler", "rocker", "frame", "coupler_point"},
          .joints = {"A", "B", "C", "D"},
          .points = {}};
}

ToleranceScope slider_crank_scope() {
  return {.dimensions = {"crank", "coupler", "offset"}, .joints = {"A", "B", "C"}, .points = {}};
}

ToleranceScope guide_bar_scope() {
  return {.dimensions = {"crank", "frame", "offset"}, .joints = {"A", "B", "D"}, .points = {}};
}

std::optional<Tolerances> read_tolerances(TableReader& document, const ToleranceScope& scope) {
  if (!document.has(kToleranceTable)) return std::nullopt;
  const std::size_t before = document.faults().size();
  TableReader table = document.table(kToleranceTable);
  Tolerances tolerances;
  tolerances.length = read_value(table, kLengthTolerance);
  read_grade(table, tolerances);
  if (scope.has_pivots) tolerances.pivots = read_value(table, kPivotTolerance);
  for (const std::string& dimension : scope.dimensions) {
    if (is_own_key(dimension)) continue;
    if (auto value = read_value(table, dimension)) {
      tolerances.dimensions.push_back({dimension, *value});
    }
  }
  read_clearances(table, scope, tolerances);
  read_judged(table, scope, tolerances);
  ToleranceScope judged = scope;
  if (!tolerances.of.empty()) judged.unit = "length";
  tolerances.distribution =
      table.choice<ToleranceDistribution>(kDistribution).value_or(tolerances.distribution);
  tolerances.samples = table.integer(kSampleCount, 0, kMostSamples).value_or(tolerances.samples);
  if (scope.has_error) {
    read_yield(table, judged, tolerances);
    read_allocation(table, judged, tolerances);
  }
  table.finish();
  if (table.faults().size() == before) check_says_something(table, tolerances);
  return tolerances;
}

void fault_impossible(TableReader& document, std::string_view group, std::string_view reason) {
  TableReader table = document.table(kToleranceTable);
  const std::string what = fmt::format("cannot be met: {}", reason);
  for (const std::string_view key : {group, kLengthTolerance, kGrade}) {
    if (!key.empty() && table.has(key)) return table.fault(key, what);
  }
  document.fault(kToleranceTable, what);
}

}  // namespace cognate::problems::reading
