/// Batches keep the closure's bounds on every instruction set of this machine, in double and float.
#include "tests/stress/batch_accuracy.hpp"

#include <gtest/gtest.h>

namespace cognate::stress {
namespace {

constexpr int kDesigns = 60;

void expect_bounds(const Accuracy& accuracy, const char* what) {
  EXPECT_GT(accuracy.closed, 200) << what;
  EXPECT_LE(accuracy.well_conditioned, 10) << what;
  EXPECT_LE(accuracy.per_condition, 2) << what;
  EXPECT_LE(accuracy.wrong_flag_distance, 2) << what;
}

TEST(BatchAccuracy, KeepsTheClosuresBounds) {
  const auto families = closure_families();
  for (const InstructionSet set : instruction_sets()) {
    for (const Family& family : {families[0], families[1], families[2]}) {
      expect_bounds(batch_accuracy<double>(family, set, kDesigns, 5), name(set));
    }
    for (const Family& family : {families[0], families[1]}) {
      expect_bounds(batch_accuracy<float>(family, set, kDesigns, 6), name(set));
    }
  }
}

}  // namespace
}  // namespace cognate::stress
