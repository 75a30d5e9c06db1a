#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/linkage_constraints.hpp"
#include "problems/linkage/linkage_keys.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

double longest(const Lengths<double>& links) {
  return std::max({links.crank, links.coupler, links.rocker, links.frame});
}

double shortest(const Lengths<double>& links) {
  return std::min({links.crank, links.coupler, links.rocker, links.frame});
}

Range in_degrees(const Range& range) {
  return {degrees(range.min), degrees(range.max)};
}

/// By how much `value` lies inside `range`, negative outside; not a number for such a value.
double margin(double value, const Range& range) {
  return std::min(value - range.min, range.max - value);
}

/// Collects the checks of one linkage.
class Checks {
 public:
  explicit Checks(const FourBar& linkage)
      : linkage_(linkage), links_(lengths(linkage)), longest_(longest(links_)) {}

  void check_given(const Given& given) {
    for (const LinkKey& link : kLinkKeys) {
      fixed("mechanism." + std::string(link.key), links_.*link.length, given.*link.given);
    }
    if (given.frame_angle) {
      const double turn = std::remainder(frame_angle(linkage_) - *given.frame_angle, kTurn);
      add("mechanism.frame_angle_deg", degrees(*given.frame_angle + turn),
          degrees(*given.frame_angle), std::abs(turn) <= kCheckTolerance);
    }
    for (const BoundedPlaceKey& of : kPlaceKeys) {
      if (const auto& wanted = given.*of.given) fixed_place(of, *wanted);
    }
    if (given.assembly) {
      add("mechanism.assembly", std::string(to_string(linkage_.assembly)),
          std::string(to_string(*given.assembly)), linkage_.assembly == *given.assembly);
    }
  }

  void check_bounds(const Bounds& bounds) {
    for (const LinkKey& link : kLinkKeys) {
      length("bounds." + std::string(link.key), links_.*link.length, bounds.*link.bounds);
    }
    if (bounds.frame_angle) check_frame_angle(*bounds.frame_angle);
    for (const BoundedPlaceKey& of : kPlaceKeys) {
      const auto& limits = bounds.*of.bounds;
      if (limits) box("bounds." + std::string(of.key), of, place(of), *limits);
    }
  }

  void check_class(RequiredClass required, const Metrics& metrics) {
    add("class", std::string(to_string(metrics.mobility.value())), std::string(to_string(required)),
        is_of_class(metrics.mobility.value(), required));
  }

  void check_full_turn(const Metrics& metrics) {
    add("full_turn", std::string(to_string(metrics.mobility.value())), "crank-rocker, double-crank",
        is_of_class(metrics.mobility.value(), RequiredClass::crank_rocker) ||
            is_of_class(metrics.mobility.value(), RequiredClass::double_crank));
  }

  void check_transmission(const Range& limits, const Metrics& metrics) {
    const double above = metrics.transmission_min - limits.min;
    const double below = limits.max - metrics.transmission_max;
    const double value = above < below ? metrics.transmission_min : metrics.transmission_max;
    add("transmission_angle_deg", degrees(value), in_degrees(limits),
        std::min(above, below) >= -kCheckTolerance);
  }

  void check_link_ratio(double limit) {
    const double ratio = longest_ / shortest(links_);
    add("link_ratio_max", ratio, limit, ratio <= limit * (1 + kCheckTolerance));
  }

  void check_time_ratio(const Range& limits, const std::optional<double>& ratio) {
    if (!ratio) return add("time_ratio", std::string("none"), limits, false);
    add("time_ratio", *ratio, limits,
        *ratio >= limits.min * (1 - kCheckTolerance) &&
            *ratio <= limits.max * (1 + kCheckTolerance));
  }

  void check_clearances(const std::vector<Clearance>& clearances) {
    double allowed = allowance(0);
    for (const Vec2d& pivot : {linkage_.pivot_a, linkage_.pivot_d}) {
      allowed = std::max({allowed, allowance(pivot.x), allowance(pivot.y)});
    }
    for (std::size_t i = 0; i < clearances.size(); ++i) {
      const double distance = clearance_distance(linkage_, clearances[i]);
      add("clearance[" + std::to_string(i + 1) + "]", distance, 0.0, distance >= -allowed);
      checks_.back().missing = std::max(0.0, -distance / longest_);
    }
  }

  /// Where there is a finite limit; a value that is not known is not allowed.
  void check_cycle(const CycleValues& limits, const CycleValues& values) {
    for (const CycleDeclaration& quantity : kCycleQuantities) {
      const auto& limit = limits[quantity.id];
      if (!is_limit(limit)) continue;
      const double reached = values[quantity.id].value_or(kInfinity);
      add(std::string(quantity.limit_key), reached, *limit,
          reached <= *limit * (1 + kCheckTolerance));
    }
  }

  void check_pivot_region(const Box& region) {
    for (const BoundedPlaceKey& pivot : std::span(kPlaceKeys).first<2>()) {
      box("pivot_region." + std::string(pivot.key), pivot, place(pivot), region);
    }
  }

  void check_defect(const std::string& name, Defect defect, const Metrics& metrics) {
    const bool is_sound = std::ranges::count(metrics.defects, defect) == 0;
    add(name, is_sound ? "none" : std::string(to_string(defect)), "none", is_sound);
  }

  std::vector<ConstraintCheck> take() && { return std::move(checks_); }

