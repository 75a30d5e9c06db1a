#include "problems/linkage_constraints.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cognate::problems {
namespace {

using synthesis::LinkLimit;
using L = Lengths<double>;
constexpr std::array<double L::*, 4> kLinksOfAFourBar{&L::crank, &L::coupler, &L::rocker,
                                                      &L::frame};

/// Solvers keep this much inside the class, in units of `scale`, so that rounding does not take a
/// design out of it again.
constexpr double kClassMargin = 1e-11;

double linear(const L& weights, const L& links) {
  double sum = 0;
  for (const auto link : kLinksOfAFourBar) sum += weights.*link * links.*link;
  return sum;
}

/// weights · lengths ≥ margin.
LinkLimit half_space(const std::array<double, 4>& weights, double margin) {
  LinkLimit limit{LinkLimit::Kind::linear, {}, 0, margin};
  std::ranges::copy(weights, limit.weights);
  return limit;
}

/// Weights with which shortest + longest − the other two is a sum over the lengths.
L excess_weights(const L& links) {
  auto order = kLinksOfAFourBar;
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return links.*a < links.*b; });
  L weights{-1, -1, -1, -1};
  weights.*order.front() = 1;
  weights.*order.back() = 1;
  return weights;
}

/// cos μ where the diagonal B–D is |l₄ + turn·l₁|, and its gradient.
double transmission_cosine(const L& l, double turn, L& gradient) {
  const double diagonal = l.frame + turn * l.crank;
  const double cosine = (l.coupler * l.coupler + l.rocker * l.rocker - diagonal * diagonal) /
                        (2 * l.coupler * l.rocker);
  const double by_frame = -diagonal / (l.coupler * l.rocker);
  gradient = {turn * by_frame, 1 / l.rocker - cosine / l.coupler, 1 / l.coupler - cosine / l.rocker,
              by_frame};
  return cosine;
}

L negative(const L& g) {
  return {-g.crank, -g.coupler, -g.rocker, -g.frame};
}

}  // namespace

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
    limits_.push_back({LinkLimit::Kind::grashof_excess, {sign / scale}, 0, 0});
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

void LinkageConstraints::evaluate(const L& links, std::span<double> values,
                                  std::span<L> gradient) const {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const LinkLimit& limit = limits_[i];
    L slope{limit.weights[0], limit.weights[1], limit.weights[2], limit.weights[3]};
    switch (limit.kind) {
      case LinkLimit::Kind::linear:
        values[i] = linear(slope, links) - limit.margin;
        break;
      case LinkLimit::Kind::grashof_excess:
        slope = excess_weights(links);
        for (const auto link : kLinksOfAFourBar) slope.*link *= limit.weights[0];
        values[i] = linear(slope, links);
        break;
      case LinkLimit::Kind::transmission_min:
        values[i] = limit.limit_cosine - transmission_cosine(links, -1, slope);
        slope = negative(slope);
        break;
      case LinkLimit::Kind::transmission_max:
        values[i] = transmission_cosine(links, +1, slope) - limit.limit_cosine;
        break;
    }
    if (!gradient.empty()) gradient[i] = slope;
  }
}

}  // namespace cognate::problems
