/// @file What the searches for guided bodies and straight lines in a page leave out: mechanisms
/// with slides. What they find are four-bars, of which their dimensions say everything.
#include <vector>

#include "problems/evaluation/mechanism_metrics.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems {

NamedMechanism named(const MechanismDescription& description) {
  NamedMechanism mechanism;
  mechanism.description = description;
  mechanism.mechanism = as_mechanism(*mechanism.four_bar());
  return mechanism;
}

void add_point(NamedMechanism& /*mechanism*/, const std::string& /*name*/,
               const std::string& /*body*/, const Vec2d& /*at*/) {}

Metrics mechanism_metrics(const NamedMechanism& mechanism, std::span<const DriveState> states,
                          PointOrder order) {
  std::vector<double> drives;
  for (const DriveState& state : states) drives.push_back(state.drive);
  return design_metrics(*mechanism.four_bar(), drives, {order, false});
}

std::vector<ConstraintCheck> check_constraints(const Constraints& constraints, const Bounds& bounds,
                                               const NamedMechanism& mechanism,
                                               const Metrics& metrics) {
  return check_constraints(constraints, bounds, Given{}, *mechanism.four_bar(), metrics);
}

}  // namespace cognate::problems
