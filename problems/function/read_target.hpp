/// @file What a function generator shall generate: `function`, `table` or `pairs_deg`; of a
/// slider-crank, whose output is a displacement, `pairs`.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "problems/function/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

using FunctionTarget = std::variant<FunctionOfX, AnglePairs>;

/// The key of pairs for a type of mechanism: "pairs_deg", or "pairs" for a slider-crank.
std::string_view pairs_key(MechanismType type);

/// What `[target]` gives, with its domain and ranges; empty where faults leave none to go on with.
std::optional<FunctionTarget> read_function_target(TableReader& target, MechanismType type);

/// Why y cannot be generated on its domain, to follow the function's name: it has no value, a value
/// beyond 1e100 or a pole there, or jumps at an end. Empty where it can.
std::optional<std::string> function_fault(const FunctionOfX& function);

/// "function" or "table", whichever `[target]` has.
std::string_view target_key(TableReader& target);

/// A value of the function in a message: "not a number (NaN)" where it is none.
std::string value_in_words(double value);

}  // namespace cognate::problems::reading
