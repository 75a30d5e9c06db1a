#include "problems/toml/expression.hpp"

#include <fmt/core.h>
#include <muParser.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/enumeration.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kNames =
    "the constants pi and e, and the functions sin, cos, tan, asin, acos, atan, "
    "atan2, sinh, cosh, tanh, asinh, acosh, atanh, exp, log and ln (natural), log2, log10, sqrt, "
    "abs, sign, rint, min, max, sum, avg";

using Variables = std::vector<std::string>;

std::string expected_form(const Variables& variables) {
  return variables.empty() ? "one expression without variables"
                           : "one expression in " + enumeration(variables);
}

std::string known_names(const Variables& variables) {
  if (variables.empty()) return std::string(kNames);
  return fmt::format("the variable{} {}, {}", variables.size() == 1 ? "" : "s",
                     enumeration(variables), kNames);
}

// A parser and the values it is bound to. It keeps their addresses, so a copy is a new parser.
class Expression {
 public:
  Expression(std::string text, Variables variables)
      : text_(std::move(text)),
        variables_(std::move(variables)),
        values_(std::make_unique<double[]>(variables_.size())) {
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      parser_.DefineVar(variables_[i], &values_[i]);
    }
    parser_.ClearConst();  // the parser's own _pi is rounded
    parser_.DefineConst("pi", kPi);
    parser_.DefineConst("e", std::numbers::e);
    parser_.SetExpr(text_);
  }
  Expression(const Expression& other) : Expression(other.text_, other.variables_) {}
  Expression& operator=(const Expression&) = delete;
  ~Expression() = default;

  // Throws what the parser throws.
  double evaluate(std::span<const double> values) {
    std::ranges::copy(values.first(variables_.size()), values_.get());
    return parser_.Eval();
  }
  int result_count() const { return parser_.GetNumResults(); }

  // Of an expression that was evaluated without a throw.
  std::vector<bool> uses() const {
    const auto& used = parser_.GetUsedVar();
    std::vector<bool> all;
    for (const std::string& variable : variables_) all.push_back(used.contains(variable));
    return all;
  }

  // No exception crosses the border: an expression that was parsed once fails only for its values.
  double operator()(std::span<const double> values) {
    try {
      return evaluate(values);
    } catch (const mu::Parser::exception_type&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

 private:
  std::string text_;
  Variables variables_;
  std::unique_ptr<double[]> values_;
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
std::string message_of(const mu::Parser::exception_type& error, const Variables& variables) {
  if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN) {
    std::string token = error.GetToken();
    token.erase(token.find_last_not_of(' ') + 1);
    return fmt::format("cannot be read from {} on; known are {}", in_quotes(token),
                       known_names(variables));
  }
  std::string message = error.GetMsg();
  for (const std::string_view end : {" found at position", " at position", " at expression"}) {
    message.resize(std::min(message.find(end), message.size()));
  }
  if (message.ends_with('.')) message.pop_back();
  return fmt::format("is no expression: {}; expected {}", message, expected_form(variables));
}

}  // namespace

tl::expected<ParsedExpression, ExpressionError> parse_expression(
    const std::string& text, std::span<const std::string_view> variables) {
  const Variables named(variables.begin(), variables.end());
  if (const auto assignment = find_assignment(text)) {
    return tl::unexpected(ExpressionError{
        *assignment,
        fmt::format("contains an assignment; expected {}, == compares", expected_form(named))});
  }
  try {
    // The first evaluation parses; its value does not matter.
    Expression expression(text, named);
    expression.evaluate(std::vector<double>(named.size()));
    if (expression.result_count() != 1) {
      return tl::unexpected(ExpressionError{
          std::min(text.find(','), text.size()),
          fmt::format("has several values; expected {}, with a point as decimal mark",
                      expected_form(named))});
    }
    return ParsedExpression{expression, expression.uses()};
  } catch (const mu::Parser::exception_type& error) {
    const auto position = static_cast<std::size_t>(std::max(error.GetPos(), 0));
    return tl::unexpected(
        ExpressionError{std::min(position, text.size()), message_of(error, named)});
  }
}

tl::expected<double, ExpressionError> evaluate_expression(const std::string& text) {
  return parse_expression(text, {}).map(
      [](const ParsedExpression& parsed) { return parsed.value({}); });
}

}  // namespace cognate::problems::reading
