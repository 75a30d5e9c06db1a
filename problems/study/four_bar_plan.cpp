#include "problems/study/four_bar_plan.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/read.hpp"

namespace cognate::problems {
namespace {

/// So many that those of a range of the crank are soon looked through.
constexpr double kMostTurns = 100;

/// The analysis of the base file, where it is one of a four-bar over a whole turn,
/// within some turns of 0.
std::optional<AnalysisProblem> four_bar_base(const Study& study) {
  auto analysis = parse_task<AnalysisProblem>(study.base_text);
  if (!analysis || !analysis->mechanism.four_bar()) return std::nullopt;
  const DriveSweep& drive = analysis->drive;
  const bool whole = std::abs(drive.end - drive.start) >= kTurn * (1 - 1e-12);
  const bool near = std::max(std::abs(drive.start), std::abs(drive.end)) <= kMostTurns * kTurn;
  return whole && near ? std::optional(*std::move(analysis)) : std::nullopt;
}

}  // namespace

bool FourBarPlan::wants(FourBarStage from, FourBarStage to) const {
  const auto is_in = [&](const FourBarQuantity& quantity) {
    return quantity.stage >= from && quantity.stage <= to;
  };
  return std::ranges::any_of(columns, is_in) ||
         std::ranges::any_of(filters, is_in, &FourBarFilter::quantity);
}

std::optional<FourBarPlan> four_bar_plan(const Study& study) {
  auto base = four_bar_base(study);
  if (!base || study.variables.empty()) return std::nullopt;
  FourBarPlan plan{.base = *std::move(base)};
  const bool has_point = plan.linkage().coupler_point.has_value();
  const auto add = [&](std::string_view name) {
    const auto quantity = four_bar_quantity(study, name, has_point);
    if (quantity && quantity->quantity == FourBarQuantityId::output_swing) plan.wants_swing = true;
    return quantity;
  };
  for (const StudyVariable& variable : study.variables) {
    const auto dimension = four_bar_dimension(variable.path);
    if (!dimension) return std::nullopt;
    plan.dimensions.push_back(*dimension);
  }
  for (const std::string& column : study_columns(study)) {
    const auto quantity = add(column);
    if (!quantity) return std::nullopt;
    plan.columns.push_back(*quantity);
  }
  for (const StudyFilter& filter : study.filters) {
    const auto quantity = add(filter.name);
    if (!quantity) return std::nullopt;
    plan.filters.push_back({*quantity, &filter});
  }
  std::ranges::stable_sort(plan.filters, {},
                           [](const FourBarFilter& filter) { return filter.quantity.stage; });
  return plan;
}

bool has_closed_row(const DriveSweep& drive, const FourBar& linkage) {
  const double frame = frame_angle(linkage);
  const double step = (drive.end - drive.start) / drive.steps;
  const auto [least, greatest] = std::minmax(drive.start, drive.end);
  for (const CrankRange& range : crank_ranges(lengths(linkage))) {
    const double last = std::floor((greatest - frame - range.from) / kTurn);
    for (double turn = std::ceil((least - frame - range.to) / kTurn); turn <= last; ++turn) {
      const double from = (range.from + frame + turn * kTurn - drive.start) / step;
      const double to = (range.to + frame + turn * kTurn - drive.start) / step;
      const double first = std::max(std::ceil(std::min(from, to)), 0.0);
      if (first <= std::max(from, to) && first <= drive.steps) return true;
    }
  }
  return false;
}

}  // namespace cognate::problems
