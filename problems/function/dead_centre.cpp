#include "problems/function/dead_centre.hpp"

#include <cmath>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"

namespace cognate::problems {

std::optional<DeadCentre> dead_centre(const Lengths<double>& links, Assembly assembly,
                                      FunctionStart start) {
  const bool outer = start == FunctionStart::outer_dead_centre;
  const auto limit = outer ? outer_limit(links) : inner_limit(links);
  if (!limit) return std::nullopt;
  DeadCentre result;
  result.crank_angle = sign(assembly) * limit->crank_angle;
  result.rocker_angle = sign(assembly) * limit->rocker_angle;
  const Vec2d e1 = unit_vector(result.crank_angle);
  const Vec2d e3 = unit_vector(result.rocker_angle);
  const double side = outer ? 1 : -1;
  const double reach = links.crank + side * links.coupler;
  const double along = dot(e1, e3), across = cross(e1, e3);
  const double by_crank = 1 / (reach * across), by_rocker = -1 / (links.rocker * across);
  result.crank_slope = {-by_crank * along, -by_crank * side * along, by_crank, by_crank * e3.x};
  result.rocker_slope = {by_rocker, by_rocker * side, -by_rocker * along, -by_rocker * e1.x};
  return result;
}

}  // namespace cognate::problems
