/// @file What the kernel of the pages leaves out of gear trains: that a problem is sound, which its
/// reader has just seen, and the search, which has nothing to find where all is given.
#include "problems/train/problem.hpp"
#include "problems/train/search.hpp"

namespace cognate::problems {

tl::expected<GearTrainProblem, std::vector<std::string>> KindTraits<GearTrainProblem>::checked(
    const GearTrainProblem& problem) {
  return problem;
}

void find_trains(const GearTrainProblem& /*problem*/, const Deadline& /*deadline*/,
                 GearTrainResult& /*result*/) {}

}  // namespace cognate::problems
