/// @file What the search for guided bodies in a page leaves out: mechanisms with slides. What it
/// finds are four-bars, of which their dimensions say everything.
#include <cstdlib>

#include "problems/evaluation/mechanism_metrics.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems {

NamedMechanism named(const MechanismDescription& description) {
  NamedMechanism mechanism;
  mechanism.description = description;
  return mechanism;
}

void add_point(NamedMechanism& /*mechanism*/, const std::string& /*name*/,
               const std::string& /*body*/, const Vec2d& /*at*/) {}

Metrics mechanism_metrics(const NamedMechanism& /*mechanism*/,
                          std::span<const DriveState> /*states*/, PointOrder /*order*/) {
  std::abort();
}

std::vector<ConstraintCheck> check_constraints(const Constraints& constraints, const Bounds& bounds,
                                               const NamedMechanism& mechanism,
                                               const Metrics& metrics) {
  return check_constraints(constraints, bounds, Given{}, *mechanism.four_bar(), metrics);
}

}  // namespace cognate::problems
