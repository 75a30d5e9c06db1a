#include "problems/linkage_constraints.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/mobility.hpp"

namespace cognate::problems {
namespace {

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

std::optional<RequiredClass> confining_class(const Constraints& constraints, const L& start) {
  const auto& required = constraints.required_class;
  const bool is_open = !required || *required == RequiredClass::grashof;
  if (!is_open || !constraints.transmission_angle) return required;
  const MobilityClass mobility = mobility_class(start);
  if (mobility == MobilityClass::crank_rocker) return RequiredClass::crank_rocker;
  if (mobility == MobilityClass::double_crank) return RequiredClass::double_crank;
  return required;
}

LinkageConstraints::LinkageConstraints(const Constraints& constraints, double scale) {
  if (constraints.required_class) add_class(*constraints.required_class, scale);
  const bool crank_turns = constraints.required_class == RequiredClass::crank_rocker ||
                           constraints.required_class == RequiredClass::double_crank;
  if (constraints.transmission_angle && crank_turns) {
    limits_transmission_ = true;
    terms_.push_back({Kind::transmission_min, {}, std::cos(constraints.transmission_angle->min)});
    terms_.push_back({Kind::transmission_max, {}, std::cos(constraints.transmission_angle->max)});
  }
  if (constraints.link_ratio_max) add_link_ratio(*constraints.link_ratio_max, scale);
}

void LinkageConstraints::add_shortest(double L::*shortest, double scale) {
  for (const auto other : kLinksOfAFourBar) {
    if (other == shortest) continue;
    L weights{1 / scale, 1 / scale, 1 / scale, 1 / scale};
    weights.*shortest = weights.*other = -1 / scale;
    terms_.push_back({Kind::linear, weights, 0, kClassMargin});
  }
}

void LinkageConstraints::add_class(RequiredClass required, double scale) {
  switch (required) {
    case RequiredClass::crank_rocker:
      return add_shortest(&L::crank, scale);
    case RequiredClass::double_crank:
      return add_shortest(&L::frame, scale);
    case RequiredClass::rocker_crank:
      return add_shortest(&L::rocker, scale);
    case RequiredClass::double_rocker:
      return add_shortest(&L::coupler, scale);
    case RequiredClass::grashof:
      terms_.push_back({Kind::grashof_excess, {-1 / scale, 0, 0, 0}, 0});
      return;
    case RequiredClass::triple_rocker:
    case RequiredClass::non_grashof:
      terms_.push_back({Kind::grashof_excess, {1 / scale, 0, 0, 0}, 0});
      return;
  }
}

void LinkageConstraints::add_link_ratio(double ratio, double scale) {
  for (const auto shorter : kLinksOfAFourBar) {
    for (const auto longer : kLinksOfAFourBar) {
      if (shorter == longer) continue;
      L weights{};
      weights.*shorter = 1 / scale;
      weights.*longer = -1 / (ratio * scale);
      terms_.push_back({Kind::linear, weights, 0});
    }
  }
}

void LinkageConstraints::evaluate(const L& links, std::span<double> values,
                                  std::span<L> gradient) const {
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Term& term = terms_[i];
    L slope = term.weights;
    switch (term.kind) {
      case Kind::linear:
        values[i] = linear(slope, links);
        break;
      case Kind::grashof_excess:
        slope = excess_weights(links);
        for (const auto link : kLinksOfAFourBar) slope.*link *= term.weights.crank;
        values[i] = linear(slope, links);
        break;
      case Kind::transmission_min:
        values[i] = term.limit_cosine - transmission_cosine(links, -1, slope);
        slope = negative(slope);
        break;
      case Kind::transmission_max:
        values[i] = transmission_cosine(links, +1, slope) - term.limit_cosine;
        break;
    }
    if (!gradient.empty()) gradient[i] = slope;
  }
}

}  // namespace cognate::problems
