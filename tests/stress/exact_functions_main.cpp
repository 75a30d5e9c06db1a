/// Random exact function generators by the thousand: exact_functions [COUNT [SEED]].
#include <fmt/core.h>

#include <cstdlib>

#include "tests/stress/exact_functions.hpp"

int main(int argc, char** argv) {
  using namespace cognate::problems;
  const int count = argc > 1 ? std::atoi(argv[1]) : 10000;
  ExactFunctionStress stress(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1, 30001);
  ExactFunctionCount found;
  for (int i = 0; i < count; ++i) stress.add(found);
  fmt::print(
      "{} problems: {} refused, {} without a design; {} sound designs, {} of them with a gap; {} "
      "with a circuit defect, {} of them without a gap\n{}",
      found.problems, found.refused, found.without_design, found.sound, found.gaps, found.defective,
      found.false_defects, found.first);
  return found.gaps + found.false_defects == 0 ? 0 : 1;
}
