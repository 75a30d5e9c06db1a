/// @file What must hold of every analysis that the reader accepts, for any file.
#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <variant>

#include "analysis/mechanism/kinematics.hpp"
#include "problems/evaluation/problem.hpp"

namespace cognate::problems {

/// Bodies before `first` are those that a dyad whose own bodies begin there may depend on.
inline bool hangs_on_bodies_before(const Dyad<double>& dyad, int first) {
  const auto before = [&](const auto&... parts) {
    return (... && (parts.body >= 0 && parts.body < first));
  };
  struct Visitor {
    decltype(before)& check;
    bool operator()(const Rrr<double>& d) const { return check(d.first, d.second); }
    bool operator()(const Rrp<double>& d) const { return check(d.point, d.guide); }
    bool operator()(const Rpr<double>& d) const { return check(d.block, d.pivot); }
    bool operator()(const Prp<double>& d) const { return check(d.first, d.second); }
    bool operator()(const Rpp<double>& d) const { return check(d.point, d.guide); }
    bool operator()(const Cylinder<double>& d) const { return check(d.base, d.pivot); }
    bool operator()(const Group& group) const {
      const auto bodies = static_cast<int>(group.drawn.size());
      return std::ranges::all_of(group.joints, [&](const GroupJoint& joint) {
        const int lesser = joint.first.body, greater = joint.second.body;
        return 0 <= lesser && lesser < first + bodies && first <= greater &&
               greater < first + bodies;
      });
    }
    bool operator()(const GroupRest&) const { return true; }
    int first;
  };
  return std::visit(Visitor{before, first}, dyad);
}

/// Whether the parts of `problem` refer to one another as they may, every body and point has a
/// name of its own, the numbers are finite, and the mechanism can be evaluated.
inline bool is_sound(const AnalysisProblem& problem) {
  const NamedMechanism& named = problem.mechanism;
  const Mechanism<double>& mechanism = named.mechanism;
  const int bodies = body_count(mechanism);
  const auto is_body = [&](int body) { return body >= 0 && body < bodies; };
  bool sound = static_cast<int>(named.bodies.size()) == bodies &&
               static_cast<int>(problem.inertias.size()) == bodies && is_body(named.output);
  for (std::size_t i = 0; i < mechanism.dyads.size(); ++i) {
    const int first = first_body(mechanism, static_cast<int>(i));
    sound = sound && hangs_on_bodies_before(mechanism.dyads[i], first);
  }
  std::set<std::string> names(named.bodies.begin(), named.bodies.end());
  sound = sound && names.size() == named.bodies.size();
  names.clear();
  for (const NamedPoint& point : named.points) {
    sound = sound && is_body(point.at.body) && std::isfinite(point.at.at.x + point.at.at.y);
    names.insert(point.name);
  }
  sound = sound && names.size() == named.points.size();
  for (const LoadRule& load : problem.loads) {
    sound = sound && is_body(load.at.body) && load.at.body > 0 &&
            std::isfinite(load.at.at.x + load.at.at.y + load.force.x + load.force.y + load.torque);
  }
  for (const Inertia& inertia : problem.inertias) {
    sound = sound && inertia.mass >= 0 && inertia.moment >= 0 &&
            std::isfinite(inertia.mass + inertia.moment + inertia.centre.x + inertia.centre.y);
  }
  for (const int point : problem.output.points) {
    sound = sound && point >= 0 && point < static_cast<int>(named.points.size());
  }
  for (const int body : problem.output.instant_geometry) {
    sound = sound && is_body(body) && body > 0;
  }
  const DriveSweep& drive = problem.drive;
  sound = sound && drive.steps >= 1 && drive.steps <= 1'000'000 && drive.start != drive.end &&
          std::isfinite(drive.start + drive.end + drive.rate.speed + drive.rate.acceleration);
  if (sound) MechanismMotion<2>(mechanism).move_to(drive.start);
  return sound;
}

}  // namespace cognate::problems
