/// @file The program's expressions in a page.
#include "app/report/kernel/formula.hpp"
#include "problems/toml/expression.hpp"

tl::expected<cognate::problems::reading::ParsedExpression,
             cognate::problems::reading::ExpressionError>
cognate::problems::reading::parse_expression(const std::string& text,
                                             std::span<const std::string_view> variables) {
  const auto formula = page::Formula::of(text, variables);
  if (!formula) return tl::unexpected(ExpressionError{0, "is no expression that a page reads"});
  ParsedExpression parsed{*formula, {}};
  for (std::size_t i = 0; i < variables.size(); ++i) parsed.uses.push_back(formula->uses(i));
  return parsed;
}
