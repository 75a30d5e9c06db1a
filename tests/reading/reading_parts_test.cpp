// The parts that reading problems is made of, each against its own oracle.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/interpolators/cubic_hermite.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/class_feasibility.hpp"
#include "problems/toml/expression.hpp"
#include "problems/toml/interpolation.hpp"
#include "problems/toml/nearest.hpp"
#include "problems/toml/text_check.hpp"

namespace cognate::problems::reading::reading_parts_test {
namespace {

double value(const std::string& text, double x) {
  const auto f = parse_expression(text);
  EXPECT_TRUE(f) << text;
  return f ? (*f)(x) : std::numeric_limits<double>::quiet_NaN();
}

TEST(ExpressionTest, MeansWhatMathematicsMeans) {
  EXPECT_EQ(value("2/(3*pi)*x^2", 3), 2 / (3 * kPi) * 9);
  EXPECT_EQ(value("-x^2", 3), -9);
  EXPECT_EQ(value("2^x^2", 3), 512);
  EXPECT_DOUBLE_EQ(value("log10(x)", 1000), 3);
  EXPECT_DOUBLE_EQ(value("log(e^x)", 2.5), 2.5);
  EXPECT_DOUBLE_EQ(value("ln(e^x)", 2.5), 2.5);
  EXPECT_EQ(value("x <= 1 ? 1 : 2", 1), 1);
  EXPECT_EQ(value("x == 1 ? 1 : 2", 2), 2);
  EXPECT_DOUBLE_EQ(value("sin(pi/6) + 1.5e1", 0), 15.5);
}

TEST(ExpressionTest, NoValueIsNoException) {
  EXPECT_TRUE(std::isnan(value("sqrt(x)", -1)));
  EXPECT_TRUE(std::isinf(value("1/x", 0)));
}

TEST(ExpressionTest, CopiesShareNothing) {
  const auto f = parse_expression("x^2 + 1");
  ASSERT_TRUE(f);
  const auto copy = *f;
  EXPECT_EQ((*f)(2), 5);
  EXPECT_EQ(copy(3), 10);
  EXPECT_EQ((*f)(2), 5);
}

TEST(ExpressionTest, PointsAtWhatItCannotRead) {
  const auto f = parse_expression("1 + foo(x)");
  ASSERT_FALSE(f);
  EXPECT_EQ(f.error().position, 4U);
  EXPECT_FALSE(parse_expression(std::string(100'000, '(')));
}

TEST(ExpressionTest, NumbersNeedNoVariable) {
  EXPECT_EQ(evaluate_expression("170*2*pi/60").value(), 170 * 2 * kPi / 60);
  EXPECT_EQ(evaluate_expression(" 2 ^ 0.5 ").value(), std::sqrt(2.0));
  EXPECT_TRUE(std::isinf(evaluate_expression("1/0").value()));
  for (const char* text : {"", "x", "2*", "1,5", "2 pi", "a = 3", "two", "_pi", "1;2"}) {
    EXPECT_FALSE(evaluate_expression(text)) << text;
  }
}

TEST(InterpolationTest, PassesThroughItsTableAndKeepsItsEnds) {
  const std::vector<std::pair<double, double>> table = {{0, 0}, {1, 1}, {2, 1}, {4, -3}, {5, 7}};
  const auto f = interpolate(table);
  for (const auto& [x, y] : table) EXPECT_DOUBLE_EQ(f(x), y);
  EXPECT_EQ(f(-1), 0);
  EXPECT_EQ(f(9), 7);
}

TEST(InterpolationTest, KeepsMonotoneDataMonotone) {
  std::mt19937 random(1);
  std::exponential_distribution<double> step(1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<std::pair<double, double>> table = {{0, 0}};
    const int rows = 2 + trial % 7;
    while (static_cast<int>(table.size()) < rows) {
      const double rise = trial % 3 == 0 ? std::floor(step(random)) : std::pow(step(random), 3);
      table.emplace_back(table.back().first + step(random) + 0.01, table.back().second + rise);
    }
    const auto f = interpolate(table);
    const double last = table.back().first;
    for (int i = 1; i <= 500; ++i) {
      const double before = f(last * (i - 1) / 500);
      EXPECT_GE(f(last * i / 500) - before, -1e-12 * (1 + std::abs(before))) << "trial " << trial;
    }
  }
}

TEST(InterpolationTest, IsTheCubicOfItsSlopes) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(0.01, 1), rise(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<std::pair<double, double>> table = {{-1, 2}};
    for (int row = 0; row < 2 + trial % 9; ++row) {
      table.emplace_back(table.back().first + step(random), table.back().second + rise(random));
    }
    const auto f = interpolant(table);
    std::vector<double> x, y, slopes;
    for (const auto& [xi, yi] : table) {
      x.push_back(xi);
      y.push_back(yi);
      slopes.push_back(f.slope(xi));
    }
    const double first = x.front(), last = x.back();
    const boost::math::interpolators::cubic_hermite known(std::move(x), std::move(y),
                                                          std::move(slopes));
    for (int i = 0; i <= 97; ++i) {
      const double at = std::lerp(first, last, i / 97.0);
      EXPECT_NEAR(f.value(at), known(at), 1e-13) << "trial " << trial;
      EXPECT_NEAR(f.slope(at), known.prime(at), 1e-11) << "trial " << trial;
    }
  }
}

TEST(InterpolationTest, ReproducesALine) {
  const auto f = interpolate({{0, 1}, {1, 3}, {4, 9}, {5, 11}});
  for (double x = 0; x <= 5; x += 0.125) EXPECT_NEAR(f(x), 1 + 2 * x, 1e-14);
}

TEST(NearestTest, CountsEdits) {
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("crnak", "crank"), 1U);
  EXPECT_EQ(edit_distance("same", "same"), 0U);
}

TEST(NearestTest, NamesOnlyWhatWasMeant) {
  constexpr std::string_view known[] = {"crank", "coupler", "rocker", "frame"};
  EXPECT_EQ(nearest("couplr", known), "coupler");
  EXPECT_EQ(nearest("Frame", known), "frame");
  EXPECT_EQ(nearest("temperature", known), std::nullopt);
  EXPECT_EQ(nearest(std::string(1'000'000, 'c'), known), std::nullopt);
}

TEST(NearestTest, QuotesWithoutControlCharactersOrHalfLetters) {
  EXPECT_EQ(in_quotes("a\nb"), "\"a?b\"");
  // Letters of two bytes: 60 bytes hold 30 of them, and 59 with an "a" before them 29 and a half.
  std::string letters = "a";
  for (int i = 0; i < 100; ++i) letters += "\xc3\xa9";
  EXPECT_FALSE(check_is_text(in_quotes(letters)));
  EXPECT_LT(in_quotes(letters).size(), 70U);
}

// Whether `links`, on a grid of eighths, are of class `wanted`: of a Grashof linkage the joints at
// the ends of a shortest link turn fully.
bool has_class(const std::array<double, 4>& links, RequiredClass wanted) {
  const double shortest = *std::ranges::min_element(links);
  const double longest = *std::ranges::max_element(links);
  const double sum = links[0] + links[1] + links[2] + links[3];
  if (2 * longest > sum) return false;
  const bool grashof = 2 * (shortest + longest) <= sum;  // exact: all are multiples of 1/8
  const bool crank = links[0] == shortest || links[3] == shortest;
  const bool rocker = links[2] == shortest || links[3] == shortest;
  switch (wanted) {
    case RequiredClass::crank_rocker:
      return grashof && crank && !rocker;
    case RequiredClass::double_rocker:
      return grashof && !crank && !rocker;
    case RequiredClass::rocker_crank:
      return grashof && rocker && !crank;
    case RequiredClass::double_crank:
      return grashof && crank && rocker;
    case RequiredClass::grashof:
      return grashof;
    default:
      return !grashof;
  }
}

// The classes on the grid within `limits`, by trying every point of it.
std::set<RequiredClass> classes_on_grid(const LengthLimits& limits) {
  constexpr double kStep = 0.125;
  std::set<RequiredClass> found;
  std::array<double, 4> links{};
  const auto visit = [&](const auto& self, std::size_t i) -> void {
    if (i == links.size()) {
      for (const auto& named : names<RequiredClass>()) {
        if (has_class(links, named.value)) found.insert(named.value);
      }
      return;
    }
    for (links[i] = std::max(limits[i].min, kStep); links[i] <= limits[i].max; links[i] += kStep) {
      self(self, i + 1);
    }
  };
  visit(visit, 0);
  return found;
}

// With limits that are multiples of 1/2 a class that is possible shows on the grid.
TEST(ClassFeasibilityTest, AgreesWithSearchOnAGrid) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> half(0, 8);
  std::uniform_int_distribution<int> width(0, 1);
  int possible = 0;
  int impossible = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    LengthLimits limits;
    std::string shown;
    for (Range& range : limits) {
      range.min = 0.5 * half(random);
      range.max = std::max(0.5, range.min + 0.5 * width(random));
      shown += " [" + std::to_string(range.min) + ", " + std::to_string(range.max) + "]";
    }
    const std::set<RequiredClass> found = classes_on_grid(limits);
    for (const auto& named : names<RequiredClass>()) {
      EXPECT_EQ(class_is_possible(limits, named.value), found.contains(named.value))
          << named.name << shown;
      (found.contains(named.value) ? possible : impossible)++;
    }
  }
  EXPECT_GT(possible, 1000);
  EXPECT_GT(impossible, 1000);
}

TEST(ClassFeasibilityTest, ChangePointsAndOpenLimits) {
  const double inf = std::numeric_limits<double>::infinity();
  const LengthLimits open = {Range{0, inf}, Range{0, inf}, Range{0, inf}, Range{0, inf}};
  for (const auto& named : names<RequiredClass>())
    EXPECT_TRUE(class_is_possible(open, named.value));
  // 0.1 + 0.4 = 0.2 + 0.3 up to rounding: a change point, so Grashof and not a triple rocker.
  const LengthLimits change = {Range{0.1, 0.1}, Range{0.4, 0.4}, Range{0.2, 0.2}, Range{0.3, 0.3}};
  EXPECT_TRUE(class_is_possible(change, RequiredClass::crank_rocker));
  EXPECT_FALSE(class_is_possible(change, RequiredClass::triple_rocker));
  // Three links of at most 1 cannot span a fourth of 4: no class at all.
  const LengthLimits apart = {Range{0, 1}, Range{0, 1}, Range{0, 1}, Range{4, inf}};
  for (const auto& named : names<RequiredClass>()) {
    EXPECT_FALSE(class_is_possible(apart, named.value)) << named.name;
  }
}

TEST(TextCheckTest, KnowsDeepKeysFromNumbersAndStrings) {
  const std::string deep = "a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q";
  EXPECT_TRUE(check_key_depth(deep + " = 1"));
  EXPECT_TRUE(check_key_depth("[" + deep + "]"));
  EXPECT_TRUE(check_key_depth("x = { 'a' . \"b\".c.d.e.f.g.h.i.j.k.l.m.n.o.p.q = 1 }"));
  EXPECT_FALSE(check_key_depth("x = \"" + deep + "\" # " + deep));
  EXPECT_FALSE(check_key_depth("x = '''\n" + deep + "\n''' # " + deep));
  EXPECT_FALSE(check_key_depth("x = [" + deep.substr(0, 21) + "," + deep.substr(0, 21) + "]"));
}

}  // namespace
}  // namespace cognate::problems::reading::reading_parts_test
