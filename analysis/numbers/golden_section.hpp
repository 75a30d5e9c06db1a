/// @file The golden section: a minimum enclosed ever more narrowly, one value of the function a
/// step.
#pragma once

#include <numbers>
#include <utility>

namespace cognate {

/// What encloses a minimum: [from, to], two places between, and the values there.
struct GoldenBracket {
  double from = 0, to = 0;
  double low = 0, high = 0;
  double at_low = 0, at_high = 0;

  double middle() const { return 0.5 * (from + to); }
  double least() const { return at_low < at_high ? at_low : at_high; }
};

/// After `steps` steps from [from, to], which encloses one minimum of `function`; each leaves 0.618
/// of the width (Kiefer, "Sequential minimax search for a maximum", 1953).
template <class Function>
GoldenBracket golden_section(const Function& function, double from, double to, int steps) {
  constexpr double kGolden = 1 / std::numbers::phi;
  GoldenBracket b{from, to, to - kGolden * (to - from), from + kGolden * (to - from)};
  b.at_low = function(b.low);
  b.at_high = function(b.high);
  for (int step = 0; step < steps; ++step) {
    if (b.at_low < b.at_high) {
      b.to = std::exchange(b.high, b.low);
      b.at_high = b.at_low;
      b.low = b.to - kGolden * (b.to - b.from);
      b.at_low = function(b.low);
    } else {
      b.from = std::exchange(b.low, b.high);
      b.at_low = b.at_high;
      b.high = b.from + kGolden * (b.to - b.from);
      b.at_high = function(b.high);
    }
  }
  return b;
}

}  // namespace cognate
