#include "analysis/mechanism/three_pin_link.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

using Complex = std::complex<double>;
constexpr int kDegree = 6;
using Sextic = std::array<Complex, kDegree + 1>;

/// What remains of the three circles for the link in one direction.
class ClosureByAngle {
 public:
  explicit ClosureByAngle(const ThreePinLink& link) {
    for (std::size_t k = 1; k < 3; ++k) {
      pins_[k - 1] = link.pins[k] - link.pins[0];
      pivots_[k - 1] = link.pivots[k] - link.pivots[0];
    }
    legs_ = link.legs;
    for (const auto& points : {pins_, pivots_}) {
      for (const Vec2d& point : points) size_ = std::max(size_, norm(point));
    }
    for (const double leg : legs_) size_ = std::max(size_, leg);
    for (Vec2d& point : pins_) point = (1 / size_) * point;
    for (Vec2d& point : pivots_) point = (1 / size_) * point;
    for (double& leg : legs_) leg /= size_;
  }

  struct Value {
    double closure = 0;
    double rate = 0;  ///< by the angle
    Vec2d pin{};      ///< the first, from its pivot
  };

  Value at(const Vec2d& direction) const {
    const Vec2d a = direction * pins_[0] - pivots_[0], b = direction * pins_[1] - pivots_[1];
    const Vec2d a1 = perp(direction * pins_[0]), b1 = perp(direction * pins_[1]);
    const double r = reach(1, a), s = reach(2, b);
    const double r1 = -dot(a, a1), s1 = -dot(b, b1);
    const double area = cross(a, b), area1 = cross(a1, b) + cross(a, b1);
    const Vec2d v = r * b - s * a;
    const Vec2d v1 = r1 * b + r * b1 - s1 * a - s * a1;
    const double l2 = legs_[0] * legs_[0];
    return {squared_norm(v) - l2 * area * area, 2 * dot(v, v1) - 2 * l2 * area * area1,
            (-size_ / area) * perp(v)};
  }

 private:
  double reach(std::size_t leg, const Vec2d& a) const {
    return 0.5 * ((legs_[leg] - legs_[0]) * (legs_[leg] + legs_[0]) - squared_norm(a));
  }

  std::array<Vec2d, 2> pins_{}, pivots_{};
  std::array<double, 3> legs_{};
  double size_ = 0;
};

/// The coefficients of u³ f(u), from seven values of f on the unit circle.
Sextic sextic(const ClosureByAngle& closure) {
  constexpr int kValues = kDegree + 1;
  Sextic coefficients{};
  for (int k = 0; k < kValues; ++k) {
    const Vec2d direction = unit_vector(kTurn * k / kValues);
    const double value = closure.at(direction).closure / kValues;
    const Complex back(direction.x, -direction.y);
    Complex power = value * std::conj(back * back * back);
    for (Complex& coefficient : coefficients) {
      coefficient += power;
      power *= back;
    }
  }
  return coefficients;
}

/// 1/z without the care for overflow that the operator takes: all here is of order one.
Complex inverse(const Complex& z) {
  return std::conj(z) / std::norm(z);
}

/// a·b, likewise.
Complex product(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// A polynomial and its derivative.
std::array<Complex, 2> value_of(const Sextic& polynomial, const Complex& u) {
  Complex value = polynomial[kDegree], rate = 0;
  for (int k = kDegree; k-- > 0;) {
    rate = product(rate, u) + value;
    value = product(value, u) + polynomial[static_cast<std::size_t>(k)];
  }
  return {value, rate};
}

/// Aberth's iteration. The roots lie on the unit circle or in pairs on both sides of it.
std::array<Complex, kDegree> roots_of(const Sextic& polynomial) {
  constexpr int kMostSteps = 60;
  constexpr double kSettled = 1e-9;  // after which an iteration of third order is at rounding
  std::array<Complex, kDegree> roots;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    roots[i] = std::polar(i % 2 == 0 ? 0.9 : 1.2, 0.4 + kTurn * static_cast<double>(i) / kDegree);
  }
  for (int step = 0; step < kMostSteps; ++step) {
    double farthest = 0;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const auto [value, rate] = value_of(polynomial, roots[i]);
      Complex repelled = product(rate, inverse(value));
      for (std::size_t j = 0; j < roots.size(); ++j) {
        if (j != i) repelled -= inverse(roots[i] - roots[j]);
      }
      const Complex change = inverse(repelled);
      if (!std::isfinite(change.real()) || !std::isfinite(change.imag())) continue;
      roots[i] -= change;
      farthest = std::max(farthest, std::abs(change));
    }
    if (farthest < kSettled) break;
  }
  return roots;
}

