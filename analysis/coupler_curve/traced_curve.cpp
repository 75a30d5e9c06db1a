#include "analysis/coupler_curve/traced_curve.hpp"

#include <algorithm>

namespace cognate {
namespace {

double unit_of(const Lengths<double>& links) {
  return std::ldexp(1.0,
                    std::ilogb(std::max({links.crank, links.coupler, links.rocker, links.frame})));
}

Lengths<double> divided(const Lengths<double>& links, double unit) {
  return {links.crank / unit, links.coupler / unit, links.rocker / unit, links.frame / unit};
}

}  // namespace

TracedCurve::TracedCurve(const FourBar& linkage, std::optional<int> circuit)
    : unit_(unit_of(lengths(linkage))),
      links_(divided(lengths(linkage), unit_)),
      point_((1 / unit_) * *linkage.coupler_point),
      arm_(norm(point_)),
      circuits_(links_) {
  if (circuit) circuits_.keep(*circuit);
  samples_.reserve(circuits_.arcs().size() * (kCells + 1));
  for (const CircuitArc& arc : circuits_.arcs()) {
    for (int k = 0; k <= kCells; ++k) samples_.push_back(at({&arc, place_of(arc, k)}));
  }
}

TracedPoint TracedCurve::at(const ArcPlace& where) const {
  const LinkPose pose = circuits_.at(*where.arc, where.place);
  const BodyMotion<double, 3> coupler = coupler_motion(links_, pose);
  return {pose, point_motion(coupler, point_),
          std::sqrt(squared_norm(coupler.origin[1])) + std::abs(coupler.turn[0]) * arm_};
}

bool TracedCurve::moves(const ArcPlace& where) const {
  constexpr double kStill = 1e-7;
  const auto [e1, e2, e3] = circuits_.at(*where.arc, where.place);
  return std::max({std::abs(cross(e2, e3)), std::abs(cross(e3, e1)), std::abs(cross(e1, e2))}) >
         kStill;
}

}  // namespace cognate
