// How the layers of random six-bars stand against brute force: layers [CASES] [ENUMERATED] [SEED].

#include <fmt/core.h>

#include <cstdlib>
#include <string>

#include "tests/stress/layers_cases.hpp"

int main(int argc, char** argv) {
  using namespace cognate::test;
  const int cases = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int enumerated = argc > 2 ? std::atoi(argv[2]) : cases;
  const unsigned seed = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1;
  std::mt19937 random(seed);
  LayerCounts counts;
  int faults = 0;
  for (int i = 0; i < cases; ++i) {
    const LayerCase given = random_six_bar(random);
    const std::string fault = fault_of_layers(given, 1440, i < enumerated, counts);
    if (fault.empty()) continue;
    ++faults;
    fmt::print("case {}: {}\n", i, fault);
  }
  fmt::print(
      "{} six-bars: {} in layers, {} in none; {} pairs undecided; {} against brute force; "
      "least room {:.3g}\n",
      cases, counts.assigned, counts.impossible, counts.unresolved, faults,
      -counts.greatest_interference);
  return faults == 0 ? 0 : 1;
}
