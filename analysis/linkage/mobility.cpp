#include "analysis/linkage/mobility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/linkage/closure.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/half_angle.hpp"

namespace cognate {
namespace {

std::array<double, 4> sorted(const Lengths<double>& links) {
  std::array<double, 4> all{links.crank, links.coupler, links.rocker, links.frame};
  std::ranges::sort(all);
  return all;
}

/// The lengths times a power of two, which rounds nothing, so that the longest is in [1, 2).
Lengths<double> normalised(const Lengths<double>& links) {
  const double k = 1 / std::ldexp(1.0, std::ilogb(sorted(links)[3]));
  return {k * links.crank, k * links.coupler, k * links.rocker, k * links.frame};
}

/// What Grashof's criterion compares, of normalised lengths: t₁ = l₄ − l₁ + l₃ − l₂, t₂ = l₄ − l₁ −
/// l₃ + l₂, t₃ = l₂ + l₃ − l₄ − l₁. All that is said of which link turns follows from these three
/// signs, a zero counting as either (McCarthy, "Geometric Design of Linkages", section 2.2).
struct Sums {
  double t1, t2, t3;
};

Sums sums(const Lengths<double>& normal) {
  const auto& [l1, l2, l3, l4] = normal;
  return {compensated_sum(l4, -l1, l3, -l2), compensated_sum(l4, -l1, -l3, l2),
          compensated_sum(l2, l3, -l4, -l1)};
}

/// The same, those zero that are so within `kChangePointTolerance`.
Sums certain_sums(const Lengths<double>& links) {
  const Lengths<double> normal = normalised(links);
  const double tolerance =
      kChangePointTolerance * std::max({normal.crank, normal.coupler, normal.rocker, normal.frame});
  const auto certain = [&](double sum) { return std::abs(sum) <= tolerance ? 0.0 : sum; };
  const auto [t1, t2, t3] = sums(normal);
  return {certain(t1), certain(t2), certain(t3)};
}

/// Whether B gets past D, and past the place opposite to it.
bool crank_meets_d(const Sums& sum) {
  return sum.t1 * sum.t2 >= 0;
}
bool crank_turns_away(const Sums& sum) {
  return sum.t3 >= 0;
}

bool crank_turns(const Sums& sum) {
  return crank_meets_d(sum) && crank_turns_away(sum);
}

/// `crank_turns` with crank and rocker exchanged.
bool rocker_turns(const Sums& sum) {
  return sum.t2 * sum.t3 <= 0 && sum.t1 <= 0;
}

/// A product of two sums of normalised lengths, negative only beyond what rounding explains.
double product(double a, double b) {
  const bool is_zero = std::min(std::abs(a), std::abs(b)) <= kChangePointTolerance;
  return is_zero && a * b < 0 ? 0.0 : a * b;
}

/// p = d² − (l₂ − l₃)² and q = (l₂ + l₃)² − d² where the crank points towards D (`near`) and away
/// from it (`far`). The linkage closes where both are positive.
struct Extremes {
  double p_near, q_near, p_far, q_far;
};

Extremes extremes(const Lengths<double>& links) {
  const Lengths<double> normal = normalised(links);
  const auto& [l1, l2, l3, l4] = normal;
  const auto [t1, t2, t3] = certain_sums(links);
  return {t1 * t2, product(compensated_sum(l1, l2, l3, -l4), compensated_sum(l4, -l1, l2, l3)),
          product(compensated_sum(l4, l1, -l2, l3), compensated_sum(l4, l1, l2, -l3)),
          t3 * compensated_sum(l1, l2, l3, l4)};
}

/// tan²(μ/2) = p/q at a crank angle from A→D, counted from whichever end of the frame is nearer.
struct FoldedDiagonal {
  double p, q;
};

/// The angles at which the crank's ranges end, none negative: with d = |l₂ − l₃| nearest to A→D,
/// with d = l₂ + l₃ farthest from it.
struct RangeEnds {
  std::optional<double> least, greatest;
};

RangeEnds range_ends(const Lengths<double>& links, const Extremes& at) {
  const Sums sum = certain_sums(links);
  RangeEnds ends;
  // 4 l₁ l₄ sin²(θ/2) = d² − (l₄ − l₁)² and 4 l₁ l₄ cos²(θ/2) = (l₄ + l₁)² − d².
  if (!crank_meets_d(sum)) ends.least = angle_of_half(-at.p_near, at.p_far);
  if (!crank_turns_away(sum)) ends.greatest = angle_of_half(at.q_near, -at.q_far);
  return ends;
}

/// (cos `end` − cos `angle`)/2 as a product, which is zero to full accuracy near ±`end`; zero where
/// rounding is all that parts them.
double half_cosine_fall(double end, double angle) {
  constexpr double kSame = 32 * std::numeric_limits<double>::epsilon();
  const double beyond = std::remainder(angle - end, kTurn);
  const double beyond_mirror = std::remainder(angle + end, kTurn);
  const double allowed = kSame * std::max(1.0, std::abs(angle));
  if (std::min(std::abs(beyond), std::abs(beyond_mirror)) <= allowed) return 0;
  return std::sin(0.5 * (angle - end)) * std::sin(0.5 * (angle + end));
}

/// p and q each in the form that keeps its digits where it is small.
FoldedDiagonal diagonal(const Lengths<double>& links, const Extremes& at, double crank_angle) {
  const auto [l1, l2, l3, l4] = normalised(links);
  const auto [least, greatest] = range_ends(links, at);
  const CrankDirection<double> crank = crank_direction(crank_angle);
  const double k = 2 * l1 * l4 * crank.versine;
  const bool near = crank.side > 0;
  FoldedDiagonal here{near ? at.p_near + k : at.p_far - k, near ? at.q_near - k : at.q_far + k};
  if (least) here.p = std::max(4 * l1 * l4 * half_cosine_fall(*least, crank_angle), 0.0);
  if (greatest) here.q = std::max(-4 * l1 * l4 * half_cosine_fall(*greatest, crank_angle), 0.0);
  return here;
}

/// The triangle A–C–D with |A–C| = `a` + `b` > 0, C above A→D: its angle at A, the supplement of
/// that, and the direction of D→C.
struct LimitTriangle {
  double at_a, supplement_at_a, rocker;
};

std::optional<LimitTriangle> limit_triangle(double a, double b, double rocker, double frame) {
  const double reach = compensated_sum(a, b, rocker, -frame);
  const double excess = compensated_sum(a, b, -rocker, frame);
  const double slack = compensated_sum(-a, -b, rocker, frame);
  const double perimeter = compensated_sum(a, b, rocker, frame);
  if (std::min({reach, excess, slack}) < -kChangePointTolerance) return std::nullopt;
  const double at_a = slack * reach, beside_a = excess * perimeter;
  return LimitTriangle{angle_of_half(at_a, beside_a), angle_of_half(beside_a, at_a),
                       angle_of_half(slack * perimeter, excess * reach)};
}

}  // namespace

double grashof_excess(const Lengths<double>& links) {
  const auto [shortest, second, third, longest] = sorted(normalised(links));
  return compensated_sum(shortest, longest, -second, -third) / longest;
}

EqualSums equal_sums(const Lengths<double>& links) {
  const auto [t1, t2, t3] = certain_sums(links);
  return {t1 == 0, t2 == 0, t3 == 0};
}

ChangePointClass change_point_class(const Lengths<double>& links) {
  const auto [first, second, third] = equal_sums(links);
  if (first && second && third) return ChangePointClass::rhombus;
  if (first && third) return ChangePointClass::parallelogram;
  if (first && second) return ChangePointClass::kite_b_on_d;
  if (second && third) return ChangePointClass::kite_c_on_a;
  return first || second || third ? ChangePointClass::single : ChangePointClass::none;
}

bool is_change_point(const Lengths<double>& links) {
  return change_point_class(links) != ChangePointClass::none;
}

MobilityClass mobility_class(const Lengths<double>& links) {
  const Sums sum = certain_sums(links);
  if (sum.t1 * sum.t2 * sum.t3 < 0) return MobilityClass::triple_rocker;
  const bool crank = crank_turns(sum), rocker = rocker_turns(sum);
  if (crank) return rocker ? MobilityClass::double_crank : MobilityClass::crank_rocker;
  return rocker ? MobilityClass::rocker_crank : MobilityClass::double_rocker;
}

bool can_assemble(const Lengths<double>& links) {
  const auto [shortest, second, third, longest] = sorted(normalised(links));
  return compensated_sum(longest, -shortest, -second, -third) <= 0;
}

bool crank_rotates(const Lengths<double>& links) {
  return can_assemble(links) && crank_turns(certain_sums(links));
}

bool rocker_rotates(const Lengths<double>& links) {
  return can_assemble(links) && rocker_turns(certain_sums(links));
}

std::vector<CrankRange> crank_ranges(const Lengths<double>& links) {
  constexpr double pi = kPi;
  if (!can_assemble(links)) return {};
  const Extremes at = extremes(links);
  const Sums sum = certain_sums(links);
  const bool meets_d = crank_meets_d(sum), turns_away = crank_turns_away(sum);
  if (meets_d && turns_away) return {{0, 2 * pi}};
  const auto [least, greatest] = range_ends(links, at);
  if (meets_d) return {{-*greatest, *greatest}};
  if (turns_away) return {{*least, 2 * pi - *least}};
  return {{*least, *greatest}, {-*greatest, -*least}};
}

TransmissionAngles transmission_angles(const Lengths<double>& links) {
  if (!can_assemble(links)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
  }
  const Extremes at = extremes(links);
  const double min = angle_of_half(at.p_near, at.q_near);
  const double supplement_of_max = angle_of_half(at.q_far, at.p_far);
  return {min, angle_of_half(at.p_far, at.q_far), std::min(min, supplement_of_max)};
}

TransmissionAngles transmission_angles(const Lengths<double>& links, const CrankRange& range) {
  constexpr double pi = kPi;
  const Extremes at = extremes(links);
  TransmissionAngles angles{pi, 0, pi};
  const auto include = [&](double crank_angle) {
    const auto [p, q] = diagonal(links, at, crank_angle);
    const double angle = angle_of_half(p, q);
    angles.min = std::min(angles.min, angle);
    angles.max = std::max(angles.max, angle);
    angles.acute_min = std::min({angles.acute_min, angle, angle_of_half(q, p)});
  };
  include(range.from);
  include(range.to);
  for (double k = std::ceil(range.from / pi); k * pi < range.to; ++k) include(k * pi);
  return angles;
}

std::optional<LimitPosition> outer_limit(const Lengths<double>& links) {
  const auto [l1, l2, l3, l4] = normalised(links);
  const auto triangle = limit_triangle(l1, l2, l3, l4);
  if (!triangle) return std::nullopt;
  return LimitPosition{triangle->at_a, triangle->rocker};
}

std::optional<LimitPosition> inner_limit(const Lengths<double>& links) {
  const auto [l1, l2, l3, l4] = normalised(links);
  if (l1 == l2) return std::nullopt;
  const bool folds_back = l2 > l1;  // C lies on the other side of A than B
  const auto triangle =
      folds_back ? limit_triangle(l2, -l1, l3, l4) : limit_triangle(l1, -l2, l3, l4);
  if (!triangle) return std::nullopt;
  // The open assembly folds with the crank below A→D: D×e < 0 in (D − l₁e)×(−l₂e) > 0.
  if (folds_back) return LimitPosition{-triangle->supplement_at_a, triangle->rocker};
  return LimitPosition{-triangle->at_a, -triangle->rocker};
}

std::optional<double> time_ratio(const Lengths<double>& links) {
  constexpr double pi = kPi;
  if (!crank_rotates(links)) return std::nullopt;
  const auto outer = outer_limit(links), inner = inner_limit(links);
  if (!outer || !inner) return std::nullopt;
  // The crank turns by this from one limit to the other, and by 2π less this back.
  const double advance = outer->crank_angle - inner->crank_angle;
  const double longer = std::max(advance, 2 * pi - advance);
  const double shorter = 2 * pi - longer;
  // A change point at both limits has the crank turn by nothing, or by rounding alone.
  constexpr double kRounding = 1e-12;
  if (shorter <= kRounding) return std::nullopt;
  return longer / shorter;
}

}  // namespace cognate
