/// Expressions as the pages evaluate them, against the program's parser.
#include "app/report/kernel/formula.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "app/report/kernel/formula.cpp"  // of the kernel of the pages alone
#include "problems/toml/expression.hpp"

namespace cognate::page::formula_test {
namespace {

using problems::reading::parse_expression;

constexpr std::array<std::string_view, 3> kVariables{"phi", "w", "t"};

void expect_alike(const std::string& text, std::span<const double> values) {
  const auto program = parse_expression(text, kVariables);
  const auto page = Formula::of(text, kVariables);
  ASSERT_TRUE(program) << text;
  ASSERT_TRUE(page) << text;
  const double expected = program->value(values), value = (*page)(values);
  if (std::isnan(expected)) {
    EXPECT_TRUE(std::isnan(value)) << text;
  } else if (std::isinf(expected)) {
    EXPECT_EQ(value, expected) << text;
  } else {
    EXPECT_NEAR(value, expected, 1e-12 * (1 + std::abs(expected))) << text;
  }
  for (std::size_t i = 0; i < kVariables.size(); ++i) {
    EXPECT_EQ(page->uses(i), program->uses[i]) << text;
  }
}

TEST(Formula, IsTheProgramsExpression) {
  for (const char* text : {"1",
                           ".5e-3",
                           "2.",
                           "pi*e",
                           "-phi^2",
                           "2^-w",
                           "2^3^2",
                           "-2^2",
                           "+w - -t",
                           "8/4/2",
                           "1-2-3",
                           "phi > 1 ? 2 : w < 0 ? 3 : 4",
                           "phi>1&&w>1||t<1",
                           "1 < 2 == 1",
                           "(phi+w)*(t-1)",
                           "min(phi)",
                           "max(phi, w, 1)",
                           "sum(1, phi, w)",
                           "avg(phi, w, t)",
                           "atan2(w, t)",
                           "sign(-w)+sign(0)+abs(-3)",
                           "rint(2.5)+rint(-0.5)",
                           "ln(w)+log(w)+log2(w)+log10(w)",
                           "sqrt(-1)",
                           "1/0",
                           "asin(0.3)+acos(0.3)+atan(w)+sinh(t)+cosh(t)+tanh(t)",
                           "asinh(w)+acosh(2)+atanh(0.2)+exp(t)+tan(phi)+cos(phi)+sin(phi)",
                           "w > 0 ? min(785*(0.11/(0.26 - t))^1.3 - 785, 4700) : 0",
                           " 3 * ( phi + 1 ) "}) {
    expect_alike(text, std::array{0.7, 2.5, 0.1});
    expect_alike(text, std::array{4.1, -1.5, 3.0});
  }
}

TEST(Formula, RefusesWhatIsNone) {
  for (const char* text : {"", "1 +", "(1", "1)", "2 x", "x", "sin", "sin()", "min()", "atan2(1)",
                           "atan2(1,2,3)", "1 ? 2", "foo(1)", "* 2", "1,2", "sin(1,2)", "2pi"}) {
    EXPECT_FALSE(parse_expression(text, kVariables)) << text;
    EXPECT_FALSE(Formula::of(text, kVariables)) << text;
  }
}

/// A random expression, `depth` levels deep at most. Of constants joined by && and || the program's
/// parser takes the whole parts.
std::string random_text(std::mt19937& random, int depth) {
  const auto pick = [&](auto... of) {
    const std::array<std::string, sizeof...(of)> all{of...};
    return all[random() % all.size()];
  };
  if (depth == 0) return pick("phi", "w", "t", "0.5", "3", "pi", "1e-2");
  const auto part = [&] { return random_text(random, depth - 1); };
  switch (random() % 7) {
    case 0:
      return "-(" + part() + ")";
    case 1:
      return pick("sin", "exp", "abs", "sqrt", "sign") + "(" + part() + ")";
    case 2:
      return "(" + part() + ")";
    case 3:
      return pick("min", "max", "sum", "avg") + "(" + part() + ", " + part() + ")";
    case 4:
      return "(" + part() + " ? " + part() + " : " + part() + ")";
    default:
      return part() + pick("+", "-", "*", "/", "^", "<", ">=", "==") + part();
  }
}

TEST(Formula, IsTheProgramsOfRandomTexts) {
  std::mt19937 random(7);
  for (int i = 0; i < 500; ++i) {
    expect_alike(random_text(random, 1 + i % 5), std::array{0.7, 2.5, 0.1});
  }
}

}  // namespace
}  // namespace cognate::page::formula_test
