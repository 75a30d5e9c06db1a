#include "problems/evaluation/closure_residual.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cognate::problems {
namespace {

using Bodies = std::span<const Placement>;

double gap(Bodies bodies, const Attached<double>& a, const Attached<double>& b) {
  return norm(place(bodies, a) - place(bodies, b));
}

/// The distance of a body's origin from its guide.
double off_guide(Bodies bodies, int body, const Guide<double>& guide) {
  const Vec2d u = bodies[static_cast<std::size_t>(guide.body)].direction * guide.direction;
  const Vec2d along = place(bodies, {body, {}}) - place(bodies, {guide.body, guide.through});
  return std::abs(cross(u, along) - guide.offset);
}

double residual(const Crank<double>& crank, Bodies bodies) {
  return norm(bodies[1].origin - crank.pivot);
}

double residual(const DrivingSlider<double>& slider, Bodies bodies) {
  return off_guide(bodies, 1, slider.guide);
}

double residual(const FloatingLink<double>& link, Bodies bodies) {
  return std::max({off_guide(bodies, 2, link.first), off_guide(bodies, 3, link.second),
                   gap(bodies, {1, {}}, {2, {}}), gap(bodies, {1, {link.length, 0}}, {3, {}})});
}

// The dyads, whose bodies are n and n + 1.

double residual(const Rrr<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, dyad.first, {n, {}}), gap(bodies, dyad.second, {n + 1, {}}),
                   gap(bodies, {n, {dyad.first_length, 0}}, {n + 1, {dyad.second_length, 0}})});
}

double residual(const Rrp<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, dyad.point, {n, {}}),
                   gap(bodies, {n, {dyad.length, 0}}, {n + 1, {}}),
                   off_guide(bodies, n + 1, dyad.guide)});
}

double residual(const Rpr<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, dyad.block, {n, {}}), gap(bodies, dyad.pivot, {n + 1, {}}),
                   off_guide(bodies, n, {n + 1, {}, {1, 0}, dyad.offset})});
}

double residual(const Prp<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, {n, {}}, {n + 1, {}}), off_guide(bodies, n, dyad.first),
                   off_guide(bodies, n + 1, dyad.second)});
}

double residual(const Rpp<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, dyad.point, {n, {}}),
                   off_guide(bodies, n, {n + 1, {}, dyad.slot, 0}),
                   off_guide(bodies, n + 1, dyad.guide)});
}

}  // namespace

Vec2d place(Bodies bodies, const Attached<double>& point) {
  const Placement& body = bodies[static_cast<std::size_t>(point.body)];
  return body.origin + body.direction * point.at;
}

double closure_residual(const Mechanism<double>& mechanism, Bodies bodies) {
  double greatest =
      std::visit([&](const auto& drive) { return residual(drive, bodies); }, mechanism.drive);
  int body = first_body(mechanism, 0);
  for (const auto& dyad : mechanism.dyads) {
    greatest = std::max(
        greatest,
        std::visit([&](const auto& group) { return residual(group, bodies, body); }, dyad));
    body += 2;
  }
  return greatest;
}

double extent(Bodies bodies) {
  double greatest = 0;
  for (const auto& body : bodies) greatest = std::max(greatest, norm(body.origin));
  return greatest;
}

}  // namespace cognate::problems
