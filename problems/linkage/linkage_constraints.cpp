#include "problems/linkage/linkage_constraints.hpp"

#include <ceres/jet.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

using synthesis::LinkLimit;
using L = Lengths<double>;

/// Solvers keep this much inside the class, in units of `scale`, so that rounding does not take a
/// design out of it again.
constexpr double kClassMargin = 1e-11;

template <class T>
struct Operations {
  static T larger(const T& a, const T& b) { return a < b ? b : a; }
  static T smaller(const T& a, const T& b) { return b < a ? b : a; }
  static T root(const T& a) {
    using std::sqrt;
    return sqrt(a);
  }
  static T is_equal(const T& a, const T& b) { return a == b ? T(1) : T(0); }
};

/// weights · lengths ≥ margin.
LinkLimit half_space(const std::array<double, 4>& weights, double margin) {
  LinkLimit limit{LinkLimit::Kind::linear, {}, 0, margin};
  std::ranges::copy(weights, limit.weights);
  return limit;
}

}  // namespace

bool is_of_class(MobilityClass found, RequiredClass required) {
  switch (required) {
    case RequiredClass::crank_rocker:
      return found == MobilityClass::crank_rocker;
    case RequiredClass::double_crank:
      return found == MobilityClass::double_crank;
    case RequiredClass::rocker_crank:
      return found == MobilityClass::rocker_crank;
    case RequiredClass::double_rocker:
      return found == MobilityClass::double_rocker;
    case RequiredClass::grashof:
      return found != MobilityClass::triple_rocker;
    case RequiredClass::triple_rocker:
    case RequiredClass::non_grashof:
      return found == MobilityClass::triple_rocker;
  }
  return false;
}

std::optional<RequiredClass> confining_class(const Constraints& constraints, const L& start) {
  const auto& required = constraints.required_class;
  const bool is_open = !required || *required == RequiredClass::grashof;
  if (!is_open || !(constraints.transmission_angle || constraints.full_turn)) return required;
  const MobilityClass mobility = mobility_class(start);
  if (mobility == MobilityClass::crank_rocker) return RequiredClass::crank_rocker;
  if (mobility == MobilityClass::double_crank) return RequiredClass::double_crank;
  if (constraints.full_turn) {
    return start.crank < start.frame ? RequiredClass::crank_rocker : RequiredClass::double_crank;
  }
  return required;
}

std::optional<RequiredClass> open_class(const Constraints& constraints, const L& links) {
  const auto& required = constraints.required_class;
  if (required && *required != RequiredClass::grashof) return std::nullopt;
  const MobilityClass mobility = mobility_class(links);
  if (required && !is_of_class(mobility, *required)) return std::nullopt;
  switch (mobility) {
    case MobilityClass::crank_rocker:
      return RequiredClass::crank_rocker;
    case MobilityClass::double_crank:
      return RequiredClass::double_crank;
    case MobilityClass::rocker_crank:
      return RequiredClass::rocker_crank;
    case MobilityClass::double_rocker:
      return RequiredClass::double_rocker;
    case MobilityClass::triple_rocker:
      return RequiredClass::triple_rocker;
    default:
      return std::nullopt;
  }
}

LinkageConstraints::LinkageConstraints(const Constraints& constraints, double scale) {
  if (constraints.required_class) add_class(*constraints.required_class, scale);
  const bool crank_turns = constraints.required_class == RequiredClass::crank_rocker ||
                           constraints.required_class == RequiredClass::double_crank;
  if (constraints.transmission_angle && crank_turns) {
    limits_transmission_ = true;
    const Range& angle = *constraints.transmission_angle;
    limits_.push_back({LinkLimit::Kind::transmission_min, {}, std::cos(angle.min), 0});
    limits_.push_back({LinkLimit::Kind::transmission_max, {}, std::cos(angle.max), 0});
  }
  if (constraints.link_ratio_max) add_link_ratio(*constraints.link_ratio_max, scale);
  if (constraints.proportions) add_proportions(*constraints.proportions, scale);
  const bool is_crank_rocker = constraints.required_class == RequiredClass::crank_rocker;
  if (constraints.time_ratio && is_crank_rocker) add_time_ratio(*constraints.time_ratio);
}

