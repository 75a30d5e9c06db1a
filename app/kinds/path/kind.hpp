/// @file What the program does with `kind = "path-generation"`.
#pragma once

#include "app/kinds/linkage/kind.hpp"
#include "problems/path/problem.hpp"

namespace cognate::app {

template <>
struct Kind<problems::PathProblem> : LinkageKind<problems::PathProblem> {
  static constexpr std::string_view kMeaning =
      "a point of the coupler passes through given points or follows a closed curve";
  static constexpr std::string_view kMethods = "designs by homotopy and by least squares";
  static std::span<const Entry> keys();
  static std::string describe(const problems::PathProblem& problem);
  static ColumnChoice columns(const problems::PathProblem& problem);
  static nlohmann::ordered_json target_json(const problems::PathProblem& problem);
  static std::vector<problems::Fault> faults(const problems::PathProblem& problem);
  static tl::expected<std::vector<problems::Design>, std::vector<problems::Fault>> known_designs(
      const problems::PathProblem& problem);
  static problems::Result run(const problems::PathProblem& problem, const problems::Run& run);
};

}  // namespace cognate::app
