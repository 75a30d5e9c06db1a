#include "problems/reading/jumps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace cognate::problems::reading {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kLeastShare = 0.01;

// The interval's half with the greater step, again and again: at a jump all of the step remains, of
// a function without one nothing.
std::optional<double> jump_between(const std::function<double(double)>& f, double from, double to,
                                   double least) {
  double low = f(from), high = f(to);
  while (std::abs(high - low) >= least) {
    const double middle = std::midpoint(from, to);
    if (middle <= from || middle >= to) return to;
    const double at = f(middle);
    if (std::abs(at - low) >= std::abs(high - at)) {
      to = middle;
      high = at;
    } else {
      from = middle;
      low = at;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<double> find_jumps(const std::function<double(double)>& f, int intervals) {
  const auto angle = [&](int i) { return kTurn * i / intervals; };
  double least = f(0), greatest = least;
  for (int i = 1; i < intervals; ++i) {
    least = std::min(least, f(angle(i)));
    greatest = std::max(greatest, f(angle(i)));
  }
  std::vector<double> jumps;
  const double step = kLeastShare * (greatest - least);
  if (!(step > 0)) return jumps;
  const double before_turn = std::nextafter(kTurn, 0);
  if (std::abs(f(before_turn) - f(0)) >= step) jumps.push_back(0);
  for (int i = 0; i < intervals; ++i) {
    const double end = i + 1 < intervals ? angle(i + 1) : before_turn;
    if (const auto jump = jump_between(f, angle(i), end, step)) jumps.push_back(*jump);
  }
  return jumps;
}

}  // namespace cognate::problems::reading
