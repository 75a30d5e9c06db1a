/// @file Quantities of a machine that a file gives as a number, an expression or a table.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

#include "problems/machine/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Rows of a table, at most.
inline constexpr std::size_t kMostMachineRows = 5000;

/// What a function may depend on, by the names of expressions: the drive's angle phi, counted from
/// 0 to 2π within each turn; w, t; of a load also its body's travel s and its rate v.
enum class FunctionOf { phi, motion, load };

/// What is requested under a key.
struct FunctionRule {
  FunctionOf of = FunctionOf::motion;
  bool positive = false;  ///< an inertia: above 0 and without jumps
};

/// What the file says, and the function of phi, w, t, s and v where it names s or v.
struct ReadFunction {
  MachineFunction function;
  std::function<double(double, double, double, double, double)> of_travel{};
};

/// The function under `key` of `table`, which is there: a number, an expression, or a table
/// [[deg, value], ...] over a turn at most, between whose rows lie straight lines, or with
/// `smooth` the monotone cubic of interpolation.hpp, and which begins anew with each turn.
std::optional<ReadFunction> read_machine_function(TableReader& table, std::string_view key,
                                                  const FunctionRule& rule, bool smooth);

/// The key `interpolation` of `table`, "linear" (the default) or "smooth"; a fault where none of
/// `tables`, keys of `table`, is a table.
bool read_interpolation(TableReader& table, std::initializer_list<std::string_view> tables);

}  // namespace cognate::problems::reading
