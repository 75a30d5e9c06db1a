#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "problems/gear/pair_design.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

std::string in_words(gear::ToothFault fault) {
  switch (fault) {
    case gear::ToothFault::none:
      break;
    case gear::ToothFault::rack_overlaps:
      return "rack-overlaps";
    case gear::ToothFault::no_root:
      return "no-root";
    case gear::ToothFault::no_flank:
      return "no-flank";
    case gear::ToothFault::cut_through:
      return "cut-through";
  }
  return "none";
}

}  // namespace

ConstraintCheck check_of(const GearLimit& limit) {
  const double slack =
      kCheckTolerance * std::max({std::abs(limit.value), std::abs(limit.bound), limit.scale});
  const double missing = limit.at_least ? limit.bound - limit.value : limit.value - limit.bound;
  const bool is_met = missing <= slack && missing != HUGE_VAL;  // sliding may be infinite
  ConstraintCheck check{limit.name, limit.value, limit.bound, is_met};
  check.relation = limit.at_least ? BoundSide::least : BoundSide::most;
  const bool of_teeth = std::string_view(limit.name).starts_with("teeth.");
  if (of_teeth) {
    check.relation.reset();
    check.value = in_words(static_cast<gear::ToothFault>(static_cast<int>(limit.value)));
    check.bound = in_words(gear::ToothFault::none);
  }
  return check;
}

}  // namespace cognate::problems