void LinkageConstraints::add_shortest(int shortest, double scale) {
  for (int other = 0; other < 4; ++other) {
    if (other == shortest) continue;
    std::array<double, 4> weights;
    weights.fill(1 / scale);
    weights[shortest] = weights[other] = -1 / scale;
    limits_.push_back(half_space(weights, kClassMargin));
  }
}

void LinkageConstraints::add_class(RequiredClass required, double scale) {
  const auto excess = [&](double sign) {
    // No linkage of a class is a change point of another.
    limits_.push_back({LinkLimit::Kind::grashof_excess, {sign / scale}, 0, kClassMargin});
  };
  switch (required) {
    case RequiredClass::crank_rocker:
      return add_shortest(0, scale);
    case RequiredClass::double_rocker:
      return add_shortest(1, scale);
    case RequiredClass::rocker_crank:
      return add_shortest(2, scale);
    case RequiredClass::double_crank:
      return add_shortest(3, scale);
    case RequiredClass::grashof:
      return excess(-1);
    case RequiredClass::triple_rocker:
    case RequiredClass::non_grashof:
      return excess(1);
  }
}

void LinkageConstraints::add_link_ratio(double ratio, double scale) {
  for (int shorter = 0; shorter < 4; ++shorter) {
    for (int longer = 0; longer < 4; ++longer) {
      if (shorter == longer) continue;
      std::array<double, 4> weights{};
      weights[shorter] = 1 / scale;
      weights[longer] = -1 / (ratio * scale);
      limits_.push_back(half_space(weights, 0));
    }
  }
}

void LinkageConstraints::add_proportions(const std::array<Range, 4>& ranges, double scale) {
  const auto is_given = [](const Range& range) { return range.min == range.max; };
  const auto given = std::ranges::find_if(ranges, is_given) - ranges.begin();
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double min = ranges[i].min, max = ranges[j].max;
      if (i == j || min == 0 || !std::isfinite(max)) continue;
      if (given < 4 && i != given && j != given) continue;
      const double larger = std::max(min, max) * scale;
      std::array<double, 4> weights{};
      weights[i] = max / larger;
      weights[j] = -min / larger;
      limits_.push_back(half_space(weights, 0));
    }
  }
}

void LinkageConstraints::add_time_ratio(const Range& ratio) {
  // K = (π + δ)/(π − δ).
  const auto cosine = [](double k) { return std::cos(kPi * (k - 1) / (k + 1)); };
  if (ratio.min > 1) {
    limits_.push_back({LinkLimit::Kind::time_ratio_min, {}, cosine(ratio.min), 0});
  }
  if (std::isfinite(ratio.max)) {
    limits_.push_back({LinkLimit::Kind::time_ratio_max, {}, cosine(ratio.max), 0});
  }
}

void LinkageConstraints::evaluate(const L& links, std::span<double> values,
                                  std::span<L> gradient) const {
  const double lengths[4] = {links.crank, links.coupler, links.rocker, links.frame};
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const auto at = synthesis::evaluate(limits_[i], lengths, Operations<double>{});
    values[i] = at.value;
    if (!gradient.empty()) gradient[i] = {at.slope[0], at.slope[1], at.slope[2], at.slope[3]};
  }
}

void LinkageConstraints::add_hessian(const L& links, std::span<const double> weights,
                                     std::span<double, 16> out) const {
  using Jet = ceres::Jet<double, 4>;
  const Jet lengths[4] = {
      {links.crank, 0}, {links.coupler, 1}, {links.rocker, 2}, {links.frame, 3}};
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const LinkLimit::Kind kind = limits_[i].kind;
    if (kind == LinkLimit::Kind::linear || kind == LinkLimit::Kind::grashof_excess) continue;
    const auto at = synthesis::evaluate(limits_[i], lengths, Operations<Jet>{});
    for (int j = 0; j < 16; ++j) out[j] += weights[i] * at.slope[j / 4].v[j % 4];
  }
}

}  // namespace cognate::problems
