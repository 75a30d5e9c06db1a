/// @file Keys of quantities that the program reads back from its own results: a quantity is
/// reported and found by one constant, which knows its type and unit.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/quantity.hpp"

namespace cognate::problems {

/// Of a value of type T (double, bool or std::string).
template <class T>
struct QuantityKey {
  std::string_view name;
};

/// Of an angle: radians in the program, degrees in the quantity, whose name ends in "_deg".
struct AngleKey {
  std::string_view name;
};

template <class T>
Quantity quantity(const QuantityKey<T>& key, T value) {
  return {std::string(key.name), std::move(value)};
}

inline Quantity quantity(const AngleKey& key, double radians) {
  return {std::string(key.name), degrees(radians)};
}

/// Empty where there is none.
template <class T>
std::optional<T> find_quantity(const std::vector<Quantity>& quantities, const QuantityKey<T>& key) {
  const auto found = std::ranges::find(quantities, key.name, &Quantity::name);
  if (found == quantities.end()) return std::nullopt;
  const T* value = std::get_if<T>(&found->value);
  return value ? std::optional<T>(*value) : std::nullopt;
}

inline std::optional<double> find_quantity(const std::vector<Quantity>& quantities,
                                           const AngleKey& key) {
  auto angle = find_quantity(quantities, QuantityKey<double>{key.name});
  if (angle) *angle *= kPi / 180;
  return angle;
}

}  // namespace cognate::problems
