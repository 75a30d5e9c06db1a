#include "problems/crank_sense.hpp"

#include <string>

#include "analysis/angle.hpp"

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

}  // namespace cognate::problems
