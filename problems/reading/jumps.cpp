#include "problems/reading/jumps.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "problems/machine/drive_angle.hpp"

namespace cognate::problems::reading {
namespace {

constexpr double kLeastShare = 0.01;

struct Sample {
  double at = 0;
  double value = 0;
};

// The interval's half with the greater step, again and again: at a jump all of the step remains, of
// a function without one nothing.
std::optional<double> jump_between(const std::function<double(double)>& f, Sample from, Sample to,
                                   double least) {
  while (std::abs(to.value - from.value) >= least) {
    const double middle = std::midpoint(from.at, to.at);
    if (middle <= from.at || middle >= to.at) return to.at;
    const Sample between{middle, f(middle)};
    if (std::abs(between.value - from.value) >= std::abs(to.value - between.value)) {
      to = between;
    } else {
      from = between;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<double> find_jumps(const std::function<double(double)>& f, int intervals) {
  const auto angle = [&](int i) { return kTurn * i / intervals; };
  const double before_turn = std::nextafter(kTurn, 0);
  std::vector<double> values;
  for (int i = 0; i < intervals; ++i) values.push_back(f(angle(i)));
  values.push_back(f(before_turn));
  double least = values.front(), greatest = least;
  for (const double value : values) {
    least = std::fmin(least, value);  // passes over what is NaN
    greatest = std::fmax(greatest, value);
  }
  std::vector<double> jumps;
  const double step = kLeastShare * (greatest - least);
  if (!(step > 0)) return jumps;
  if (std::abs(values.back() - values.front()) >= step) jumps.push_back(0);
  for (int i = 0; i < intervals; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Sample from{angle(i), values[k]};
    const Sample to{i + 1 < intervals ? angle(i + 1) : before_turn, values[k + 1]};
    if (const auto jump = jump_between(f, from, to, step)) jumps.push_back(*jump);
  }
  return jumps;
}

}  // namespace cognate::problems::reading
