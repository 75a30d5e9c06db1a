/// @file The one spelling of each enum value, in problem files, results and reports alike.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace cognate::problems {

/// A value of `Enum` and how it is written.
template <class Enum>
struct Named {
  std::string_view name;
  Enum value;
};

/// Every value of `Enum` with its name, in the order of its declaration. Specialised beside each
/// enum that files or results spell.
template <class Enum>
std::span<const Named<Enum>> names();

/// How `value` is written, e.g. "crank-rocker"; empty for a number that is no value of the enum.
template <class Enum>
std::string_view to_string(Enum value) {
  const auto all = names<Enum>();
  const auto found = std::ranges::find(all, value, &Named<Enum>::value);
  return found == all.end() ? std::string_view{} : found->name;
}

/// The value written `name`, exactly; empty where there is none.
template <class Enum>
std::optional<Enum> from_string(std::string_view name) {
  const auto all = names<Enum>();
  const auto found = std::ranges::find(all, name, &Named<Enum>::name);
  return found == all.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace cognate::problems
