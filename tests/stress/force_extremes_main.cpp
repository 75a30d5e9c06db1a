/// Extremes of driving torques and reactions of random linkages against brute force:
/// `force_extremes [COUNT [SEED]]` (10 000, 1). Exit status 1 where any disagrees.
#include <fmt/core.h>

#include <cstdlib>

#include "tests/stress/force_brute.hpp"

int main(int count, char** arguments) {
  const int linkages = count > 1 ? std::atoi(arguments[1]) : 10'000;
  const auto seed = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  const auto tally = cognate::stress::check_forces(seed, linkages);
  fmt::print(
      "{} linkages: {} extremes compared, worst relative difference {:.2g}; {} unbounded; {} of "
      "both "
      "are reactions; {} disagreements\n{}",
      tally.linkages, tally.bounded, tally.worst, tally.unbounded, tally.reactions,
      tally.disagreements, tally.first_file);
  return tally.disagreements > 0 ? 1 : 0;
}
