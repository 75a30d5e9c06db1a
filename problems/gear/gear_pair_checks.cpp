#include <algorithm>
#include <cmath>
#include <string_view>

#include "problems/gear/gear_pair_design.hpp"
#include "problems/verify.hpp"

namespace cognate::problems {
namespace {

/// How a ToothFault is written.
std::string in_words(double fault) {
  constexpr std::string_view kFaults[] = {"none", "rack overlaps", "no root", "cut through",
                                          "no flank"};
  return std::string(kFaults[static_cast<std::size_t>(fault)]);
}

}  // namespace

ConstraintCheck check_of(const GearLimit& limit) {
  const double slack =
      kCheckTolerance * std::max({std::abs(limit.value), std::abs(limit.bound), limit.scale});
  const double missing =
      limit.at_least ? limit.bound - limit.value : limit.value - limit.bound;
  ConstraintCheck check{limit.name, limit.value, limit.bound, missing <= slack};
  const bool of_teeth = std::string_view(limit.name).starts_with("teeth.");
  if (of_teeth) {
    check.value = in_words(limit.value);
    check.bound = in_words(0);
  }
  return check;
}

}  // namespace cognate::problems
