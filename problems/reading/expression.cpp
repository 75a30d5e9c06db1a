#include "problems/reading/expression.hpp"

#include <fmt/core.h>
#include <muParser.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "problems/reading/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kNames =
    "the variable x, the constants pi and e, and the functions sin, cos, tan, asin, acos, atan, "
    "atan2, sinh, cosh, tanh, asinh, acosh, atanh, exp, log and ln (natural), log2, log10, sqrt, "
    "abs, sign, rint, min, max, sum, avg";

// A parser and the x it is bound to. The parser keeps the address of x, so a copy is a new parser.
class Expression {
 public:
  explicit Expression(std::string text) : text_(std::move(text)), x_(std::make_unique<double>(0)) {
    parser_.DefineVar("x", x_.get());
    parser_.DefineConst("pi", std::numbers::pi);
    parser_.DefineConst("e", std::numbers::e);
    parser_.SetExpr(text_);
  }
  Expression(const Expression& other) : Expression(other.text_) {}
  Expression& operator=(const Expression&) = delete;
  ~Expression() = default;

  // Throws what the parser throws.
  double evaluate(double x) {
    *x_ = x;
    return parser_.Eval();
  }
  int result_count() const { return parser_.GetNumResults(); }

  // No exception crosses the border: an expression that was parsed once fails only for its x.
  double operator()(double x) {
    try {
      return evaluate(x);
    } catch (const mu::Parser::exception_type&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

 private:
  std::string text_;
  std::unique_ptr<double> x_;
  mu::Parser parser_;
};

// An assignment, which the parser would carry out: a "=" that is no part of == <= >= !=.
std::optional<std::size_t> find_assignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) {
      return i;
    }
  }
  return std::nullopt;
}

// The parser's sentences repeat the position, which the fault carries already.
std::string message_of(const mu::Parser::exception_type& error) {
  if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN) {
    std::string token = error.GetToken();
    token.erase(token.find_last_not_of(' ') + 1);
    return fmt::format("cannot be read from {} on; known are {}", in_quotes(token), kNames);
  }
  std::string message = error.GetMsg();
  for (const std::string_view end : {" found at position", " at position", " at expression"}) {
    message.resize(std::min(message.find(end), message.size()));
  }
  if (message.ends_with('.')) message.pop_back();
  return fmt::format("is no expression: {}; one expression in x is wanted", message);
}

}  // namespace

tl::expected<std::function<double(double)>, ExpressionError> parse_expression(
    const std::string& text) {
  if (const auto assignment = find_assignment(text)) {
    return tl::unexpected(ExpressionError{
        *assignment, "contains an assignment; one expression in x is wanted, == compares"});
  }
  try {
    // The first evaluation parses; its value does not matter.
    Expression expression(text);
    expression.evaluate(0);
    if (expression.result_count() != 1) {
      return tl::unexpected(ExpressionError{
          std::min(text.find(','), text.size()),
          "has several values; one expression in x is wanted, with a point as decimal mark"});
    }
    return expression;
  } catch (const mu::Parser::exception_type& error) {
    const auto position = static_cast<std::size_t>(std::max(error.GetPos(), 0));
    return tl::unexpected(ExpressionError{std::min(position, text.size()), message_of(error)});
  }
}

}  // namespace cognate::problems::reading
