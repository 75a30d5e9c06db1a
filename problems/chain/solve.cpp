#include "problems/chain/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

Result solve(const ChainPathProblem& problem, const Run& /*run*/) {
  const auto valid = KindTraits<ChainPathProblem>::checked(problem);
  if (!valid) return refused<Result>(valid.error());
  return {};
}

}  // namespace cognate::problems
