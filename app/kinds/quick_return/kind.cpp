#include "app/kinds/quick_return/kind.hpp"

#include <fmt/core.h>

#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"

namespace cognate::app {
namespace {

using problems::QuickReturnProblem;

constexpr Entry kQuickReturn[] = {
    {"target.time_ratio", "time of the advance over that of the return, from 1"},
    {"mechanism.type", "\"four-bar\" (default), \"slider-crank\", \"guide-bar\" or \"shaper\""},
    {"mechanism.rocker", "four-bar: its length"},
    {"mechanism.swing_deg", "four-bar: of the rocker"},
    {"mechanism.crank",
     "its length: at most one of crank, coupler, frame, crank_pivot_line, outer_limit_deg, "
     "inner_limit_deg; none: best transmission"},
    {"mechanism.coupler", "likewise"},
    {"mechanism.frame", "likewise; guide-bar and shaper: between the pivots"},
    {"mechanism.crank_pivot_line", "likewise: [a, b, c], a x + b y = c"},
    {"mechanism.outer_limit_deg",
     "likewise: the rocker's angle at its outer limit, from A to D; with frame in place of "
     "swing_deg"},
    {"mechanism.inner_limit_deg", "likewise: at its inner limit"},
    {"mechanism.stroke", "slider-crank and shaper: of the slider"},
    {"mechanism.offset", "slider-crank: of the slide line; guide-bar: of the guide"},
    {"mechanism.rod", "shaper: from the guide to the ram"},
    {"mechanism.ram_height", "shaper: of the ram's line above the guide's pivot"},
    {"constraints.pressure_angle_deg_max", "slider-crank and shaper"},
    {"bounds.crank",
     "with [raster]: [min, max] of crank, coupler, rocker, frame, offset, bar, rod, ram_height as "
     "the type has them; length: of all"}};

constexpr QuantityColumn kQuickReturnQuantities[] = {{"swing_deg", "swing [deg]"},
                                                     {"stroke", "stroke [length]"},
                                                     {"pressure_angle_deg", "pressure [deg]"}};

}  // namespace

std::span<const Entry> Kind<QuickReturnProblem>::keys() {
  return kQuickReturn;
}

std::string Kind<QuickReturnProblem>::describe(const QuickReturnProblem& problem) {
  // Of the crank, between the positions in which the output turns back.
  const double theta = 180 * (problem.time_ratio - 1) / (problem.time_ratio + 1);
  return titled(problem.title, fmt::format("quick return, time ratio {} (theta = {:.6g} deg)",
                                           problem.time_ratio, theta));
}

ColumnChoice Kind<QuickReturnProblem>::columns(const QuickReturnProblem& /*problem*/) {
  return {.quantities = kQuickReturnQuantities};
}

nlohmann::ordered_json Kind<QuickReturnProblem>::target_json(
    const QuickReturnProblem& /*problem*/) {
  return {{"kind", "quick-return"}};
}

}  // namespace cognate::app
