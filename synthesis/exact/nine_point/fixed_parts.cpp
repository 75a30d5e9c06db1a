#include "synthesis/exact/nine_point/fixed_parts.hpp"

#include <cmath>

namespace cognate::synthesis {
namespace {

using Complex = std::complex<double>;

/// Places in the unknowns; each conjugate comes next.
enum Place { moving_a = 0, fixed_a = 2, moving_d = 4, fixed_d = 6 };

SideCondition equal(int place, Complex value) {
  SideCondition condition;
  condition.linear[std::size_t(place)] = 1;
  condition.value = value;
  return condition;
}

SideCondition squared_distance(int from, int to, Complex square) {
  SideCondition condition;
  condition.from = from;
  condition.to = to;
  condition.value = square;
  return condition;
}

/// c̄ (a − b) − c (ā − b̄) = 0, c = e^{iα}: the frame has the direction α or the opposite one. The
/// coefficients are conjugates of one another for any rounding of c, so that conjugation
/// carries solutions into solutions (which e^{2iα} for c/c̄, its modulus rounded, would not).
SideCondition frame_direction(Complex c, Complex c_bar) {
  SideCondition condition;
  condition.linear[fixed_a] = c_bar;
  condition.linear[fixed_d] = -c_bar;
  condition.linear[fixed_a + 1] = -c;
  condition.linear[fixed_d + 1] = c;
  return condition;
}

/// x + ζ(y − x) = 0, the coupler point being the origin; or of the conjugates.
SideCondition coupler_ratio(std::size_t bar, Complex ratio) {
  SideCondition condition;
  condition.linear[moving_a + bar] = 1.0 - ratio;
  condition.linear[moving_d + bar] = ratio;
  return condition;
}

/// The values of the parameters of the conditions, from given parts or from a point.
struct Parameters {
  Complex a, a_bar, d, d_bar, along, along_bar, ratio, ratio_bar, crank, coupler, rocker, frame;
};

std::vector<SideCondition> conditions_of(const FixedParts& kind, const Parameters& at) {
  std::vector<SideCondition> all;
  if (kind.pivot_a) {
    all.push_back(equal(fixed_a, at.a));
    all.push_back(equal(fixed_a + 1, at.a_bar));
  }
  if (kind.pivot_d) {
    all.push_back(equal(fixed_d, at.d));
    all.push_back(equal(fixed_d + 1, at.d_bar));
  }
  if (kind.frame_angle) all.push_back(frame_direction(at.along, at.along_bar));
  if (kind.crank) all.push_back(squared_distance(moving_a, fixed_a, at.crank));
  if (kind.coupler) all.push_back(squared_distance(moving_a, moving_d, at.coupler));
  if (kind.rocker) all.push_back(squared_distance(moving_d, fixed_d, at.rocker));
  if (kind.frame) all.push_back(squared_distance(fixed_a, fixed_d, at.frame));
  if (kind.coupler_point && kind.coupler) {
    all.push_back(coupler_ratio(0, at.ratio));
    all.push_back(coupler_ratio(1, at.ratio_bar));
  }
  return all;
}

}  // namespace

FixedParts without_repetition(const FixedParts& given) {
  FixedParts parts = given;
  if (!parts.coupler) parts.coupler_point.reset();
  if (parts.frame && parts.frame_angle && parts.pivot_a.has_value() != parts.pivot_d.has_value()) {
    const Vec2d span =
        *parts.frame * Vec2d{std::cos(*parts.frame_angle), std::sin(*parts.frame_angle)};
    if (parts.pivot_a) {
      parts.pivot_d = *parts.pivot_a + span;
    } else {
      parts.pivot_a = *parts.pivot_d - span;
    }
  }
  if (parts.pivot_a && parts.pivot_d) {
    parts.frame.reset();
    parts.frame_angle.reset();
  }
  return parts;
}

int condition_count(const FixedParts& given) {
  const FixedParts parts = without_repetition(given);
  return 2 * (parts.pivot_a.has_value() + parts.pivot_d.has_value() +
              parts.coupler_point.has_value()) +
         parts.frame_angle.has_value() + parts.crank.has_value() + parts.coupler.has_value() +
         parts.rocker.has_value() + parts.frame.has_value();
}

std::vector<SideCondition> side_conditions(const FixedParts& given, const PathSystem& system) {
  const FixedParts parts = without_repetition(given);
  const auto place = [&](const std::optional<Vec2d>& pivot) {
    const Vec2d z = pivot ? (1 / system.scale) * (*pivot - system.origin) : Vec2d{};
    return Complex(z.x, z.y);
  };
  const auto square = [&](const std::optional<double>& length) {
    const double scaled = length.value_or(0) / system.scale;
    return Complex(scaled * scaled);
  };
  Parameters at;
  at.a = place(parts.pivot_a);
  at.d = place(parts.pivot_d);
  at.along = std::polar(1.0, parts.frame_angle.value_or(0));
  if (parts.coupler_point) {
    at.ratio = Complex(parts.coupler_point->x, parts.coupler_point->y) / *parts.coupler;
  }
  at.a_bar = std::conj(at.a);
  at.d_bar = std::conj(at.d);
  at.along_bar = std::conj(at.along);
  at.ratio_bar = std::conj(at.ratio);
  at.crank = square(parts.crank);
  at.coupler = square(parts.coupler);
  at.rocker = square(parts.rocker);
  at.frame = square(parts.frame);
  return conditions_of(parts, at);
}

std::vector<SideCondition> side_conditions_at(const FixedParts& kind,
                                              const PivotUnknowns<Complex>& u) {
  const auto square = [&](std::size_t p, std::size_t q) {
    return (u[p] - u[q]) * (u[p + 1] - u[q + 1]);
  };
  Parameters at;
  at.a = u[fixed_a];
  at.a_bar = u[fixed_a + 1];
  at.d = u[fixed_d];
  at.d_bar = u[fixed_d + 1];
  at.along = u[fixed_a] - u[fixed_d];
  at.along_bar = u[fixed_a + 1] - u[fixed_d + 1];
  at.ratio = -u[moving_a] / (u[moving_d] - u[moving_a]);
  at.ratio_bar = -u[moving_a + 1] / (u[moving_d + 1] - u[moving_a + 1]);
  at.crank = square(moving_a, fixed_a);
  at.coupler = square(moving_a, moving_d);
  at.rocker = square(moving_d, fixed_d);
  at.frame = square(fixed_a, fixed_d);
  return conditions_of(without_repetition(kind), at);
}

}  // namespace cognate::synthesis
