#include <cmath>

#include "tests/bench/kernel/references.hpp"

namespace cognate::bench {

template <class Real>
void textbook(const FourBar& linkage, std::span<const Real> angles, std::span<Real> x,
              std::span<Real> y) {
  const auto links = lengths(linkage);
  const Real l1 = static_cast<Real>(links.crank), l2 = static_cast<Real>(links.coupler);
  const Real l3 = static_cast<Real>(links.rocker), l4 = static_cast<Real>(links.frame);
  const Real side = static_cast<Real>(sign(linkage.assembly));
  const Real frame = static_cast<Real>(frame_angle(linkage));
  const Real u = static_cast<Real>(linkage.coupler_point->x);
  const Real v = static_cast<Real>(linkage.coupler_point->y);
  const Real ax = static_cast<Real>(linkage.pivot_a.x), ay = static_cast<Real>(linkage.pivot_a.y);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const Real bx = l1 * std::cos(angles[i]), by = l1 * std::sin(angles[i]);
    const Real dx = l4 - bx, dy = -by;
    const Real diagonal = std::sqrt(dx * dx + dy * dy);
    const Real at_b = std::acos((l2 * l2 + diagonal * diagonal - l3 * l3) / (2 * l2 * diagonal));
    const Real phi = frame + std::atan2(dy, dx) + side * at_b;
    const Real theta = frame + angles[i];
    x[i] = ax + l1 * std::cos(theta) + u * std::cos(phi) - v * std::sin(phi);
    y[i] = ay + l1 * std::sin(theta) + u * std::sin(phi) + v * std::cos(phi);
  }
}

template void textbook(const FourBar&, std::span<const double>, std::span<double>,
                       std::span<double>);
template void textbook(const FourBar&, std::span<const float>, std::span<float>, std::span<float>);

}  // namespace cognate::bench
