#include "synthesis/bounds/proportion_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {

bool crank_range(const ProportionRanges& ranges, const LengthLimits& limits, double& low,
                 double& high) {
  const Interval size = ranges.inverse * ranges.difference, doubled = Interval(2) * ranges.inverse;
  const Interval coupler = Interval(1) + size, rocker = Interval(1) - size;
  const auto crank_by = [&](const Interval& share, const Interval& of) {
    return of.low > 0 ? share * ranges.crank / of : Interval(0, kInfinity);
  };
  const Interval ratio[4] = {Interval(1), crank_by(doubled, coupler), crank_by(doubled, rocker),
                             crank_by(Interval(1), ranges.frame)};
  low = 0;
  high = kInfinity;
  for (int i = 0; i < 4; ++i) {
    if (limits.least[i] > 0) low = std::max(low, Interval::below(limits.least[i] * ratio[i].low));
    if (std::isfinite(limits.greatest[i])) {
      high = std::min(high, Interval::above(limits.greatest[i] * ratio[i].high));
    }
  }
  return low <= high;
}

bool may_satisfy(const ProportionRanges& r, const ProportionLimits& limits, bool turning) {
  // Lengths times 2 s, all of them finite.
  const Interval doubled = Interval(2) * r.inverse, size = r.inverse * r.difference;
  const Interval link[4] = {doubled * r.crank, Interval(1) + size, Interval(1) - size,
                            doubled * r.frame};
  for (const Interval& shorter : link) {
    for (const Interval& longer : link) {
      if (longer.low > limits.greatest_ratio * shorter.high * (1 + 1e-9)) return false;
    }
  }
  if (turning) return true;
  // Grashof with link i the shortest: l_i + l_k ≤ the other two, for each other k.
  const auto shortest = [&](int i, bool surely) {
    for (int k = 0; k < 4; ++k) {
      if (k == i) continue;
      Interval spare = -link[i] - link[k];
      for (int other = 0; other < 4; ++other) {
        if (other != i && other != k) spare = spare + link[other];
      }
      constexpr double kSlack = 1e-12;
      if (surely ? !(spare.low > kSlack) : !(spare.high >= -kSlack)) return false;
    }
    return true;
  };
  using Class = ProportionLimits::Class;
  switch (limits.required) {
    case Class::any:
      return true;
    case Class::coupler_shortest:
      return shortest(1, false);
    case Class::rocker_shortest:
      return shortest(2, false);
    case Class::grashof:
      return shortest(0, false) || shortest(1, false) || shortest(2, false) || shortest(3, false);
    case Class::non_grashof:
      return !shortest(0, true) && !shortest(1, true) && !shortest(2, true) && !shortest(3, true);
  }
  return true;
}

bool may_transmit(const ProportionRanges& r, const ProportionLimits& limits, const Interval& least,
                  const Interval& greatest) {
  // tan²(μ/2) = s²(d² − δ²)/(1 − s²d²), which grows with s and d and falls with |δ|.
  const Interval s = square(r.inverse), difference = square(r.difference);
  const auto half = [](double angle) {
    return std::pair{std::cos(angle / 2), std::sin(angle / 2)};
  };
  const auto [min_cos, min_sin] = half(limits.transmission_min);
  const auto [max_cos, max_sin] = half(limits.transmission_max);
  const double d_high = Interval::above(least.high * least.high);
  const double top = s.high * std::max(0.0, d_high - difference.low), beneath = 1 - s.high * d_high;
  constexpr double kSlack = 1e-9;
  if (top * min_cos * min_cos < beneath * min_sin * min_sin - kSlack * (1 + top)) return false;
  const double d_low = Interval::below(greatest.low * greatest.low);
  const double few = s.low * std::max(0.0, d_low - difference.high), more = 1 - s.low * d_low;
  return !(few * max_cos * max_cos > more * max_sin * max_sin + kSlack * (1 + few));
}

}  // namespace cognate::synthesis
