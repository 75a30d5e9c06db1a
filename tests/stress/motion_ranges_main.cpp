/// Swings, strokes, classes, dead points and transmission of random mechanisms against brute force:
/// `motion_ranges [COUNT [SEED]]` (10 000, 1), and a quarter as many six-bars. Exit status 1 where
/// any disagrees.
#include <fmt/core.h>

#include <cstdlib>

#include "tests/stress/ranges/range_stress.hpp"

namespace {

void print(const char* what, const cognate::stress::RangeTally& tally) {
  fmt::print(
      "{} {}: {} at change points, {} near; {} do not close, {} have several ranges; {} values, {} "
      "disagreements\n",
      tally.mechanisms, what, tally.at_ties, tally.near_ties, tally.none_closes,
      tally.several_ranges, tally.all_compared(), tally.all_disagreements());
  for (const auto& [name, number] : tally.compared) {
    const auto wrong = tally.disagreements.find(name);
    fmt::print("  {:34} {:7} {:7}\n", name, number,
               wrong == tally.disagreements.end() ? 0 : wrong->second);
  }
  for (const auto& [name, file] : tally.first) fmt::print("{}\n", file);
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 10'000;
  const auto seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const auto loops = cognate::stress::check_loops(seed, count);
  print("mechanisms of one loop", loops);
  const auto chains = cognate::stress::check_chains(seed, count / 4);
  print("six-bars", chains);
  return chains.all_disagreements() + loops.all_disagreements() > 0 ? 1 : 0;
}
