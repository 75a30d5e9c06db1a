#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/evaluation/mechanism_metrics.hpp"
#include "problems/evaluation/type_quantities.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/mechanism/mechanism_types.hpp"

namespace cognate::problems {
namespace {

/// Adds the length that a key of a type holds.
template <class Type>
struct AddLength {
  const Type& dimensions;
  LinkLengths& links;

  void operator()(const LengthKey<Type>& length) const {
    auto& link = length.role == LinkRole::crank     ? links.crank
                 : length.role == LinkRole::coupler ? links.coupler
                                                    : links.rocker;
    link = dimensions.*length.of;
  }
  void operator()(const PivotsKey<Type>& pivots) const {
    links.frame = norm(dimensions.*pivots.second - dimensions.*pivots.first);
  }
  template <class Other>
  void operator()(const Other&) const {}
};

template <class Type>
LinkLengths lengths_of(const Type& dimensions) {
  LinkLengths links;
  for (const auto& key : TypeTraits<Type>::kKeys) {
    std::visit(AddLength<Type>{dimensions, links}, key.holds);
  }
  return links;
}

LinkLengths lengths_of(const ChainDescription& chain) {
  const auto* crank = std::get_if<CrankDescription>(&chain.drive);
  return crank ? LinkLengths{crank->length, {}, {}, {}} : LinkLengths{};
}

std::vector<double> all_of(const LinkLengths& links) {
  std::vector<double> all;
  for (const auto& link : {links.crank, links.coupler, links.rocker, links.frame}) {
    if (link) all.push_back(*link);
  }
  return all;
}

/// Collects the checks of one mechanism that is no four-bar.
class MechanismChecks {
 public:
  MechanismChecks(const NamedMechanism& mechanism, const Metrics& metrics)
      : mechanism_(mechanism), metrics_(metrics), links_(link_lengths(mechanism)) {
    for (const double link : all_of(links_)) longest_ = std::max(longest_, link);
  }

  void lengths(const Bounds& bounds) {
    length("bounds.crank", links_.crank, bounds.crank);
    length("bounds.coupler", links_.coupler, bounds.coupler);
    length("bounds.rocker", links_.rocker, bounds.rocker);
    length("bounds.frame", links_.frame, bounds.frame);
  }

  void pivots(const Bounds& bounds) {
    pivot("A", "bounds.pivot_a", bounds.pivot_a);
    pivot("D", "bounds.pivot_d", bounds.pivot_d);
  }

  void mobility(RequiredClass required) {
    const auto turns = find_quantity(metrics_.quantities, kCrankTurnsKey).value_or(false);
    const auto name = find_quantity(metrics_.quantities, kClassKey).value_or("");
    const bool rigid = name == "no-rotation";
    add("class", name, std::string(to_string(required)), has_class(required, turns, rigid));
  }

  void transmission(const Range& limits) {
    const double above = metrics_.transmission_min - limits.min;
    const double below = limits.max - metrics_.transmission_max;
    const double value = above < below ? metrics_.transmission_min : metrics_.transmission_max;
    add("transmission_angle_deg", degrees(value), Range{degrees(limits.min), degrees(limits.max)},
        std::min(above, below) >= -kCheckTolerance);
  }

  void ratio(double limit) {
    const double value = link_ratio(links_);
    add("link_ratio_max", value, limit, value <= limit * (1 + kCheckTolerance));
  }

  void region(const Box& region) {
    for (const NamedPoint& point : mechanism_.points) {
      if (point.at.body == 0) box("pivot_region." + point.name, point.at.at, region);
    }
  }

  void defect(const std::string& name, Defect defect) {
    const bool is_sound = std::ranges::count(metrics_.defects, defect) == 0;
    add(name, is_sound ? "none" : std::string(to_string(defect)), "none", is_sound);
  }

  std::vector<ConstraintCheck> take() && { return std::move(checks_); }

 private:
  using Value = decltype(ConstraintCheck::value);
  using Bound = decltype(ConstraintCheck::bound);

  static bool has_class(RequiredClass required, bool turns, bool rigid) {
    switch (required) {
      case RequiredClass::crank_rocker:
        return turns;
      case RequiredClass::grashof:
        return !rigid;
      case RequiredClass::triple_rocker:
      case RequiredClass::non_grashof:
        return rigid;
      default:
        return false;
    }
  }

  void add(const std::string& name, Value value, Bound bound, bool satisfied) {
    checks_.push_back({name, std::move(value), std::move(bound), satisfied});
  }

  double allowance(double limit) const {
    const double size = std::isfinite(limit) ? std::abs(limit) : 0;
    return kCheckTolerance * std::max(size, longest_);
  }

  void within(const std::string& name, double value, const Range& range) {
    add(name, value, range,
        value >= range.min - allowance(range.min) && value <= range.max + allowance(range.max));
  }

  void box(const std::string& name, const Vec2d& value, const Box& limits) {
    within(name + ".x", value.x, {limits.min.x, limits.max.x});
    within(name + ".y", value.y, {limits.min.y, limits.max.y});
  }

  void pivot(std::string_view point, const std::string& name, const std::optional<Box>& limits) {
    const auto found = std::ranges::find(mechanism_.points, point, &NamedPoint::name);
    if (!limits || found == mechanism_.points.end() || found->at.body != 0) return;
    box(name, found->at.at, *limits);
  }

  void length(const std::string& name, const std::optional<double>& value,
              const std::optional<Range>& bounds) {
    if (value && bounds) within(name, *value, *bounds);
  }

  const NamedMechanism& mechanism_;
  const Metrics& metrics_;
  LinkLengths links_;
  double longest_ = 0;
  std::vector<ConstraintCheck> checks_;
};

}  // namespace

LinkLengths link_lengths(const NamedMechanism& mechanism) {
  return std::visit([](const auto& dimensions) { return lengths_of(dimensions); },
                    mechanism.description);
}

double link_ratio(const LinkLengths& links) {
  const auto all = all_of(links);
  if (all.size() < 2) return 1;
  const auto [shortest, longest] = std::ranges::minmax(all);
  return shortest > 0 ? longest / shortest : std::numeric_limits<double>::max();
}

std::vector<ConstraintCheck> check_constraints(const Constraints& constraints, const Bounds& bounds,
                                               const NamedMechanism& mechanism,
                                               const Metrics& metrics) {
  if (mechanism.four_bar()) {
    return check_constraints(constraints, bounds, Given{}, *mechanism.four_bar(), metrics);
  }
  MechanismChecks checks(mechanism, metrics);
  checks.lengths(bounds);
  checks.pivots(bounds);
  if (constraints.required_class) checks.mobility(*constraints.required_class);
  if (constraints.transmission_angle) checks.transmission(*constraints.transmission_angle);
  if (constraints.link_ratio_max) checks.ratio(*constraints.link_ratio_max);
  if (constraints.pivot_region) checks.region(*constraints.pivot_region);
  if (constraints.no_branch_defect) checks.defect("no_branch_defect", Defect::branch);
  if (constraints.no_order_defect) checks.defect("no_order_defect", Defect::order);
  if (constraints.no_circuit_defect) checks.defect("no_circuit_defect", Defect::circuit);
  return std::move(checks).take();
}

}  // namespace cognate::problems