/// Newton's method on the closure itself, from a root of the polynomial.
double refined(const ClosureByAngle& closure, double angle) {
  constexpr int kSteps = 3;
  constexpr double kFarthest = 1e-3;
  double best = angle;
  for (int i = 0; i < kSteps; ++i) {
    const auto value = closure.at(unit_vector(best));
    const double step = value.closure / value.rate;
    if (!(std::abs(step) < kFarthest)) break;
    best -= step;
  }
  return best;
}

/// The joint of a leg and its place on either of the two bodies that it joins, the other first.
struct End {
  Attached<double> other;
  Attached<double> own;
};

std::vector<End> ends_of(const Group& group, int body) {
  std::vector<End> ends;
  for (const GroupJoint& joint : group.joints) {
    if (joint.second.body == body) ends.push_back({joint.first, joint.second});
    if (joint.first.body == body) ends.push_back({joint.second, joint.first});
  }
  return ends;
}

Vec2d pivot_of(const Attached<double>& point, std::span<const Placement> bodies) {
  const Placement& body = bodies[static_cast<std::size_t>(point.body)];
  return body.origin + body.direction * point.at;
}

/// Body `body` of the group as the link, where each of its three pins is that of a leg.
std::optional<ThreePinLink> with_link(const Group& group, int first, int body,
                                      std::span<const Placement> bodies) {
  ThreePinLink link{.body = body, .pins = {}, .pivots = {}};
  const auto pins = ends_of(group, body);
  if (pins.size() != 3) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    auto leg = ends_of(group, pins[i].other.body);
    if (pins[i].other.body < first || leg.size() != 2) return std::nullopt;
    if (leg[0].other.body == body) std::swap(leg[0], leg[1]);
    if (leg[0].other.body >= first) return std::nullopt;
    link.pins[i] = pins[i].own.at;
    link.pivots[i] = pivot_of(leg[0].other, bodies);
    link.legs[i] = norm(leg[0].own.at - pins[i].other.at);
  }
  return link;
}

double extent_of(const ThreePinLink& link) {
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    size = std::max({size, norm(link.pivots[k]), norm(link.pins[k]), link.legs[k]});
  }
  return size;
}

/// Whether all legs have their lengths: where a and b are parallel, the angle alone says nothing.
bool is_closed(const ThreePinLink& link, const Placement& at) {
  constexpr double kClosed = 1e-6;  // a double root is known to half of the digits
  double farthest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double leg = norm(at.origin + at.direction * link.pins[k] - link.pivots[k]);
    if (!std::isfinite(leg)) return false;
    farthest = std::max(farthest, std::abs(leg - link.legs[k]));
  }
  return farthest <= kClosed * extent_of(link);
}

bool is_same(const Placement& a, const Placement& b, const ThreePinLink& link) {
  constexpr double kSame = 1e-7;
  return norm(a.direction - b.direction) <= kSame &&
         norm(a.origin - b.origin) <= kSame * extent_of(link);
}

}  // namespace

std::optional<ThreePinLink> as_three_pin_link(const Group& group, int first,
                                              std::span<const Placement> bodies) {
  const bool has_slide = std::ranges::any_of(group.joints, &GroupJoint::slides);
  if (has_slide || group.drawn.size() != 4) return std::nullopt;
  for (int body = first; body < first + 4; ++body) {
    if (const auto link = with_link(group, first, body, bodies)) return link;
  }
  return std::nullopt;
}

std::vector<Placement> assemblies(const ThreePinLink& link) {
  // A double root is known to half of the digits: as far as this from the circle it may be on it.
  constexpr double kOnCircle = 1e-6;
  const ClosureByAngle closure(link);
  std::vector<double> angles;
  for (const Complex& root : roots_of(sextic(closure))) {
    if (std::abs(std::abs(root) - 1) > kOnCircle) continue;
    angles.push_back(std::remainder(refined(closure, std::arg(root)), kTurn));
  }
  std::ranges::sort(angles);
  std::vector<Placement> all;
  for (const double angle : angles) {
    const Vec2d direction = unit_vector(angle);
    const Vec2d pin = link.pivots[0] + closure.at(direction).pin;
    const Placement at{pin - direction * link.pins[0], direction};
    if (is_closed(link, at) && (all.empty() || !is_same(all.back(), at, link))) all.push_back(at);
  }
  return all;
}

}  // namespace cognate
