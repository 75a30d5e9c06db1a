#include "problems/machine/expression_jumps.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "problems/function/target/jumps.hpp"

namespace cognate::problems::reading {
namespace {

enum Variable : std::size_t { phi, speed, time, travel, rate };
using Values = std::array<double, 5>;

// How finely a turn is searched: the more coarsely, the more the values of the other variables.
constexpr std::size_t kMostIntervals = 7200, kLeastIntervals = 720, kEvaluations = 400'000;
constexpr std::size_t kMostNumbers = 8, kMostProbes = 500;
constexpr double kSame = 1e-12;

// The numbers above 0 that `text` names, the first of them.
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end && numbers.size() < kMostNumbers;) {
    double number = 0;
    const bool in_name = at != text.data() && (std::isalnum(at[-1]) != 0 || at[-1] == '_');
    const auto [behind, error] = in_name || *at == '-'
                                     ? std::from_chars_result{at, std::errc::invalid_argument}
                                     : std::from_chars(at, end, number);
    if (error == std::errc{} && number > 0 && std::isfinite(number)) numbers.push_back(number);
    at = std::max(behind, at + 1);
  }
  return numbers;
}

// A value below, between and beyond the numbers.
std::vector<double> values_about(std::vector<double> numbers) {
  numbers.insert(numbers.end(), {0.1, 1, 10, 100, 1000});
  std::ranges::sort(numbers);
  const auto last = std::ranges::unique(numbers).begin();
  numbers.erase(last, numbers.end());
  std::vector<double> values{0.5 * numbers.front()};
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    values.push_back(std::sqrt(numbers[i - 1]) * std::sqrt(numbers[i]));
  }
  values.push_back(2 * numbers.back());
  return values;
}

std::vector<double> of_either_sign(std::vector<double> values) {
  const std::size_t count = values.size();
  for (std::size_t i = 0; i < count; ++i) values.push_back(-values[i]);
  return values;
}

// Every probe with each of `values` for `variable`.
std::vector<Values> crossed(const std::vector<Values>& probes, Variable variable,
                            const std::vector<double>& values) {
  std::vector<Values> all;
  for (Values probe : probes) {
    for (const double value : values) {
      probe[variable] = value;
      all.push_back(probe);
    }
  }
  return all;
}

std::vector<Values> probes_of(const std::string& text, const std::vector<bool>& uses) {
  const auto names = [&](Variable variable) { return variable < uses.size() && uses[variable]; };
  const std::vector<double> positive = values_about(numbers_in(text));
  std::vector<Values> probes{{0, 1, 0, 0, 0}};
  if (names(time)) probes = crossed(probes, time, positive);
  if (names(travel)) probes = crossed(probes, travel, of_either_sign(positive));
  if (names(speed) || names(rate)) probes = crossed(probes, speed, of_either_sign(positive));
  // Of a body that advances with the drive, and as fast.
  for (Values& probe : probes) probe[rate] = probe[speed];
  if (probes.size() <= kMostProbes) return probes;
  const std::size_t stride = probes.size() / kMostProbes + 1;
  std::vector<Values> some;
  for (std::size_t i = 0; i < probes.size(); i += stride) some.push_back(probes[i]);
  return some;
}

}  // namespace

std::vector<double> jumps_of_expression(const std::string& text, const ParsedExpression& parsed) {
  std::vector<double> jumps;
  if (!parsed.uses[phi]) return jumps;
  const std::vector<Values> probes = probes_of(text, parsed.uses);
  const auto intervals =
      static_cast<int>(std::clamp(kEvaluations / probes.size(), kLeastIntervals, kMostIntervals));
  for (Values values : probes) {
    const auto at_angle = [&](double angle) {
      values[phi] = angle;
      return parsed.value(values);
    };
    const std::vector<double> more = find_jumps(at_angle, intervals);
    jumps.insert(jumps.end(), more.begin(), more.end());
  }
  std::ranges::sort(jumps);
  const auto same = [](double a, double b) { return b - a <= kSame; };
  jumps.erase(std::unique(jumps.begin(), jumps.end(), same), jumps.end());
  return jumps;
}

}  // namespace cognate::problems::reading
