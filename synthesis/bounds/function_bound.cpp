#include "synthesis/bounds/function_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "synthesis/bounds/box_quadratic.hpp"

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

constexpr double kFunctionRounding = 1e-15;
/// Errors of different samples differ by less than π wherever the sum of squares is below this, so
/// that it is known how many whole turns lie between them.
constexpr double kMostSquares = 0.6;
constexpr int kFunctionTerms = kBoxSides + 1;

double wrapped(double angle) {
  return std::remainder(angle, kTurn);
}

/// The phase as a function of the other sides: what it adds to a direction goes to theirs.
void substitute(const LimitAngle& phase, DirectionRange& range) {
  const double by_phase = phase.reach > 0 ? range.slope[3] / phase.reach : 0;
  for (int i = 0; i < 3; ++i) range.slope[i] += by_phase * phase.slope[i];
  const double added = std::abs(by_phase) * phase.radius;
  range.radius += added;
  for (int i = 0; i < 3; ++i) range.doubt[i] += range.doubt[3] / 3 + added / 3;
  range.slope[3] = range.doubt[3] = 0;
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

/// An error over a box: value[0] + Σ t_i value[i], up to rest.
struct FunctionBound::ErrorRange {
  std::array<double, kFunctionTerms> value{};
  double rest = 0;

  double spread() const {
    double sum = rest;
    for (int i = 1; i < kFunctionTerms; ++i) sum += std::abs(value[i]);
    return sum;
  }
};

FunctionBound::FunctionBound(DesiredFunction wanted, const ProportionLimits& limits)
    : function_(std::move(wanted)),
      limits_(limits),
      refers_(function_.start.has_value()),
      free_(!refers_ && !function_.output_start) {
  if (!refers_) return;
  function_.input.insert(function_.input.begin(), 0.0);
  function_.output.insert(function_.output.begin(), 0.0);
}

/// The output's directions; false where none of the linkages will do.
bool FunctionBound::enclose(const ProportionBox& whole,
                            std::vector<DirectionRange>& directions) const {
  const bool turning = whole.proportions != Proportions::any;
  const ProportionRanges ranges = ranges_of(whole);
  double low = 0, high = 0;
  if (!may_satisfy(ranges, limits_, turning)) return false;
  if (!crank_range(ranges, function_.lengths, low, high)) return false;
  if (turning && !may_transmit(ranges, limits_, ranges.inner, ranges.outer)) return false;
  ProportionBox box = whole;
  std::optional<LimitAngle> phase;
  if (function_.start) {
    phase = limit_angle(box, *function_.start);
    if (!phase) return false;
    box.side[3] = {phase->middle - phase->reach, phase->middle + phase->reach};
    phase->reach = box.side[3].radius();
  }
  const BoxDirections box_directions(box);
  for (const double input : function_.input) {
    directions.push_back(box_directions.at(input, DirectedLink::rocker));
    DirectionRange& at = directions.back();
    if (!at.closes) return false;
    if (!turning && !may_transmit(ranges, limits_, at.diagonal, at.diagonal)) return false;
    if (phase) substitute(*phase, at);
  }
  return true;
}

/// The errors at the samples, less those of which it is not known how many turns they are off: they
/// may be zero. Counted from one, so that those that belong together fall into the same turn: from
/// that at the start, or, where any start will do, from the best known.
std::vector<FunctionBound::ErrorRange> FunctionBound::errors(
    const std::vector<DirectionRange>& directions) const {
  std::vector<ErrorRange> all;
  for (std::size_t j = 0; j < directions.size(); ++j) {
    const DirectionRange& at = directions[j];
    ErrorRange error;
    error.value[0] = std::atan2(at.middle.y, at.middle.x) - function_.output[j] -
                     function_.output_start.value_or(0);
    for (int i = 0; i < kBoxSides; ++i) error.value[i + 1] = at.slope[i];
    error.rest = at.radius + kFunctionRounding * (8 + std::abs(function_.output[j]));
    all.push_back(error);
  }
  const ErrorRange reference = refers_ ? all.front()
                               : free_ ? *std::ranges::min_element(all, {}, &ErrorRange::spread)
                                       : ErrorRange{};
  std::vector<ErrorRange> kept;
  for (std::size_t j = refers_ ? 1 : 0; j < all.size(); ++j) {
    ErrorRange error = all[j];
    if (refers_) {
      error.rest += reference.rest;
      for (int i = 1; i < kFunctionTerms; ++i) error.value[i] -= reference.value[i];
    }
    error.value[0] = wrapped(error.value[0] - reference.value[0]);
    const double doubt = error.spread() + (free_ ? reference.spread() : 0);
    if (std::abs(error.value[0]) + doubt < kPi) kept.push_back(error);
  }
  return kept;
}

double FunctionBound::bound(const std::vector<DirectionRange>& directions, double wanted) const {
  const double target = std::min(wanted, kMostSquares);
  std::vector<ErrorRange> kept = errors(directions);
  if (kept.empty()) return 0;
  std::array<double, kFunctionTerms> mean{};
  for (const ErrorRange& error : kept) {
    for (int a = 0; a < kFunctionTerms && free_; ++a)
      mean[a] += error.value[a] / double(kept.size());
  }
  BoxQuadratic squares{};
  double lost = 0, rests = 0, size = 0;
  for (ErrorRange& error : kept) {
    double greatest = 0;
    for (int a = 0; a < kFunctionTerms; ++a) {
      error.value[a] -= mean[a];
      greatest += std::abs(error.value[a]);
    }
    for (int a = 0; a < kFunctionTerms; ++a) {
      for (int b = 0; b < kFunctionTerms; ++b) squares[a][b] += error.value[a] * error.value[b];
    }
    lost += 2 * greatest * error.rest;
    rests += error.rest * error.rest;
    size += greatest * greatest;
  }
  const double rounding = kFunctionRounding * double(kept.size() + 16) * (size + 1e-12);
  const double least = least_over_box(squares) - rounding;
  const double apart = std::sqrt(std::max(0.0, least)) - std::sqrt(rests);
  const double bound = std::max(least - lost, apart > 0 ? apart * apart * (1 - 1e-14) : 0.0);
  return std::clamp(bound * (1 - 1e-14), 0.0, target);
}

BoxBound FunctionBound::operator()(const ProportionBox& box, double wanted) const {
  std::vector<DirectionRange> directions;
  if (!enclose(box, directions)) return {kInfinity, -1};
  return {bound(directions, wanted), worst_side(box, directions)};
}

}  // namespace cognate::synthesis
