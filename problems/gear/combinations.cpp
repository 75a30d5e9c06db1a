#include "problems/gear/combinations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace cognate::problems {
namespace {

/// How many of those refused are kept.
constexpr std::size_t kNearest = 8;
/// Between two looks at the clock.
constexpr std::uint64_t kBlock = 4096;

/// A combination that was refused: by which test, the later the better, and by how much.
struct Refused {
  Refusal why;
  GearCombination combination;

  bool operator<(const Refused& other) const {
    const auto rank = [](const Refusal& why) {
      return std::tuple(-static_cast<int>(why.test), why.missing);
    };
    return rank(why) < rank(other.why);
  }
};

class Sieve {
 public:
  explicit Sieve(const GearPairProblem& problem) : problem_(problem) {}

  void take(const GearCombination& combination) {
    ++sieved_.tested;
    const auto refusal = GearPairSearch(problem_, combination).refusal();
    if (!refusal) return sieved_.left.push_back(combination);
    ++sieved_.refused[static_cast<std::size_t>(refusal->test)];
    keep_if_near({*refusal, combination});
  }

  Sieved result() && {
    for (const Refused& refused : nearest_) sieved_.nearest.push_back(refused.combination);
    return std::move(sieved_);
  }

 private:
  void keep_if_near(const Refused& refused) {
    if (nearest_.size() == kNearest && !(refused < nearest_.back())) return;
    nearest_.insert(std::upper_bound(nearest_.begin(), nearest_.end(), refused), refused);
    if (nearest_.size() > kNearest) nearest_.pop_back();
  }

  const GearPairProblem& problem_;
  Sieved sieved_;
  std::vector<Refused> nearest_;  ///< best first
};

/// All choices of module and teeth, by number.
class Choices {
 public:
  explicit Choices(const GearPairProblem& problem)
      : modules_(problem.module ? std::vector{*problem.module} : problem.modules) {
    if (scales_with_module(problem)) {
      copies_ = modules_.size() - 1;
      modules_ = {*std::ranges::min_element(modules_)};
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& given = problem.teeth[i];
      teeth_[i] = given ? std::array{*given, *given} : problem.teeth_bounds[i];
    }
  }

  std::uint64_t count() const { return modules_.size() * range(0) * range(1); }
  std::size_t copies_of_each() const { return copies_; }

  GearCombination operator[](std::uint64_t index) const {
    const auto tooth = [&](std::size_t i, std::uint64_t place) {
      return teeth_[i][0] + static_cast<int>(place);
    };
    const std::uint64_t rest = index / range(1);
    return {{tooth(0, rest % range(0)), tooth(1, index % range(1))}, modules_[rest / range(0)]};
  }

 private:
  std::uint64_t range(std::size_t i) const {
    return static_cast<std::uint64_t>(teeth_[i][1] - teeth_[i][0]) + 1;
  }

  std::vector<double> modules_;
  std::array<std::array<int, 2>, 2> teeth_{};
  std::size_t copies_ = 0;
};

/// A step that visits all of `count` numbers, each far from those before: near the golden section.
std::uint64_t stride_of(std::uint64_t count) {
  auto stride = static_cast<std::uint64_t>(double(count) / std::numbers::phi) + 1;
  while (std::gcd(stride, count) != 1) ++stride;
  return stride;
}

}  // namespace

bool scales_with_module(const GearPairProblem& problem) {
  const auto& distances = problem.centre_distance_bounds;
  const bool is_bounded = distances.min > 0 || std::isfinite(distances.max);
  const bool overlaps = problem.helix != 0 && problem.face_width > 0;
  return !problem.centre_distance && !is_bounded && !overlaps && problem.backlash.value_or(0) == 0;
}

Sieved sieve(const GearPairProblem& problem, const Deadline& deadline) {
  Sieve sieve(problem);
  const Choices choices(problem);
  const std::uint64_t count = choices.count(), stride = stride_of(count);
  std::uint64_t index = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    if (k % kBlock == kBlock - 1 && deadline.reached()) break;
    sieve.take(choices[index]);
    index = (index + stride) % count;
  }
  Sieved sieved = std::move(sieve).result();
  sieved.all = count;
  sieved.copies = count * choices.copies_of_each();
  return sieved;
}

}  // namespace cognate::problems
