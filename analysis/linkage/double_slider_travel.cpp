#include "analysis/linkage/double_slider_travel.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

/// The acute angle between a direction and a line.
double acute(const Vec2d& direction, const Vec2d& line) {
  return std::atan2(std::abs(cross(direction, line)), std::abs(dot(direction, line)));
}

/// The least and the greatest of k·v(θ) + c over θ, where v(θ) is the component of the unit vector
/// at θ across the unit vector `line`, to its right.
std::array<SliderPosition, 2> extremes_across(const Vec2d& line, double k, double c) {
  const double right = angle_of(-perp(line)), left = angle_of(perp(line));
  const SliderPosition a{right, c + k}, b{left, c - k};
  if (k > 0) return {b, a};
  return {a, b};
}

/// The lean of the lever from the perpendicular on the slide line, towards its direction.
std::optional<double> lean(const TangentGenerator& mechanism, double crank_angle) {
  const Vec2d lever = unit_vector(crank_angle);
  const double towards_line = mechanism.offset < 0 ? -lever.y : lever.y;
  if (!(towards_line > 0)) return std::nullopt;
  return std::atan2(lever.x, towards_line);
}

}  // namespace

double displacement(const ScotchYoke& mechanism, double crank_angle) {
  const Vec2d& slot = mechanism.slot;
  return (mechanism.crank * cross(unit_vector(crank_angle), slot) + mechanism.offset * slot.x) /
         slot.y;
}

std::array<SliderPosition, 2> limits(const ScotchYoke& mechanism) {
  const Vec2d& slot = mechanism.slot;
  return extremes_across(slot, mechanism.crank / slot.y, mechanism.offset * slot.x / slot.y);
}

double stroke(const ScotchYoke& mechanism) {
  return 2 * mechanism.crank / std::abs(mechanism.slot.y);
}

double pressure_angle(const ScotchYoke& mechanism) {
  return std::atan2(std::abs(mechanism.slot.x), std::abs(mechanism.slot.y));
}

CrankRange crank_range(const TangentGenerator& mechanism) {
  return mechanism.offset < 0 ? CrankRange{-kPi, 0} : CrankRange{0, kPi};
}

std::optional<double> displacement(const TangentGenerator& mechanism, double crank_angle) {
  if (!lean(mechanism, crank_angle)) return std::nullopt;
  const Vec2d lever = unit_vector(crank_angle);
  return mechanism.offset * lever.x / lever.y;
}

double crank_angle(const TangentGenerator& mechanism, double displacement) {
  return std::atan2(mechanism.offset, displacement);
}

std::optional<double> travel(const TangentGenerator& mechanism, const CrankRange& range) {
  const auto from = lean(mechanism, range.from), to = lean(mechanism, range.to);
  if (!from || !to || range.to - range.from >= kPi) return std::nullopt;
  // tan a − tan b, without their difference.
  const double between = std::sin(range.to - range.from);
  return std::abs(mechanism.offset * between / (std::cos(*from) * std::cos(*to)));
}

std::optional<double> pressure_angle(const TangentGenerator& mechanism, double crank_angle) {
  const auto at = lean(mechanism, crank_angle);
  if (!at) return std::nullopt;
  return std::abs(*at);
}

std::optional<double> greatest_pressure_angle(const TangentGenerator& mechanism,
                                              const CrankRange& range) {
  const auto from = pressure_angle(mechanism, range.from), to = pressure_angle(mechanism, range.to);
  if (!from || !to || range.to - range.from >= kPi) return std::nullopt;
  return std::max(*from, *to);
}

std::array<double, 2> displacements(const EllipticTrammel& mechanism, double link_angle) {
  const Vec2d link = unit_vector(link_angle);
  const double scale = mechanism.length / mechanism.second_line.y;
  return {-scale * cross(link, mechanism.second_line), scale * link.y};
}

double stroke(const EllipticTrammel& mechanism) {
  return 2 * mechanism.length / std::abs(mechanism.second_line.y);
}

std::array<SliderPosition, 2> limits(const EllipticTrammel& mechanism, int pin) {
  const double scale = mechanism.length / mechanism.second_line.y;
  return extremes_across(pin == 0 ? mechanism.second_line : Vec2d{1, 0}, -scale, 0);
}

double pressure_angle(const EllipticTrammel& mechanism, int pin, double link_angle) {
  return acute(unit_vector(link_angle), pin == 0 ? Vec2d{1, 0} : mechanism.second_line);
}

Ellipse path(const EllipticTrammel& mechanism, const Vec2d& at) {
  // With e = e^{iθ} and g = e^{iγ}, the first pin is at −l Im(ē g)/sin γ and the point at + e·`at`
  // from there: terms in e and in ē.
  const Vec2d& g = mechanism.second_line;
  const double half = mechanism.length / (2 * g.y);
  const Vec2d with = at - half * perp(conj(g));
  const Vec2d against = half * perp(g);
  const double a = norm(with), b = norm(against);
  // The two vectors meet where θ turns them to the same direction, half way between.
  const double half_way = (angle_of(with) + angle_of(against)) / 2;
  const Vec2d direction = mechanism.direction * unit_vector(half_way);
  return {mechanism.centre, a + b, std::abs(a - b), direction};
}

CardanCircles cardan_circles(const EllipticTrammel& mechanism) {
  const Vec2d& g = mechanism.second_line;
  const double half = mechanism.length / (2 * g.y);
  return {2 * std::abs(half), std::abs(half), half * perp(conj(g))};
}

double eccentricity(const OldhamCoupling& mechanism) {
  return norm(mechanism.pivot_d - mechanism.pivot_a);
}

double stroke(const OldhamCoupling& mechanism) {
  return 2 * eccentricity(mechanism) / std::abs(mechanism.slot.y);
}

Circle disc_path(const OldhamCoupling& mechanism) {
  // The chord A–D is seen from the disc's centre under the constant angle β of the tongues, so from
  // the circle's centre under 2β.
  const Vec2d half = 0.5 * (mechanism.pivot_d - mechanism.pivot_a);
  const double height = mechanism.slot.x / mechanism.slot.y;
  return {mechanism.pivot_a + half + height * perp(half), norm(half) / std::abs(mechanism.slot.y)};
}

double transmission_angle(const OldhamCoupling& mechanism) {
  return std::atan2(std::abs(mechanism.slot.y), std::abs(mechanism.slot.x));
}

}  // namespace cognate
