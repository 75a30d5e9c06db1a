#include "problems/linkage/class_feasibility.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>

#include "analysis/linkage/mobility.hpp"

namespace cognate::problems::reading {
namespace {

constexpr double kRounding = kChangePointTolerance;

// A lower limit of 0 means more than this share of the largest link.
constexpr double kLeastShare = 1e-6;

// Places in LengthLimits.
constexpr int kCrank = 0, kCoupler = 1, kRocker = 2, kFrame = 3;

// Whether link `shortest` can be the shortest of a Grashof linkage. With x its length and a, b, c
// the others that means x + 2 max(a, b, c) ≤ a + b + c. The least x serves best. For a given
// M = max(a, b, c) the others serve best as long as they may be, min(upper, M), and the surplus
// Σ min(upper, M) − 2M rises with M up to the least upper limit, is level up to the middle one,
// and falls from there on; M is at least the greatest lower limit.
bool can_be_grashof(const LengthLimits& limits, int shortest) {
  double greatest_lower = 0;
  double least_upper = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i) {
    if (i == shortest) continue;
    greatest_lower = std::max(greatest_lower, limits[i].min);
    least_upper = std::min(least_upper, limits[i].max);
  }
  const double longest = std::max(greatest_lower, least_upper);
  if (longest == std::numeric_limits<double>::infinity()) return true;
  double surplus = -2 * longest - std::max(limits[shortest].min, kLeastShare * longest);
  for (int i = 0; i < 4; ++i) {
    if (i != shortest) surplus += std::min(limits[i].max, longest);
  }
  return surplus >= -kRounding * longest;
}

// Whether link `shortest` can be shorter than all `others`. A linkage found by `can_be_grashof` in
// which it is only as short as another has its least length and the greatest of that other.
bool can_be_shorter(const LengthLimits& limits, int shortest, std::initializer_list<int> others) {
  return std::ranges::all_of(others, [&](int other) {
    return limits[shortest].min < limits[other].max * (1 - kRounding);
  });
}

bool overlap(const Range& a, const Range& b) {
  return std::max(a.min, b.min) <= std::min(a.max, b.max) * (1 + kRounding);
}

// Parallelograms are double-cranks whichever links are the short ones.
bool can_be_parallelogram(const LengthLimits& limits) {
  return overlap(limits[kCrank], limits[kRocker]) && overlap(limits[kCoupler], limits[kFrame]);
}

// Whether links `longest` and `shortest` can be such in a linkage that no link turns fully in. With
// lengths l and t, and S the sum of the two others k and m, each at least t, that means
// S − t < l ≤ S + t (from k, m ≥ t it follows that l is the longest). For a given t there are such
// l and S exactly if the least S = max(k₀, t) + max(m₀, t) satisfies S − t < l₁ and the greatest,
// k₁ + m₁, is at least l₀ − t. S − t falls with t up to min(k₀, m₀), and does not fall beyond.
bool can_be_triple_rocker(const LengthLimits& limits, int longest, int shortest) {
  std::array<Range, 2> others;
  int count = 0;
  for (int i = 0; i < 4; ++i) {
    if (i != longest && i != shortest) others[count++] = limits[i];
  }
  const auto& [k, m] = others;
  const double lower = std::max(limits[shortest].min, limits[longest].min - (k.max + m.max));
  const double upper = std::min({limits[shortest].max, k.max, m.max});
  if (lower > upper) return false;
  const double t = std::clamp(std::min(k.min, m.min), lower, upper);
  const double sum = std::max(k.min, t) + std::max(m.min, t);
  return sum - t < limits[longest].max - kRounding * sum;
}

bool can_be_any_triple_rocker(const LengthLimits& limits) {
  for (int longest = 0; longest < 4; ++longest) {
    for (int shortest = 0; shortest < 4; ++shortest) {
      if (longest != shortest && can_be_triple_rocker(limits, longest, shortest)) return true;
    }
  }
  return false;
}

}  // namespace

bool class_is_possible(const LengthLimits& limits, RequiredClass wanted) {
  switch (wanted) {
    case RequiredClass::crank_rocker:
      return can_be_grashof(limits, kCrank) && can_be_shorter(limits, kCrank, {kRocker, kFrame});
    case RequiredClass::double_crank:
      return can_be_grashof(limits, kFrame) || can_be_parallelogram(limits);
    case RequiredClass::rocker_crank:
      return can_be_grashof(limits, kRocker) && can_be_shorter(limits, kRocker, {kCrank, kFrame});
    case RequiredClass::double_rocker:
      return can_be_grashof(limits, kCoupler) &&
             can_be_shorter(limits, kCoupler, {kCrank, kRocker, kFrame});
    case RequiredClass::grashof:
      return can_be_grashof(limits, kCrank) || can_be_grashof(limits, kCoupler) ||
             can_be_grashof(limits, kRocker) || can_be_grashof(limits, kFrame);
    case RequiredClass::triple_rocker:
    case RequiredClass::non_grashof:
      return can_be_any_triple_rocker(limits);
  }
  return false;
}

}  // namespace cognate::problems::reading
