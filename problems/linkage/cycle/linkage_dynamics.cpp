#include "problems/linkage/cycle/linkage_dynamics.hpp"

#include <array>

#include "analysis/linkage/four_bar.hpp"

namespace cognate::problems {
namespace {

std::vector<Inertia> inertias(const FourBar& linkage, const Operation& operation) {
  const std::array lengths{linkage.crank, linkage.coupler, linkage.rocker};
  std::vector<Inertia> all(1);  // the frame
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const LinkMass& link = operation.links.at(i);
    const double rod = link.mass_per_length * lengths.at(i);
    all.push_back({link.mass + rod, attached(linkage, link.centre).at,
                   link.moment + rod * lengths.at(i) * lengths.at(i) / 12});
  }
  return all;
}

}  // namespace

Attached<double> attached(const FourBar& linkage, const LinkPlace& place) {
  const std::array lengths{linkage.crank, linkage.coupler, linkage.rocker};
  const auto link = static_cast<std::size_t>(place.link);
  const Vec2d at = place.at_coupler_point ? linkage.coupler_point.value_or(Vec2d{})
                                          : Vec2d{place.share * lengths.at(link), 0} + place.offset;
  return {1 + static_cast<int>(place.link), at};
}

LinkageDynamics::LinkageDynamics(const FourBar& linkage, const Operation& operation)
    : motion_(as_mechanism(linkage)),
      dynamics_(motion_.mechanism(), inertias(linkage, operation), operation.gravity),
      speed_(operation.speed) {
  for (const WorkingLoad& load : operation.loads) {
    const Load acting{attached(linkage, load.at), load.force, load.torque};
    if (load.sense != LoadSense::retreat) forward_.push_back(acting);
    if (load.sense != LoadSense::advance) backward_.push_back(acting);
  }
}

double LinkageDynamics::drive(const DriveRate& rate) const {
  const bool forward = rocker_rate() * speed_ > 0;
  return dynamics_.drive(motion_.bodies(), rate, forward ? forward_ : backward_);
}

}  // namespace cognate::problems
