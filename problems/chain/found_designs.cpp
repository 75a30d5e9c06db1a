#include "problems/chain/found_designs.hpp"

#include <algorithm>

#include "problems/linkage/verify.hpp"

namespace cognate::problems {

std::vector<Design> feasible_or_all(std::vector<Design> designs, int most) {
  const auto is_feasible = [](const Design& one) { return all_satisfied(one.constraints); };
  if (std::ranges::any_of(designs, is_feasible)) {
    std::erase_if(designs, [&](const Design& one) { return !is_feasible(one); });
  }
  if (designs.size() > static_cast<std::size_t>(most)) {
    designs.resize(static_cast<std::size_t>(most));
  }
  return designs;
}

Status status_of(const std::vector<Design>& designs, const Deadline& deadline) {
  if (deadline.reached()) {
    return deadline.interrupted() ? Status::interrupted : Status::time_limit;
  }
  if (designs.empty()) return Status::no_solution;
  return all_satisfied(designs.front().constraints) ? Status::solved : Status::infeasible;
}

}  // namespace cognate::problems
