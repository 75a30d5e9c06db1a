/// @file What a function generator shall generate, written down.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/function/read_target.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// The keys of `[target]` that say the function or the pairs, and where it is sampled; `slider`:
/// the output is a displacement.
TableWriter function_target_writer(const FunctionTarget& target,
                                   const std::vector<double>& sample_at, bool slider);

/// What is wrong with the function itself, whose values need not be those of the document.
std::optional<std::string> fault_of_function(const FunctionOfX& function);

}  // namespace cognate::problems::reading
