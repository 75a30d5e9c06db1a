/// Poles between samples, distinguished from peaks and steps.
#include "problems/function/target/poles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/function/target/jumps.hpp"

namespace cognate::problems::reading::poles_test {
namespace {

constexpr int kIntervals = 1000;

TEST(Poles, OfEveryOrderAreFoundWhereTheyAre) {
  for (const double order : {0.5, 1.0, 2.0, 3.0}) {
    for (const double at : {0.33333333, 0.1234567, 0.9999, 0.5005, 0.3330000001}) {
      const auto y = [&](double x) { return std::pow(std::abs(x - at), -order) - 3; };
      const auto pole = find_pole(y, {0, 1}, kIntervals);
      ASSERT_TRUE(pole) << order << " " << at;
      EXPECT_NEAR(*pole, at, 1e-9);
    }
  }
  const auto sign_changes = [](double x) { return 1 / (x - 0.33333333); };
  EXPECT_NEAR(find_pole(sign_changes, {0, 1}, kIntervals).value_or(0), 0.33333333, 1e-9);
  const auto tangent = [](double x) { return std::tan(x); };
  EXPECT_NEAR(find_pole(tangent, {1, 2}, kIntervals).value_or(0), kRightAngle, 1e-9);
}

TEST(Poles, AtEitherEndOfTheDomainAreFound) {
  int found = 0;
  for (const double order : {0.5, 1.0, 2.0, 3.0}) {
    for (const auto& [from, to] : {std::pair{0.0, 1.0}, {1.0, 2.0}, {-3.0, -0.7}, {0.1, 10.0}}) {
      for (const double at : {from, to}) {
        // At the end itself the value is infinite, or, by rounding, only very great.
        for (const double beyond : {0.0, 1e-17}) {
          const double side = at == from ? -1 : 1;
          const double pole = at + side * beyond;
          const auto y = [=](double x) { return std::pow(std::abs(x - pole), -order) - 3; };
          const auto seen = find_pole(y, {from, to}, kIntervals);
          ASSERT_TRUE(seen) << order << " at " << at;
          EXPECT_NEAR(*seen, at, 1e-12);
          ++found;
        }
      }
    }
  }
  EXPECT_EQ(found, 64);
  const auto tangent = [](double x) { return std::tan(x); };
  EXPECT_TRUE(find_pole(tangent, {0, std::numbers::pi / 2}, kIntervals));
}

TEST(Poles, AreNotWhatContinuousFunctionsHave) {
  const std::vector<std::pair<std::string, std::function<double(double)>>> functions = {
      {"step", [](double x) { return std::tanh(1e4 * (x - 0.3)); }},
      {"steeper step", [](double x) { return std::tanh(1e12 * (x - 0.3)); }},
      {"jump", [](double x) { return x < 0.3 ? -1.0 : 1.0; }},
      {"spike", [](double x) { return 1 / ((x - 0.3003) * (x - 0.3003) + 1e-12); }},
      {"bell", [](double x) { return 1e9 * std::exp(-std::pow((x - 0.30005) / 1e-4, 2)); }},
      {"growth", [](double x) { return std::exp(200 * x); }},
      {"wave", [](double x) { return std::sin(900 * x); }},
      {"root", [](double x) { return std::sqrt(x); }},
      {"cusp", [](double x) { return std::cbrt(x - 0.3); }},
      {"removable gap", [](double x) { return std::sin(x - 1.0 / 60) / (x - 1.0 / 60); }},
      {"pole outside", [](double x) { return 1 / (x + 1e-6); }},
      {"nothing", [](double) { return 0.0; }},
      {"constant", [](double) { return 2.0; }},
      {"far from zero", [](double x) { return 1e9 + x; }}};
  for (const auto& [name, y] : functions) {
    EXPECT_FALSE(find_pole(y, {0, 1}, kIntervals)) << name;
  }
}

TEST(Jumps, AreFoundWithinADomainAndAtItsEnds) {
  const Range domain{1, 2};
  const auto at = [&](double place) {
    return find_jumps([=](double x) { return x < place ? x : x + 1; }, domain, kIntervals);
  };
  for (const double place : {1.2345678, 1.5, 1.9999}) {
    ASSERT_EQ(at(place).size(), 1U) << place;
    EXPECT_NEAR(at(place).front(), place, 1e-12);
  }
  const auto first = find_jumps([](double x) { return x == 1 ? 1.0 : 0.0; }, domain, kIntervals);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_NEAR(first.front(), 1, 1e-12);
  const auto last = find_jumps([](double x) { return x == 2 ? 1.0 : 0.0; }, domain, kIntervals);
  ASSERT_EQ(last.size(), 1U);
  EXPECT_NEAR(last.front(), 2, 1e-12);
}

TEST(Jumps, AreNotWhatContinuousFunctionsHave) {
  int tested = 0;
  for (const auto& f : std::vector<std::function<double(double)>>{
           [](double x) { return std::sqrt(x); }, [](double x) { return std::pow(x, 0.1); },
           [](double x) { return std::tanh(1e6 * (x - 0.4)); },
           [](double x) { return std::abs(x - 0.3); }, [](double) { return 1.0; }}) {
    EXPECT_TRUE(find_jumps(f, Range{0, 1}, kIntervals).empty()) << tested;
    ++tested;
  }
  EXPECT_EQ(tested, 5);
}

}  // namespace
}  // namespace cognate::problems::reading::poles_test
