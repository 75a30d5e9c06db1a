/// @file What the program does with `kind = "quick-return"`.
#pragma once

#include "app/kinds/linkage/kind.hpp"
#include "problems/quick_return/problem.hpp"

namespace cognate::app {

template <>
struct Kind<problems::QuickReturnProblem> : LinkageKind<problems::QuickReturnProblem> {
  static constexpr std::string_view kMeaning =
      "the return takes less time than the advance, by a given ratio";
  static constexpr std::string_view kMethods = "designs from the time ratio";
  static std::span<const Entry> keys();
  static std::string describe(const problems::QuickReturnProblem& problem);
  static ColumnChoice columns(const problems::QuickReturnProblem& problem);
  static nlohmann::ordered_json target_json(const problems::QuickReturnProblem& problem);
};

}  // namespace cognate::app
