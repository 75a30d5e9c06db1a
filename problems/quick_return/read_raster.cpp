#include "problems/quick_return/read_raster.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "problems/basics/names.hpp"
#include "problems/quick_return/return_raster.hpp"
#include "problems/raster/read.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kRaster = "raster";

std::string_view return_raster_refusal(const QuickReturnProblem& problem) {
  if (problem.crank_pivot_line) {
    return "is given with mechanism.crank_pivot_line, which linkages on a raster cannot meet; "
           "remove one of them";
  }
  if (problem.limit_angle) {
    return "is given with the rocker's angle at a limit, which linkages on a raster cannot meet; "
           "remove one of them";
  }
  const bool has_bar =
      problem.type == QuickReturnType::guide_bar || problem.type == QuickReturnType::shaper;
  if (has_bar && problem.time_ratio == 1) {
    return "is given with target.time_ratio = 1, for which a bar does not swing; expected more "
           "than 1, or no raster";
  }
  return {};
}

std::vector<std::string_view> return_raster_keys(QuickReturnType type) {
  std::vector<std::string_view> keys{"length"};
  for (const ReturnLength length : lengths_of(type)) keys.push_back(to_string(length));
  return keys;
}

/// Faults an open length that the raster says nothing of; false where it does.
bool check_return_rule(TableReader& document, const QuickReturnProblem& problem,
                       ReturnLength length) {
  const std::string_view key = to_string(length);
  if (problem.raster->rule(key) != nullptr) return true;
  const std::string given = length == ReturnLength::bar ? "" : fmt::format(" or mechanism.{}", key);
  document.fault(kRaster, fmt::format("leaves {} free, and a quick return is found on the raster "
                                      "alone; expected raster.{}{}",
                                      key, key, given));
  return false;
}

void check_return_values(TableReader& document, const QuickReturnProblem& problem) {
  const ReturnAxes axes = return_axes(problem);
  for (const synthesis::RasterAxis& axis : axes.axes) {
    if (axis.values.count() > 0) continue;
    document.fault(kRaster, fmt::format("has no last value of {}, or none that its bounds and the "
                                        "other lengths allow; expected bounds.{} = [min, max] with "
                                        "a value of the raster, or a list of values",
                                        axis.name, axis.name));
  }
}

}  // namespace

bool has_raster(const TableReader& document) {
  return document.contains(kRaster);
}

void read_return_bounds(TableReader& bounds, QuickReturnProblem& problem) {
  const auto common = bounds.range("length", kLengthLimit);
  for (const ReturnLength length : lengths_of(problem.type)) {
    const std::string_view key = to_string(length);
    const bool is_offset = length == ReturnLength::offset;
    auto range = bounds.range(key, is_offset ? kCoordinateLimit : kLengthLimit);
    if (range && common && !is_offset) {
      const Range both{std::max(range->min, common->min), std::min(range->max, common->max)};
      if (both.min > both.max) {
        bounds.fault(key, fmt::format("and bounds.length have no length in common; {} must lie in "
                                      "both",
                                      key));
      } else {
        range = both;
      }
    }
    if (!range && !is_offset) range = common;
    problem.raster_bounds[static_cast<std::size_t>(length)] = range;
  }
}

void write_return_bounds(TableWriter& document, const QuickReturnProblem& problem) {
  TableWriter bounds;
  for (const ReturnLength length : lengths_of(problem.type)) {
    bounds.set(to_string(length), problem.raster_bounds[static_cast<std::size_t>(length)]);
  }
  document.set("bounds", bounds);
}

void read_return_raster(TableReader& document, QuickReturnProblem& problem) {
  if (!has_raster(document)) return;
  const std::size_t faults_before = document.faults().size();
  problem.raster =
      read_raster(document, return_raster_keys(problem.type), return_raster_refusal(problem));
  if (!document.contains(kRaster) || document.faults().size() != faults_before) return;
  if (!document.table(kRaster).contains("boxes")) problem.raster->boxes = kReturnBoxes;
  bool is_sound = true, has_any = false;
  for (const ReturnLength length : lengths_of(problem.type)) {
    if (given_length(problem, length)) continue;
    has_any = true;
    is_sound &= check_return_rule(document, problem, length);
  }
  if (!has_any) {
    document.fault(kRaster, "puts no length on a raster that [mechanism] leaves open");
    return;
  }
  if (is_sound) check_return_values(document, problem);
}

}  // namespace cognate::problems::reading
