#include "problems/gear/pair_helix.hpp"

#include <cmath>

#include "problems/gear/pair_limits.hpp"

namespace cognate::problems {
namespace {

double distance_with(GearPairProblem problem, double helix) {
  problem.helix = helix;
  const GearPairNumbers numbers{.teeth = {*problem.teeth[0], *problem.teeth[1]},
                                .module = *problem.module,
                                .shift = {*problem.profile_shift[0], *problem.profile_shift[1]}};
  return gear::centre_distance_with_backlash(section_of(problem, numbers).gears,
                                             problem.backlash.value_or(0));
}

bool has_all_but_helix(const GearPairProblem& problem) {
  return problem.teeth[0] && problem.teeth[1] && problem.module && problem.profile_shift[0] &&
         problem.profile_shift[1];
}

/// Bisection to the last bit: the distance grows with the helix, from `least` on.
double bisected(const GearPairProblem& problem) {
  double below = 0, above = kGreatestHelix;
  for (double middle = 0.5 * above; below < middle && middle < above;
       middle = 0.5 * (below + above)) {
    (distance_with(problem, middle) < *problem.centre_distance ? below : above) = middle;
  }
  return above;
}

}  // namespace

std::optional<std::array<double, 2>> distances_of_helices(const GearPairProblem& problem) {
  if (!has_all_but_helix(problem)) return std::nullopt;
  return {{distance_with(problem, 0), distance_with(problem, kGreatestHelix)}};
}

std::optional<double> helix_of_distance(const GearPairProblem& problem) {
  const auto distances = distances_of_helices(problem);
  const double wanted = problem.centre_distance.value_or(NAN);
  if (!distances || !((*distances)[0] < wanted && wanted <= (*distances)[1])) return std::nullopt;
  const bool is_plain = *problem.profile_shift[0] + *problem.profile_shift[1] == 0 &&
                        problem.backlash.value_or(0) == 0;
  if (!is_plain) return bisected(problem);
  return std::acos(*problem.module * (*problem.teeth[0] + *problem.teeth[1]) / (2 * wanted));
}

}  // namespace cognate::problems
