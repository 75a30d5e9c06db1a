/// The exact worst case over a box of tolerances against a dense search in 113 bits, on random
/// four-bars: worst_cases [COUNT [SEED [POINTS]]]. Exits with 1 where a point lies outside.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "synthesis/tolerance/worst_case.hpp"
#include "tests/support/toleranced_four_bars.hpp"

namespace {

using cognate::test::TolerancedFourBar;

struct Tally {
  int cases = 0, without = 0, outside = 0, wrongly_bounded = 0;
  double widest = 0;  ///< of bound over search, relative
};

void judge(const TolerancedFourBar& linkage, std::mt19937_64& random, int points, Tally& tally) {
  cognate::Response rocker;
  rocker.type = cognate::ResponseType::angle;
  rocker.index = 3;
  ++tally.cases;
  const auto searched = cognate::test::dense_extremes(linkage, random, points);
  const auto worst =
      cognate::synthesis::worst_case(linkage.mechanism(), rocker, linkage.station(), linkage.box());
  if (!worst) {
    ++tally.without;
    return;
  }
  if (!searched) {
    ++tally.wrongly_bounded;
    return;
  }
  const double rounding = 1e-12;
  if (worst->high < searched->high - rounding || worst->low > searched->low + rounding) {
    ++tally.outside;
  }
  const double size = std::max(searched->high, -searched->low);
  tally.widest = std::max(
      {tally.widest, (worst->high - searched->high) / size, (searched->low - worst->low) / size});
}

}  // namespace

int main(int count, char** arguments) {
  const auto number = [&](int place, int usual) {
    return count > place ? std::atoi(arguments[place]) : usual;
  };
  const int cases = number(1, 1000), points = number(3, 2000);
  std::mt19937_64 random(static_cast<std::uint64_t>(number(2, 1)));
  Tally tally;
  for (int i = 0; i < cases; ++i) judge(TolerancedFourBar(random), random, points, tally);
  fmt::print(
      "{} cases, {} points each: {} outside the bounds, {} bounded where a sample cannot be "
      "assembled, {} without bounds (a dead point in the box); bounds wider than what was reached "
      "by {:.2g} at most\n",
      tally.cases, points + 16, tally.outside, tally.wrongly_bounded, tally.without, tally.widest);
  return tally.outside + tally.wrongly_bounded > 0 ? 1 : 0;
}
