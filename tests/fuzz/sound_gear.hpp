/// @file What must hold of every gear and gear pair that the reader accepts, for any file.
#pragma once

#include <algorithm>
#include <cmath>

#include "problems/gear/result.hpp"
#include "problems/train/result.hpp"

namespace cognate::problems {

inline bool is_sound(const gear::BasicRack& rack) {
  return rack.pressure_angle > 0 && rack.pressure_angle < 1.6 && rack.addendum > 0 &&
         std::isfinite(rack.addendum) && std::isfinite(rack.clearance);
}

inline bool may_have(int teeth) {
  return teeth >= kFewestTeeth && teeth <= kMostTeeth;
}

/// A gear can be analysed: it has a table, or a note says why it cannot be.
inline bool is_sound(const GearProblem& problem) {
  const gear::SpurGear& normal = problem.gear.normal;
  if (!is_sound(normal.rack) || !may_have(static_cast<int>(normal.teeth))) return false;
  if (!(normal.module > 0) || !std::isfinite(normal.profile_shift)) return false;
  const GearResult result = analyse(problem, {});
  return result.status == Status::solved ? !result.columns.empty() : !result.notes.empty();
}

/// A pair with nothing left to find can be reported; of others the choices are real ones.
inline bool is_sound(const GearPairProblem& problem) {
  if (!is_sound(problem.rack)) return false;
  if (is_whole(problem)) {
    const GearPairResult result = solve(problem, {});
    return result.status == Status::solved ? !result.designs.empty() : !result.notes.empty();
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [fewest, most] = problem.teeth_bounds[i];
    if (problem.teeth[i] ? !may_have(*problem.teeth[i])
                         : !may_have(fewest) || !may_have(most) || fewest > most) {
      return false;
    }
  }
  const auto is_positive = [](double module) { return module > 0 && std::isfinite(module); };
  return problem.module
             ? is_positive(*problem.module)
             : !problem.modules.empty() && std::ranges::all_of(problem.modules, is_positive);
}

/// A train that is given can be analysed, and all its speeds are finite.
inline bool is_sound(const GearTrainProblem& problem) {
  if (problem.target) return problem.target->teeth[0] <= problem.target->teeth[1];
  const GearTrainResult result = solve(problem, {});
  if (result.designs.empty()) return false;
  return std::ranges::all_of(result.designs, [](const GearTrainDesign& design) {
    return std::ranges::all_of(design.members, [](const TrainMember& member) {
      return std::isfinite(member.speed) && std::isfinite(member.torque.value_or(0));
    });
  });
}

}  // namespace cognate::problems
