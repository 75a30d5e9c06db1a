#include "problems/certificate/box_limits.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

/// Lengths of crank, coupler, rocker and frame over twice the sum of coupler and rocker, where no
/// length is infinite.
std::array<QuadInterval, 4> shares_of(const QuadProportions& p) {
  const QuadInterval one(1), doubled = QuadInterval(2) * p.inverse;
  const QuadInterval size = p.inverse * p.difference;
  return {doubled * p.crank, one + size, one - size, doubled * p.frame};
}

}  // namespace

BoxLimits::BoxLimits(const std::array<Range, 4>& lengths, const Constraints& constraints,
                     double ratio)
    : ratio_(Quad(ratio) * (1 + Quad(kCheckTolerance))) {
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (lengths[i].min > 0) least_[i] = Quad(lengths[i].min) * (1 - 2 * Quad(kCheckTolerance));
    if (std::isfinite(lengths[i].max)) {
      greatest_[i] = Quad(lengths[i].max) * (1 + 2 * Quad(kCheckTolerance));
    }
  }
  if (!constraints.transmission_angle) return;
  const Range& angle = *constraints.transmission_angle;
  const Quad least = Quad(angle.min) - 2 * kCheckTolerance;
  const Quad greatest = Quad(angle.max) + 2 * kCheckTolerance;
  if (least > 0) cosine_of_min_ = cosine(least);
  if (greatest < kPi) cosine_of_max_ = cosine(greatest);
}

bool BoxLimits::may_keep_ratio(const QuadProportions& p) const {
  const auto lengths = shares_of(p);
  for (const QuadInterval& shorter : lengths) {
    for (const QuadInterval& longer : lengths) {
      if (longer.low > (QuadInterval(ratio_) * shorter.high).high) return false;
    }
  }
  return true;
}

std::optional<QuadInterval> BoxLimits::crank_lengths(const QuadBox& box,
                                                     const QuadProportions& p) const {
  if (!may_keep_ratio(p)) return std::nullopt;
  if (box.crank_turns() && !may_transmit(p, square(p.inner), QuadInterval(1))) return std::nullopt;
  const auto shares = shares_of(p);
  QuadInterval crank{0, std::numeric_limits<Quad>::infinity()};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (!(shares[i].low > 0)) continue;
    const QuadInterval per_length = i == 0 ? QuadInterval(1) : shares[0] / shares[i];
    if (least_[i]) crank.low = std::max(crank.low, (QuadInterval(*least_[i]) * per_length).low);
    if (greatest_[i]) {
      crank.high = std::min(crank.high, (QuadInterval(*greatest_[i]) * per_length).high);
    }
  }
  if (crank.low > crank.high) return std::nullopt;
  return crank;
}

bool BoxLimits::may_transmit(const QuadProportions& p, const QuadInterval& least,
                             const QuadInterval& greatest) const {
  // cos μ = (1 + s²δ² − 2 s²D²)/(1 − s²δ²), s = 1/(coupler + rocker), δ = coupler − rocker.
  const QuadInterval one(1), two(2), s = square(p.inverse), size = s * square(p.difference);
  const auto excess = [&](const QuadInterval& square, const QuadInterval& limit) {
    return one + size - two * s * square - limit * (one - size);
  };
  if (cosine_of_min_ && excess(least, *cosine_of_min_).low > 0) return false;
  return !(cosine_of_max_ && excess(greatest, *cosine_of_max_).high < 0);
}

}  // namespace cognate::problems
