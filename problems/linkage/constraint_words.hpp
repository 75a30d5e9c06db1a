/// @file What a row of constraints says to people: its name in words, its relation and its unit.
#pragma once

#include <string>
#include <string_view>

#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Of one constraint. `value` `relation` `bound` is a sentence: "25 deg >= 30 deg".
struct ConstraintWords {
  std::string label;          ///< "transmission angle", "tip thickness (pinion)"
  std::string_view relation;  ///< "<=", ">=", "in" (two ends), or "=" (one value, or a word)
  std::string unit;  ///< of value and bound: "deg", "length", "module" (shares of it); empty: none
};

/// `angular`: peaks are those of an angle, as of a function's rocker, not of a point.
ConstraintWords words_of(const ConstraintCheck& check, bool angular = false);

/// The keys that name constraints without what stands before and after them, for those who check
/// that each has a name in words.
bool has_words(std::string_view name);

}  // namespace cognate::problems
