/// @file Expressions of problem files in a page. The program's parser throws, which the pages'
/// compiler does not allow: this one takes the same grammar, of texts that the program has read.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace cognate::page {

/// A function of several variables in the order of its evaluation: every step takes its operands
/// from a stack and leaves a value there.
class Formula {
 public:
  using Unary = double (*)(double);
  using Binary = double (*)(double, double);

  /// What `text` writes, as problems/toml/expression.hpp has it; nothing where it is no expression
  /// of `variables`.
  static std::optional<Formula> of(std::string_view text,
                                   std::span<const std::string_view> variables);

  double operator()(std::span<const double> values) const;

  /// Whether a variable occurs.
  bool uses(std::size_t variable) const;

 private:
  friend class FormulaReader;
  enum class Action { number, variable, unary, binary, choice };
  struct Step {
    Action action;
    double number = 0;
    std::size_t variable = 0;
    Unary unary = nullptr;
    Binary binary = nullptr;
  };

  std::vector<Step> steps_;
  std::size_t depth_ = 0;  ///< of the stack
};

}  // namespace cognate::page
