/// @file Functions of x that a problem file writes as text.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <tl/expected.hpp>

namespace cognate::problems::reading {

/// What is wrong with an expression, and at which byte of it.
struct ExpressionError {
  std::size_t position = 0;
  std::string message;
};

/// The function of x that `text` writes: numbers, x, pi, e, + - * / ^ (right-associative, -x^2 is
/// -(x^2)), comparisons, a ? b : c, and the functions sin, cos, tan, asin, acos, atan, atan2, sinh,
/// cosh, tanh, asinh, acosh, atanh, exp, log and ln (both natural), log2, log10, sqrt, abs, sign,
/// rint, min, max, sum, avg. Where it has no value it returns NaN or an infinity.
///
/// One copy may be called from one thread at a time; copies share nothing.
tl::expected<std::function<double(double)>, ExpressionError> parse_expression(
    const std::string& text);

}  // namespace cognate::problems::reading
