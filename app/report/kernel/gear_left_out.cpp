/// @file What the kernel of the pages leaves out of gears: that a problem is sound, which its
/// reader has just seen, and the sieve of combinations, of which one that is whole has one.
#include "problems/gear/combinations.hpp"
#include "problems/gear/problem.hpp"

namespace cognate::problems {

tl::expected<GearProblem, std::vector<std::string>> KindTraits<GearProblem>::checked(
    const GearProblem& problem) {
  return problem;
}

tl::expected<GearPairProblem, std::vector<std::string>> KindTraits<GearPairProblem>::checked(
    const GearPairProblem& problem) {
  return problem;
}

Sieved sieve(const GearPairProblem& /*problem*/, const Deadline& /*deadline*/) {
  return {};
}

}  // namespace cognate::problems
