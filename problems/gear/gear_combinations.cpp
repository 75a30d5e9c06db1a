#include "problems/gear/gear_combinations.hpp"

#include <algorithm>
#include <tuple>

namespace cognate::problems {
namespace {

/// How many of those refused are kept.
constexpr std::size_t kNearest = 8;
/// Between two looks at the clock.
constexpr std::uint64_t kBlock = 4096;

/// A combination that was refused: by which test, the later the better, and by how much.
struct Refused {
  int test = 0;
  double missing = 0;
  GearCombination combination;

  bool operator<(const Refused& other) const {
    return std::tuple(-test, missing) < std::tuple(-other.test, other.missing);
  }
};

class Sieve {
 public:
  explicit Sieve(const GearPairProblem& problem) : problem_(problem) {}

  void take(const GearCombination& combination) {
    ++sieved_.tested;
    const CheapTests tests = GearPairSearch(problem_, combination).cheap_tests();
    if (tests.ratio > 0) return refuse(0, tests.ratio, combination, sieved_.refused_by_ratio);
    if (tests.hunting > 0) {
      return refuse(1, tests.hunting, combination, sieved_.refused_by_hunting);
    }
    if (tests.centre_distance > 0) {
      return refuse(2, tests.centre_distance, combination, sieved_.refused_by_centre_distance);
    }
    if (tests.undercut > 0) {
      return refuse(3, tests.undercut, combination, sieved_.refused_by_undercut);
    }
    sieved_.left.push_back(combination);
  }

  Sieved result() && {
    for (const Refused& refused : nearest_) sieved_.nearest.push_back(refused.combination);
    return std::move(sieved_);
  }
  std::uint64_t tested() const { return sieved_.tested; }

 private:
  void refuse(int test, double missing, const GearCombination& combination, std::uint64_t& count) {
    ++count;
    const Refused refused{test, missing, combination};
    if (nearest_.size() == kNearest && !(refused < nearest_.back())) return;
    nearest_.insert(std::upper_bound(nearest_.begin(), nearest_.end(), refused), refused);
    if (nearest_.size() > kNearest) nearest_.pop_back();
  }

  const GearPairProblem& problem_;
  Sieved sieved_;
  std::vector<Refused> nearest_;  ///< best first
};

/// The range of the teeth of gear `index`; one number where they are given.
std::array<int, 2> range_of(const GearPairProblem& problem, std::size_t index) {
  const auto& given = problem.teeth[index];
  return given ? std::array{*given, *given} : problem.teeth_bounds[index];
}

}  // namespace

Sieved sieve(const GearPairProblem& problem, const Deadline& deadline) {
  Sieve sieve(problem);
  const auto modules = problem.module ? std::vector{*problem.module} : problem.modules;
  const auto first = range_of(problem, 0), second = range_of(problem, 1);
  for (const double module : modules) {
    for (int z1 = first[0]; z1 <= first[1]; ++z1) {
      for (int z2 = second[0]; z2 <= second[1]; ++z2) {
        if (sieve.tested() % kBlock == kBlock - 1 && deadline.reached()) {
          return std::move(sieve).result();
        }
        sieve.take({{z1, z2}, module});
      }
    }
  }
  return std::move(sieve).result();
}

}  // namespace cognate::problems
