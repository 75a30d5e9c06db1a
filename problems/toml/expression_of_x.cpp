/// Expressions in x alone, by whichever parser there is: pages have one of their own.
#include <utility>

#include "problems/toml/expression.hpp"

namespace cognate::problems::reading {

tl::expected<std::function<double(double)>, ExpressionError> parse_expression(
    const std::string& text) {
  constexpr std::string_view kX[] = {"x"};
  return parse_expression(text, kX).map([](ParsedExpression parsed) {
    return std::function<double(double)>([value = std::move(parsed.value)](double x) {
      return value({&x, 1});
    });
  });
}

}  // namespace cognate::problems::reading
