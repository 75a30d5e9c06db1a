/// @file What the program does with numbers that a page has no need of: files that are written
/// shorten them, and files that are read may hold expressions. In a page all numbers are whole.
#include <string>

#include "analysis/numbers/constants.hpp"
#include "app/report/report_data.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/toml/expression.hpp"

double cognate::app::round_to_digits(double x, int /*digits*/) {
  return x;
}

double cognate::problems::degrees(double radians) {
  return radians * (180.0 / kPi);
}

tl::expected<double, cognate::problems::reading::ExpressionError>
cognate::problems::reading::evaluate_expression(const std::string& text) {
  return tl::unexpected(ExpressionError{0, "a page evaluates no expressions: " + text});
}
