#include "problems/path/crank_sense.hpp"

#include <optional>
#include <string>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {

ConstraintCheck check_sense(CrankSense wanted, std::span<const double> crank_angles) {
  double forward = 0, backward = 0;  // angle turned from point to point when going one way only
  for (std::size_t j = 0; j + 1 < crank_angles.size(); ++j) {
    forward += in_one_turn(crank_angles[j + 1] - crank_angles[j]);
    backward += in_one_turn(crank_angles[j] - crank_angles[j + 1]);
  }
  const std::string found = forward <= backward ? "ccw" : "cw";
  const std::string bound = wanted == CrankSense::ccw ? "ccw" : "cw";
  return {"crank_sense", found, bound, found == bound};
}

PossibleSenses senses_between(const PathProblem& problem) {
  // A last point that repeats the first comes a whole turn later, to rounding.
  constexpr double kWholeTurn = kTurn * (1 + 1e-9);
  double forward = 0, backward = 0;
  std::optional<double> before;
  for (std::size_t j = 0; j < problem.points.size(); ++j) {
    if (!problem.is_timed(j)) continue;
    const double angle = problem.crank_angles[j];
    if (before) {
      forward += in_one_turn(angle - *before);
      backward += in_one_turn(*before - angle);
    }
    before = angle;
  }
  return {forward <= kWholeTurn, backward <= kWholeTurn};
}

}  // namespace cognate::problems
