/// @file Functions that a problem file writes as text.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace cognate::problems::reading {

/// What is wrong with an expression, and at which byte of it.
struct ExpressionError {
  std::size_t position = 0;
  std::string message;
};

/// A function of several variables.
struct ParsedExpression {
  /// Of their values, in the order in which they were named. One copy may be called from one thread
  /// at a time; copies share nothing.
  std::function<double(std::span<const double>)> value;
  std::vector<bool> uses;  ///< which of them occur
};

/// The function of `variables` that `text` writes: numbers, the variables, pi, e, + - * / ^
/// (right-associative, -x^2 is -(x^2)), comparisons, a ? b : c, and the functions sin, cos, tan,
/// asin, acos, atan, atan2, sinh, cosh, tanh, asinh, acosh, atanh, exp, log and ln (both natural),
/// log2, log10, sqrt, abs, sign, rint, min, max, sum, avg. Where it has no value it returns NaN or
/// an infinity.
tl::expected<ParsedExpression, ExpressionError> parse_expression(
    const std::string& text, std::span<const std::string_view> variables);

/// The same of x alone.
tl::expected<std::function<double(double)>, ExpressionError> parse_expression(
    const std::string& text);

/// The value of an expression without variables, "170*2*pi/60": perhaps NaN or an infinity.
tl::expected<double, ExpressionError> evaluate_expression(const std::string& text);

}  // namespace cognate::problems::reading
