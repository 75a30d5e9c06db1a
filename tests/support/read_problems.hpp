/// @file Problems that tests write as text, and facts of their results.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <variant>

#include "problems/basics/quantity_key.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"

namespace cognate::test {

/// The problem of `text`, which is of that kind; its faults fail the test.
template <class Problem>
Problem problem_of(const std::string& text) {
  const auto problem = problems::parse_task(text);
  if (problem) return std::get<Problem>(*problem);
  for (const auto& fault : problem.error()) ADD_FAILURE() << fault.line << ": " << fault.message;
  return {};
}

/// A number among the facts; −1 where there is none.
inline double number(const problems::Result& result, std::string_view name) {
  return find_quantity(result.quantities, problems::QuantityKey<double>{name}).value_or(-1);
}

inline bool flag(const problems::Result& result, std::string_view name) {
  return find_quantity(result.quantities, problems::QuantityKey<bool>{name}).value_or(false);
}

}  // namespace cognate::test
