#include "problems/search/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"

namespace cognate::problems {
namespace {

double transmission_angle(const Design& design) {
  return design.metrics.transmission_acute_min;
}

bool limit_transmission_angle(DesignLimits& limits, double least) {
  const Range any{0, kPi};
  auto& range = limits.constraints.transmission_angle;
  range = Range{std::max(range.value_or(any).min, least),
                std::min(range.value_or(any).max, kPi - least)};
  return range->min < range->max;
}

double longest_link(const Design& design) {
  const auto links = lengths(four_bar(design));
  return std::max({links.crank, links.coupler, links.rocker, links.frame});
}

double link_ratio(const Design& design) {
  const auto links = lengths(four_bar(design));
  return longest_link(design) / std::min({links.crank, links.coupler, links.rocker, links.frame});
}

bool limit_link_ratio(DesignLimits& limits, double greatest) {
  auto& ratio = limits.constraints.link_ratio_max;
  ratio = std::min(ratio.value_or(greatest), greatest);
  return *ratio >= 1;
}

bool limit_size(DesignLimits& limits, double greatest) {
  const Range any{0, std::numeric_limits<double>::infinity()};
  for (const auto bound : {&Bounds::crank, &Bounds::coupler, &Bounds::rocker, &Bounds::frame}) {
    auto& range = limits.bounds.*bound;
    range = Range{range.value_or(any).min, std::min(range.value_or(any).max, greatest)};
    if (!(range->min <= range->max)) return false;
  }
  return true;
}

/// The value of what a design was not asked for is no better than any.
double value_or_worst(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::infinity());
}

/// A metric of a finished design.
template <std::optional<double> Metrics::*Metric>
double metric_of(const Design& design) {
  return value_or_worst(design.metrics.*Metric);
}

/// Keeps `limit` to `greatest`.
bool tighten(std::optional<double>& limit, double greatest) {
  limit = std::min(limit.value_or(greatest), greatest);
  return *limit > 0;
}

template <std::optional<double> Constraints::*Limit>
bool limit_metric(DesignLimits& limits, double greatest) {
  return tighten(limits.constraints.*Limit, greatest);
}

constexpr MeasureRule kRules[] = {
    {Measure::transmission_angle, "transmission_angle_deg.acute_min",
     "the least acute transmission angle", true, kRightAngle, false, transmission_angle,
     limit_transmission_angle},
    {Measure::link_ratio, "link_ratio", "the ratio of the longest to the shortest link", false, 1,
     true, link_ratio, limit_link_ratio},
    {Measure::size, "longest_link", "the longest link", false, 0, true, longest_link, limit_size},
    {Measure::peak_acceleration, "peak_acceleration", "the peak acceleration", false, 0, false,
     metric_of<&Metrics::peak_acceleration>, limit_metric<&Constraints::peak_acceleration_max>},
    {Measure::torque_ripple, "torque_ripple", "the ripple of the driving torque", false, 0, false,
     metric_of<&Metrics::torque_ripple>, limit_metric<&Constraints::torque_ripple_max>},
    {Measure::speed_fluctuation, "speed_fluctuation", "the fluctuation of the speed", false, 0,
     false, metric_of<&Metrics::speed_fluctuation>,
     limit_metric<&Constraints::speed_fluctuation_max>},
    {Measure::flywheel_inertia, "flywheel_inertia", "the inertia of the flywheel", false, 0, false,
     metric_of<&Metrics::flywheel_inertia>, limit_metric<&Constraints::flywheel_inertia_max>},
    {Measure::motor_power, "motor_power", "the greatest power of the drive", false, 0, false,
     metric_of<&Metrics::motor_power>, limit_metric<&Constraints::motor_power_max>}};

}  // namespace

double MeasureRule::level(double value) const {
  return greatest_is_best ? value : -std::log(value);
}

double MeasureRule::value_at(double level) const {
  return greatest_is_best ? level : std::exp(-level);
}

double MeasureRule::shown(double value) const {
  return column.find("_deg") != std::string_view::npos ? degrees(value) : value;
}

const MeasureRule& rule_of(Measure measure) {
  return *std::ranges::find(kRules, measure, &MeasureRule::measure);
}

}  // namespace cognate::problems
