#include "problems/guidance/closure.hpp"

#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;
using synthesis::Pose;

/// A range of a cosine and the direction from which its angle counts.
struct CosineRange {
  double centre = 0;
  double low = -1, high = 1;
};

/// For |pin − D| between two distances, the pin going round A on a circle of radius `crank`.
CosineRange within(double crank, const Vec2d& frame, double least, double greatest) {
  const double apart = norm(frame), both = 2 * crank * apart;
  const double sum = crank * crank + apart * apart;
  return {std::atan2(frame.y, frame.x), (sum - greatest * greatest) / both,
          (sum - least * least) / both};
}

CosineRange cosine_range(DyadKind kind, const GuidingDyad& crank, const SecondDyad& second) {
  const Vec2d point{second[0], second[1]};
  if (kind == DyadKind::rr) {
    const double coupler = norm(point - crank.in_body), rocker = second[4];
    return within(crank.length, Vec2d{second[2], second[3]} - crank.fixed,
                  std::abs(coupler - rocker), coupler + rocker);
  }
  const Vec2d n = unit_vector(second[2]);
  if (kind == DyadKind::pr) {
    const double away = second[3] - dot(n, crank.fixed), reach = norm(point - crank.in_body);
    return {second[2], (away - reach) / crank.length, (away + reach) / crank.length};
  }
  return within(crank.length, point - crank.fixed, std::abs(second[3] - dot(n, crank.in_body)),
                kInfinity);
}

/// The line's point nearest to `near`.
Vec2d on_line(const Vec2d& near, const Vec2d& normal, double offset) {
  return near + (offset - dot(normal, near)) * normal;
}

}  // namespace

SecondDyad second_dyad(const GuidingDyad& dyad) {
  const Vec2d normal = perp(dyad.direction);
  const double angle = std::atan2(normal.y, normal.x);
  switch (dyad.kind) {
    case DyadKind::rr:
      return {dyad.in_body.x, dyad.in_body.y, dyad.fixed.x, dyad.fixed.y, dyad.length};
    case DyadKind::pr:
      return {dyad.in_body.x, dyad.in_body.y, angle, dot(normal, dyad.fixed), 0};
    case DyadKind::rp:
      break;
  }
  return {dyad.fixed.x, dyad.fixed.y, angle, dot(normal, dyad.in_body), 0};
}

GuidingDyad guiding_dyad(DyadKind kind, const SecondDyad& second, const Pose& first) {
  const Vec2d at{second[0], second[1]};
  const Vec2d moving = to_frame(first, at);
  if (kind == DyadKind::rr) return {kind, at, moving, {second[2], second[3]}, {1, 0}, second[4]};
  const Vec2d normal = unit_vector(second[2]);
  if (kind == DyadKind::pr) {
    return {kind, at, moving, on_line(moving, normal, second[3]), -perp(normal)};
  }
  return {kind, on_line(to_body(first, at), normal, second[3]), at, at, -perp(normal)};
}

double TurnCondition::discriminant() const {
  const double size = norm(k);
  return (size - h) * (size + h);
}

Vec2d TurnCondition::turn(double sign) const {
  const Vec2d value{h, sign * std::sqrt(discriminant())};
  return (1 / squared_norm(k)) * (value * conj(k));
}

TurnCondition turn_condition(DyadKind kind, const SecondDyad& second, const Vec2d& first,
                             const Vec2d& pin) {
  const Vec2d point{second[0], second[1]};
  if (kind == DyadKind::rr) {
    const Vec2d away = pin - Vec2d{second[2], second[3]}, m = point - first;
    const double length = second[4];
    return {conj(away) * m, 0.5 * (length * length - squared_norm(away) - squared_norm(m))};
  }
  const Vec2d n = unit_vector(second[2]);
  if (kind == DyadKind::pr) return {conj(n) * (point - first), second[3] - dot(n, pin)};
  return {n * conj(point - pin), second[3] - dot(n, first)};
}

TurnSlopes turn_slopes(DyadKind kind, const SecondDyad& second, const Vec2d& first,
                       const Vec2d& pin, const Vec2d& turn) {
  const Vec2d point{second[0], second[1]};
  if (kind == DyadKind::rr) {
    const Vec2d arm = turn * (point - first);
    const Vec2d link = pin + arm - Vec2d{second[2], second[3]}, in_body = conj(turn) * link;
    return {
        dot(link, perp(arm)), link, -in_body, {in_body.x, in_body.y, -link.x, -link.y, -second[4]}};
  }
  const Vec2d n = unit_vector(second[2]);
  if (kind == DyadKind::pr) {
    const Vec2d arm = turn * (point - first), in_body = conj(turn) * n;
    return {dot(n, perp(arm)), n, -in_body, {in_body.x, in_body.y, dot(perp(n), pin + arm), -1, 0}};
  }
  const Vec2d seen = conj(turn) * (point - pin), across = turn * n;
  return {-dot(n, perp(seen)), -across, n, {across.x, across.y, dot(perp(n), seen + first), -1, 0}};
}

std::vector<CrankRange> closing_arcs(DyadKind kind, const GuidingDyad& crank,
                                     const SecondDyad& second) {
  const auto [centre, low, high] = cosine_range(kind, crank, second);
  if (!(low <= high) || low > 1 || high < -1) return {};
  const double nearest = high >= 1 ? 0 : std::acos(high),
               farthest = low <= -1 ? kPi : std::acos(low);
  if (nearest == 0 && farthest == kPi) return {{centre, centre + kTurn}};
  if (nearest == 0) return {{centre - farthest, centre + farthest}};
  if (farthest == kPi) return {{centre + nearest, centre + kTurn - nearest}};
  return {{centre + nearest, centre + farthest}, {centre - farthest, centre - nearest}};
}

}  // namespace cognate::problems
