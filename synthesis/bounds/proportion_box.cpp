#include "synthesis/bounds/proportion_box.hpp"

#include <cmath>

namespace cognate::synthesis {
namespace {

constexpr double kRounding = 1e-15;  ///< more than a middle value of order one is off by
/// Where d² may be less, B may meet D for all that is known.
constexpr double kLeastSquare = 1e-10;

/// k(1 − k).
Interval product_of(const Interval& k) {
  const auto at = [](double end) { return Interval(end) * (Interval(1) - Interval(end)); };
  const Interval a = at(k.low), b = at(k.high);
  const bool holds_half = k.low <= 0.5 && k.high >= 0.5;
  return {std::min(a.low, b.low), holds_half ? 0.25 : std::max(a.high, b.high)};
}

Interval inner_of(const Interval& k, Proportions proportions) {
  const Interval inner = proportions == Proportions::frame_shortest ? Interval(1) - Interval(2) * k
                                                                    : Interval(2) * k - Interval(1);
  if (proportions != Proportions::any) return clamped(inner, 0, 1);
  if (inner.low >= 0) return inner;
  if (inner.high <= 0) return -inner;
  return {0, inner.magnitude()};
}

Interval inverse_of(const ProportionBox& box) {
  const Interval& side = box.side[2];
  if (box.proportions != Proportions::any) return clamped(cos(side), 0, 1);
  const auto at = [](double end) { return Interval(end) / (Interval(1) - Interval(end)); };
  return {at(side.low).low, at(side.high).high};
}

Interval difference_of(const ProportionBox& box, const Interval& inner) {
  if (box.proportions == Proportions::any) return box.side[1];
  return inner * cos(box.side[1]);
}

/// (m/d)² where d² = m² + (1 − m²) w/2; 0 where both vanish.
double inner_share(double inner, double versine) {
  const double square = inner * inner, rest = (1 - square) * 0.5 * versine;
  return square + rest > 0 ? square / (square + rest) : 0;
}

/// sin/√(1 − share·cos²), at most 1; increasing in both.
Interval sine_ratio(const Interval& share, const Interval& sine) {
  const auto at = [](double part, double sin) {
    const double square = sin * sin;
    return square > 0 ? sin / std::sqrt(part * square + (1 - part)) : 0;
  };
  const double least = at(share.low, sine.low) * (1 - 8 * kRounding);
  if (!(sine.high > 0)) return {0, 1};
  return {least, std::min(1.0, at(share.high, sine.high) * (1 + 8 * kRounding))};
}

/// β from a and b, see the file comment.
double angle_at(double a, double b) {
  return 2 * std::atan2(std::sqrt((1 - a) * (1 - b)), std::sqrt((1 + a) * (1 + b)));
}

/// By how much arccos is off where its argument, of the given sine, is off by `error`.
double angle_error(double sine, double error) {
  return 2 * error / std::max(sine, std::sqrt(error));
}

}  // namespace

ProportionRanges ranges_of(const ProportionBox& box) {
  const Interval& k = box.side[0];
  const Interval inner = inner_of(k, box.proportions);
  return {k, Interval(1) - k, difference_of(box, inner), inverse_of(box), inner, 1};
}

struct BoxDirections::Place {
  Interval sine, versine, reach;                  ///< of the crank angle: sin, 1 − cos, 1 + cos
  Interval square, d;                             ///< d² and d
  Interval shortfall;                             ///< 1 − d²
  Interval share;                                 ///< (m/d)², of a turning crank
  Interval a, b;                                  ///< `a` with the sign of the link
  Interval sin_a, sin_b;                          ///< √(1 − a²), √(1 − b²)
  double sign = 1;                                ///< of the link: that of δ in `a`
  double a0 = 0, b0 = 0, sin_a0 = 0, sin_b0 = 0;  ///< at the middle
  double error = 0;                               ///< of the angle β there
};

BoxDirections::BoxDirections(const ProportionBox& box)
    : box_(box),
      turning_(box.proportions != Proportions::any),
      side_of_half_(box.proportions == Proportions::frame_shortest ? -1 : 1) {
  for (int i = 0; i < kBoxSides; ++i) {
    middle_[i] = box.side[i].middle();
    half_[i] = box.side[i].low == box.side[i].high ? 0 : box.side[i].radius();
  }
  k_ = box.side[0];
  product_ = product_of(k_);
  inner_ = inner_of(k_, box.proportions);
  difference_ = difference_of(box, inner_);
  inverse_ = inverse_of(box);
  inner0_ = std::abs(2 * middle_[0] - 1);
  if (turning_) {
    first_cos_ = cos(box.side[1]);
    first_sin_ = clamped(sin(box.side[1]), 0, 1);
    second_sin_ = clamped(sin(box.side[2]), 0, 1);
    cos0_ = std::cos(middle_[1]);
    sin0_ = std::sin(middle_[1]);
    second_sin0_ = std::sin(middle_[2]);
    difference0_ = inner0_ * cos0_;
    inverse0_ = std::cos(middle_[2]);
  } else {
    difference0_ = middle_[1];
    inverse0_ = middle_[2] / (1 - middle_[2]);
  }
}

void BoxDirections::place_triangle(Place& p, double d0, const Vec2d& half) const {
  const double versine0 = 2 * half.y * half.y, reach0 = 2 * half.x * half.x;
  p.b = inverse_ * p.d;
  p.b0 = std::min(inverse0_ * d0, 1.0);
  if (!turning_) {
    p.a = Interval(p.sign) * difference_ / p.d;
    p.a0 = std::clamp(p.sign * difference0_ / d0, -1.0, 1.0);
    p.sin_a0 = std::sqrt((1 - p.a0) * (1 + p.a0));
    p.sin_b0 = std::sqrt((1 - p.b0) * (1 + p.b0));
    return;
  }
  p.share = {std::max(0.0, inner_share(inner_.low, p.versine.high) * (1 - 8 * kRounding)),
             std::min(1.0, inner_share(inner_.high, p.versine.low) * (1 + 8 * kRounding))};
  p.a = Interval(p.sign) * sqrt(p.share) * first_cos_;
  const Interval rest = clamped(Interval(2) * product_ * p.versine / p.square, 0, 1);
  p.sin_a = sqrt(rest + p.share * square(first_sin_));
  p.sin_b = sqrt(p.shortfall + p.square * square(second_sin_));
  // In sums without cancellation, here as above: no digits are lost near change points.
  const double share0 = inner_share(inner0_, versine0), square0 = d0 * d0;
  const double doubled = 2 * middle_[0] * (1 - middle_[0]);
  p.a0 = p.sign * std::sqrt(share0) * cos0_;
  p.sin_a0 = std::sqrt(std::min(1.0, doubled * versine0 / square0 + share0 * sin0_ * sin0_));
  p.sin_b0 = std::sqrt(doubled * reach0 + square0 * second_sin0_ * second_sin0_);
}

DirectionRange BoxDirections::at(double theta, DirectedLink link) const {
  Place p;
  p.sign = link == DirectedLink::coupler ? 1 : -1;
  const Interval turned = Interval(theta) + box_.side[3];
  const Interval cosine = cos(turned);
  p.sine = sin(turned);
  p.versine = clamped(Interval(1) - cosine, 0, 2);
  p.reach = clamped(Interval(1) + cosine, 0, 2);
  p.shortfall = Interval(2) * product_ * p.reach;
  p.square = clamped(Interval(1) - p.shortfall, 0, 1);
  p.d = sqrt(p.square);

  const double angle0 = theta + middle_[3], crank0 = 1 - middle_[0];
  const Vec2d diagonal0{middle_[0] - crank0 * std::cos(angle0), -crank0 * std::sin(angle0)};
  const double d0 = std::sqrt(squared_norm(diagonal0));

  DirectionRange range;
  range.diagonal = p.d;
  if (!(p.square.low > kLeastSquare)) return unknown(range);
  place_triangle(p, d0, {std::cos(0.5 * angle0), std::sin(0.5 * angle0)});
  range.closes = p.a.low <= 1 && p.a.high >= -1 && p.b.low <= 1;
  p.a = clamped(p.a, -1, 1);
  p.b = clamped(p.b, 0, 1);
  if (!turning_) {
    p.sin_a = sqrt((Interval(1) - p.a) * (Interval(1) + p.a));
    p.sin_b = sqrt((Interval(1) - p.b) * (Interval(1) + p.b));
  }
  // The coupler is turned from B→D by β, the rocker from D→B by −β, in the open assembly.
  const double sense = p.sign * box_.assembly;
  const Vec2d beta0{p.a0 + p.b0, sense * p.sin_a0 * p.sin_b0};
  const double size0 = std::sqrt(squared_norm(beta0));
  if (!(size0 > 1e-9)) return unknown(range);
  range.middle = (p.sign / (size0 * d0)) * (beta0 * diagonal0);
  range.middle = (1 / std::sqrt(squared_norm(range.middle))) * range.middle;
  const double error = 8 * kRounding / p.square.low;
  p.error = turning_ ? 2 * error : angle_error(p.sin_a0, error) + angle_error(p.sin_b0, error);
  range.radius = p.error + 8 * kRounding * (1 / size0 + 1 / d0);
  enclose(p, sense, range);
  return range;
}

/// Any direction at all.
DirectionRange BoxDirections::unknown(DirectionRange range) const {
  range.middle = {1, 0};
  range.radius = 4;
  for (int i = 0; i < kBoxSides; ++i) range.doubt[i] = 4 * half_[i];
  return range;
}

/// Adds the change of ψ and of β over the box.
void BoxDirections::enclose(const Place& p, double sense, DirectionRange& range) const {
  const Interval crank = Interval(1) - k_, per_square = Interval(1) / p.square;
  Slopes slope;
  slope[0] = p.sine * per_square;
  slope[3] = crank * (crank - k_ * (Interval(1) - p.versine)) * per_square;
  Slopes both = slope;
  double doubt = 4;                                      // what β's slopes leave open
  const bool apart = (Interval(1) + p.a * p.b).low > 0;  // else the angle is near half a turn
  if (apart && p.sin_a.low > 0 && p.sin_b.low > 0) {
    const Slopes beta = angle_slopes(p, per_square);
    doubt = 0;
    for (int i = 0; i < kBoxSides; ++i) {
      both[i] = slope[i] + Interval(sense) * beta[i];
      doubt += beta[i].radius() * half_[i];
    }
  }
  // Where the slopes tell little, the greatest and least angle may tell more.
  constexpr double kTelling = 0.05;
  if (!(doubt < kTelling)) {
    const double middle = std::atan2(p.sin_a0 * p.sin_b0, p.a0 + p.b0);
    const double spread =
        std::max(angle_at(p.a.low, p.b.low) - middle, middle - angle_at(p.a.high, p.b.high)) +
        2 * p.error + 8 * kRounding;
    if (!(doubt < spread)) {
      range.radius += spread;
      both = slope;
      range.doubt = angle_changes(p);
    }
  }
  for (int i = 0; i < kBoxSides; ++i) {
    range.slope[i] = both[i].middle() * half_[i];
    range.radius += both[i].radius() * half_[i];
    range.doubt[i] += both[i].radius() * half_[i];
  }
}

/// How much β changes over half of each side alone, roughly.
std::array<double, kBoxSides> BoxDirections::angle_changes(const Place& p) const {
  const auto change = [](double a, double b, double other_a, double other_b) {
    const auto in_range = [](double x) { return std::clamp(x, -1.0, 1.0); };
    return 0.5 * std::abs(angle_at(in_range(a), in_range(b)) -
                          angle_at(in_range(other_a), in_range(other_b)));
  };
  std::array<double, kBoxSides> changes{};
  const double d0 = p.d.middle();
  if (turning_) {
    const double ratio = std::sqrt(p.share.middle());
    changes[1] =
        change(p.sign * ratio * first_cos_.low, p.b0, p.sign * ratio * first_cos_.high, p.b0);
    changes[0] = change(p.sign * std::sqrt(p.share.low) * cos0_, inverse0_ * p.d.low,
                        p.sign * std::sqrt(p.share.high) * cos0_, inverse0_ * p.d.high);
  } else {
    changes[1] = change(p.sign * difference_.low / d0, p.b0, p.sign * difference_.high / d0, p.b0);
    changes[0] = change(p.sign * difference0_ / p.d.low, inverse0_ * p.d.low,
                        p.sign * difference0_ / p.d.high, inverse0_ * p.d.high);
  }
  changes[2] = change(p.a0, inverse_.low * d0, p.a0, inverse_.high * d0);
  // What d's change gives is shared between k and the phase as they change d.
  const double by_k = half_[0] * std::abs(2 * middle_[0] - 1) * p.reach.magnitude() + 1e-12;
  const double by_phase = half_[3] * p.sine.magnitude() * middle_[0] * (1 - middle_[0]);
  changes[3] = changes[0] * by_phase / (by_k + by_phase);
  changes[0] -= changes[3];
  return changes;
}

/// Derivatives of β by the sides of the box.
BoxDirections::Slopes BoxDirections::angle_slopes(const Place& p,
                                                  const Interval& per_square) const {
  const Interval beneath = Interval(1) / (Interval(1) + p.a * p.b);
  const Interval by_a = -(p.sin_b / p.sin_a * beneath), by_b = -(p.sin_a / p.sin_b * beneath);
  const Interval turn = product_ * p.sine * per_square;  // ∂ ln d/∂θ
  const Interval stretch = (Interval(2) * k_ - Interval(1)) * p.reach * per_square;  // ∂ ln d/∂k
  const Interval sign = p.sign;
  Slopes slope;
  slope[3] = turn * (by_b * p.b - by_a * p.a);
  if (turning_) {
    const Interval a_by_k =
        Interval(p.sign * side_of_half_) * first_cos_ * p.versine * per_square / p.d;
    slope[0] = by_a * a_by_k + by_b * p.b * stretch;
    slope[1] = sign * sqrt(p.share) * p.sin_b * beneath * sine_ratio(p.share, first_sin_);
    slope[2] = p.d * p.sin_a * beneath * sine_ratio(p.square, second_sin_);
  } else {
    slope[0] = stretch * (by_b * p.b - by_a * p.a);
    slope[1] = sign * by_a / p.d;
    slope[2] = by_b * p.d * square(Interval(1) + inverse_);
  }
  return slope;
}

std::pair<ProportionBox, ProportionBox> halves(const ProportionBox& box, int side) {
  std::pair parts{box, box};
  const double middle = box.side[side].middle();
  parts.first.side[side].high = middle;
  parts.second.side[side].low = middle;
  return parts;
}

int worst_side(const ProportionBox& box, const std::vector<DirectionRange>& directions) {
  std::array<double, kBoxSides> common{}, loss{};
  for (const DirectionRange& at : directions) {
    for (int i = 0; i < kBoxSides; ++i) common[i] += at.slope[i] / double(directions.size());
  }
  constexpr double kFirstOrder = 0.02;  // decides where nothing is lost otherwise
  for (const DirectionRange& at : directions) {
    double turned = kFirstOrder;
    for (int i = 0; i < kBoxSides; ++i) turned += std::abs(at.slope[i] - common[i]);
    turned = std::min(turned, 1.0);
    for (int i = 0; i < kBoxSides; ++i) {
      loss[i] += turned * std::abs(at.slope[i] - common[i]) + at.doubt[i];
    }
  }
  constexpr double kNarrowest = 1e-13;  // no side is divided further
  int worst = -1;
  for (int i = 0; i < kBoxSides; ++i) {
    if (box.side[i].high - box.side[i].low <= kNarrowest) continue;
    if (worst < 0 || loss[i] > loss[worst]) worst = i;
  }
  return worst;
}

}  // namespace cognate::synthesis
