/// Exact function generators are assembled over their whole motion, or have a circuit defect.
#include "tests/stress/exact_functions.hpp"

#include <gtest/gtest.h>

namespace cognate::problems {
namespace {

TEST(ExactFunctions, OfRandomProblemsCloseOverTheWholeMotion) {
  ExactFunctionStress stress(1, 3001);
  ExactFunctionCount count;
  for (int i = 0; i < 120; ++i) stress.add(count);
  EXPECT_EQ(count.problems, 120);
  EXPECT_EQ(count.refused, 0);
  EXPECT_GT(count.sound, 36);
  EXPECT_GT(count.defective, 12);
  EXPECT_EQ(count.gaps, 0) << count.first;
  EXPECT_EQ(count.false_defects, 0) << count.first;
}

}  // namespace
}  // namespace cognate::problems