 private:
  using Value = decltype(ConstraintCheck::value);
  using Bound = decltype(ConstraintCheck::bound);

  void add(const std::string& name, Value value, Bound bound, bool satisfied) {
    checks_.push_back({name, std::move(value), std::move(bound), satisfied});
  }

  /// What a check of `limit` allows, in length units.
  double allowance(double limit) const {
    const double size = std::isfinite(limit) ? std::abs(limit) : 0;
    return kCheckTolerance * std::max(size, longest_);
  }

  bool is_within(double value, const Range& range) const {
    return value >= range.min - allowance(range.min) && value <= range.max + allowance(range.max);
  }

  Vec2d place(const BoundedPlaceKey& of) const {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return of.of(linkage_).value_or(Vec2d{nan, nan});
  }

  void fixed(const std::string& name, double value, const std::optional<double>& wanted) {
    if (!wanted) return;
    add(name, value, *wanted, std::abs(value - *wanted) <= allowance(*wanted));
  }

  void fixed_place(const BoundedPlaceKey& of, const Vec2d& wanted) {
    const std::string name = "mechanism." + std::string(of.key) + '.';
    const Vec2d value = place(of);
    fixed(name + std::string(of.first), value.x, wanted.x);
    fixed(name + std::string(of.second), value.y, wanted.y);
  }

  void length(const std::string& name, double value, const std::optional<Range>& bounds) {
    const bool is_positive = value > kLeastLinkRatio * longest_;
    if (!is_positive && !(bounds && bounds->min > 0)) {
      const double greatest = bounds ? bounds->max : kInfinity;
      add(name, value, Range{kLeastLinkRatio * longest_, greatest}, false);
    } else if (bounds) {
      add(name, value, *bounds, is_within(value, *bounds));
    }
  }

  void box(const std::string& name, const BoundedPlaceKey& of, const Vec2d& value,
           const Box& bounds) {
    const Range x{bounds.min.x, bounds.max.x}, y{bounds.min.y, bounds.max.y};
    add(name + '.' + std::string(of.first), value.x, x, is_within(value.x, x));
    add(name + '.' + std::string(of.second), value.y, y, is_within(value.y, y));
  }

  /// The frame's direction by the turn that brings it nearest to the middle of its range.
  void check_frame_angle(const Range& range) {
    const double middle = std::isfinite(range.max - range.min) ? (range.min + range.max) / 2 : 0;
    const double angle = middle + std::remainder(frame_angle(linkage_) - middle, kTurn);
    add("bounds.frame_angle_deg", degrees(angle), in_degrees(range),
        margin(angle, range) >= -kCheckTolerance);
  }

  const FourBar& linkage_;
  Lengths<double> links_;
  double longest_;
  std::vector<ConstraintCheck> checks_;
};

double relative_distance(double value, double limit) {
  const double size = std::max(std::abs(value), std::abs(limit));
  return size > 0 ? std::abs(value - limit) / size : 0;
}

/// How far the number of a failed check lies from what its bound allows.
double relative_distance(double value, const ConstraintCheck& check) {
  if (const auto* range = std::get_if<Range>(&check.bound)) {
    return relative_distance(value, value < range->min ? range->min : range->max);
  }
  return relative_distance(value, std::get<double>(check.bound));
}

}  // namespace

std::vector<ConstraintCheck> check_constraints(const Constraints& constraints, const Bounds& bounds,
                                               const Given& given, const FourBar& linkage,
                                               const Metrics& metrics) {
  Checks checks(linkage);
  checks.check_given(given);
  checks.check_bounds(bounds);
  if (constraints.required_class) checks.check_class(*constraints.required_class, metrics);
  if (constraints.full_turn) checks.check_full_turn(metrics);
  if (constraints.transmission_angle) {
    checks.check_transmission(*constraints.transmission_angle, metrics);
  }
  if (constraints.link_ratio_max) checks.check_link_ratio(*constraints.link_ratio_max);
  if (constraints.time_ratio) {
    checks.check_time_ratio(*constraints.time_ratio, metrics.time_ratio);
  }
  if (constraints.pivot_region) checks.check_pivot_region(*constraints.pivot_region);
  checks.check_clearances(constraints.clearances);
  checks.check_cycle(constraints.cycle_max, metrics.cycle);
  if (constraints.no_branch_defect) {
    checks.check_defect("no_branch_defect", Defect::branch, metrics);
  }
  if (constraints.no_order_defect) checks.check_defect("no_order_defect", Defect::order, metrics);
  if (constraints.no_circuit_defect) {
    checks.check_defect("no_circuit_defect", Defect::circuit, metrics);
  }
  return std::move(checks).take();
}

bool all_satisfied(std::span<const ConstraintCheck> checks) {
  return std::ranges::all_of(checks, &ConstraintCheck::satisfied);
}

double violation(std::span<const ConstraintCheck> checks) {
  double largest = 0;
  for (const ConstraintCheck& check : checks) {
    if (check.satisfied) continue;
    const auto* number = std::get_if<double>(&check.value);
    const double amount = check.missing.value_or(number ? relative_distance(*number, check) : 1.0);
    // A value that is no number is as far off as can be.
    largest = std::isnan(amount) ? kInfinity : std::max(largest, amount);
  }
  return largest;
}

}  // namespace cognate::problems
