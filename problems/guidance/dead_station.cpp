#include "problems/guidance/dead_station.hpp"

#include <cmath>

#include "problems/guidance/dimensions.hpp"

namespace cognate::problems {
namespace {

using namespace motion_dimensions;
using Dimensions = std::array<double, DeadStation::dimensions>;

/// Of coupler and rocker together, squared: with the pin nearer to the far pivot the body would
/// spin about both.
constexpr double kLeastReach = 1e-4;

/// The triangle of coupler, rocker and the distance of pin and far pivot, with the angle at C that
/// a dead point has, but for `from_dead`.
struct Triangle {
  double coupler, rocker, sine, cosine;

  Triangle(double m, double r, bool stretched, double from_dead)
      : coupler(m), rocker(r), sine(std::sin(from_dead)) {
    cosine = stretched ? -std::cos(from_dead) : std::cos(from_dead);
  }
  double squared_distance() const {
    return coupler * coupler + rocker * rocker - 2 * coupler * rocker * cosine;
  }
  /// At the pin, from the far pivot to C, and its derivative by the angle at C.
  double angle() const { return std::atan2(rocker * sine, coupler - rocker * cosine); }
  double angle_slope() const { return rocker * (coupler * cosine - rocker) / squared_distance(); }
};

}  // namespace

std::optional<DeadStation> dead_station(const Dimensions& v, const HeldDeadPoint& at, double side,
                                        double from_dead) {
  const Vec2d a = point(v, kFixed1), d = point(v, kFixed2);
  const Vec2d m = point(v, kMoving2) - point(v, kMoving1), frame = d - a;
  const double crank = v[kLength1], apart = norm(frame), coupler = norm(m);
  const Triangle triangle(coupler, v[kLength2], at.stretched, from_dead);
  const double reach = triangle.squared_distance();
  const double cosine = (crank * crank + apart * apart - reach) / (2 * crank * apart);
  const double links = coupler + triangle.rocker;
  if (!(std::abs(cosine) < 1) || !(reach > kLeastReach * links * links)) return std::nullopt;

  DeadStation station;
  const double beside = std::acos(cosine);
  station.crank_angle = std::atan2(frame.y, frame.x) + (at.left ? beside : -beside);
  const Vec2d u{std::cos(station.crank_angle), std::sin(station.crank_angle)};
  station.pin = a + crank * u;
  const Vec2d b = station.pin - d;
  // Im(K E) = (B − D) × (C − B), where C is to that side of the line from B to D.
  const double to_c = -side * triangle.angle();
  const Vec2d along = (1 / std::sqrt(reach)) * (Vec2d{std::cos(to_c), std::sin(to_c)} * -b);
  station.turn = along * conj((1 / coupler) * m);

  const double by_angle = crank * dot(b, perp(u));
  const Vec2d along_m = (1 / coupler) * m;
  const double by_coupler = coupler - triangle.rocker * triangle.cosine;
  const double by_rocker = triangle.rocker - coupler * triangle.cosine;
  const auto set = [&](int dimension, const Vec2d& da, const Vec2d& dd, double dl, const Vec2d& dm,
                       double dr) {
    const double dm_length = dot(along_m, dm);
    const double half_reach = by_coupler * dm_length + by_rocker * dr;
    const double turned = (half_reach - dot(b, da - dd) - dl * dot(b, u)) / by_angle;
    const Vec2d dpin = da + dl * u + crank * turned * perp(u);
    const double opened = triangle.sine * (coupler * dr - triangle.rocker * dm_length) / reach;
    const auto i = static_cast<std::size_t>(dimension);
    station.pin_slopes[i] = dpin;
    station.turn_slopes[i] =
        cross(b, dpin - dd) / reach - side * opened - cross(m, dm) / (coupler * coupler);
  };
  const Vec2d none{}, axes[] = {{1, 0}, {0, 1}};
  for (int i = 0; i < 2; ++i) {
    const Vec2d& axis = axes[i];
    set(kMoving1 + i, none, none, 0, -axis, 0);
    set(kFixed1 + i, axis, none, 0, none, 0);
    set(kMoving2 + i, none, none, 0, axis, 0);
    set(kFixed2 + i, none, axis, 0, none, 0);
  }
  set(kLength1, none, none, 1, none, 0);
  set(kLength2, none, none, 0, none, 1);
  return station;
}

double turn_leaving(const Dimensions& v, const HeldDeadPoint& at, double side) {
  const double coupler = norm(point(v, kMoving2) - point(v, kMoving1));
  const Triangle triangle(coupler, v[kLength2], at.stretched, kHeldFromDead);
  return -side * (at.stretched ? -1 : 1) * triangle.angle_slope();
}

HeldDeadPoint nearest_dead_point(const Dimensions& v, const Vec2d& pin) {
  const Vec2d d = point(v, kFixed2), frame = d - point(v, kFixed1);
  const double coupler = norm(point(v, kMoving2) - point(v, kMoving1));
  const double away = norm(pin - d);
  const double stretched = coupler + v[kLength2], folded = std::abs(coupler - v[kLength2]);
  return {.stretched = std::abs(away - stretched) < std::abs(away - folded),
          .left = cross(frame, pin - point(v, kFixed1)) > 0};
}

}  // namespace cognate::problems
