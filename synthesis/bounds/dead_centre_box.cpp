#include "synthesis/bounds/dead_centre_box.hpp"

#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

/// A value and its derivatives by three sides, over a box.
struct Sloped {
  Interval value;
  std::array<Interval, 3> by{};
};

template <class Value, class Slope>
Sloped combined(const Value& value, const Slope& slope) {
  Sloped result{value, {}};
  for (int i = 0; i < 3; ++i) result.by[i] = slope(i);
  return result;
}

Sloped operator+(const Sloped& a, const Sloped& b) {
  return combined(a.value + b.value, [&](int i) { return a.by[i] + b.by[i]; });
}
Sloped operator-(const Sloped& a, const Sloped& b) {
  return combined(a.value - b.value, [&](int i) { return a.by[i] - b.by[i]; });
}
Sloped operator*(const Sloped& a, const Sloped& b) {
  return combined(a.value * b.value, [&](int i) { return a.by[i] * b.value + a.value * b.by[i]; });
}
/// `b` positive.
Sloped operator/(const Sloped& a, const Sloped& b) {
  const Interval quotient = a.value / b.value;
  return combined(quotient, [&](int i) { return (a.by[i] - quotient * b.by[i]) / b.value; });
}

Sloped constant(double value) {
  return {value, {}};
}

/// k, δ and s with their derivatives by the sides.
struct Proportioned {
  Sloped k, difference, inverse;
};

Proportioned proportions(const ProportionBox& box) {
  Proportioned p;
  p.k = {box.side[0], {1}};
  const Interval& second = box.side[2];
  if (box.proportions == Proportions::any) {
    p.difference = {box.side[1], {0, 1}};
    const Sloped sigma{second, {0, 0, 1}};
    p.inverse = sigma / (constant(1) - sigma);
    return p;
  }
  const double sign = box.proportions == Proportions::frame_shortest ? -1 : 1;
  const Sloped inner = constant(sign) * (constant(2) * p.k - constant(1));
  p.difference = inner * Sloped{cos(box.side[1]), {0, -sin(box.side[1])}};
  p.inverse = {cos(second), {0, 0, -sin(second)}};
  return p;
}

/// The cosine of the angle at A between A→D and the crank; the divisor must be positive.
std::optional<Sloped> cosine_of(const ProportionBox& box, LimitOfOutput limit) {
  const auto [k, difference, inverse] = proportions(box);
  const double side = limit == LimitOfOutput::outer ? 1 : -1;
  // With c = ±(1 − k): |A–C|/(l₂ + l₃) = (1 + s δ + 2 s c)/2.
  const Sloped crank = constant(side) * (constant(1) - k);
  const Sloped reach = constant(1) + inverse * difference + constant(2) * inverse * crank;
  const Sloped divisor = k * reach;
  if (!(divisor.value.low > 0)) return std::nullopt;
  const Sloped sum = (crank + difference) * (constant(1) + inverse * crank) + inverse * k * k;
  return constant(side) * (sum / divisor);
}

}  // namespace

std::optional<LimitAngle> limit_angle(const ProportionBox& box, LimitOfOutput limit) {
  constexpr double kRounding = 4e-15;
  // The open assembly is extended with the crank above A→D, folded with it below.
  const double sense = limit == LimitOfOutput::outer ? box.assembly : -box.assembly;
  LimitAngle angle;
  ProportionBox middle = box;
  for (Interval& side : middle.side) side = Interval(side.middle());
  const auto cosine = cosine_of(box, limit), cosine0 = cosine_of(middle, limit);
  if (!cosine || !cosine0) {  // nothing is known
    angle.radius = angle.reach = kTurn;
    return angle;
  }
  const Interval& c = cosine->value;
  if (c.low > 1 || c.high < -1) return std::nullopt;
  const Interval within = clamped(c, -1, 1), at = clamped(cosine0->value, -1, 1);
  const Interval whole{std::acos(within.high) - kRounding, std::acos(within.low) + kRounding};
  const Interval there{std::acos(at.high) - kRounding, std::acos(at.low) + kRounding};
  const double unsigned_middle = there.middle();
  angle.middle = sense * unsigned_middle;
  angle.reach = std::max(whole.high - unsigned_middle, unsigned_middle - whole.low) + kRounding;
  angle.radius = angle.reach;
  const Interval sine = sqrt((Interval(1) - within) * (Interval(1) + within));
  if (!(sine.low > 0) || c.low < -1 || c.high > 1) return angle;
  std::array<double, 3> slope{};
  double radius = there.radius() + kRounding;
  for (int i = 0; i < 3; ++i) {
    const Interval by = Interval(-sense) * cosine->by[i] / sine;
    const double half = box.side[i].radius();
    slope[i] = by.middle() * half;
    radius += by.radius() * half;
  }
  if (radius < angle.radius) {
    angle.slope = slope;
    angle.radius = radius;
  }
  return angle;
}

}  // namespace cognate::synthesis
