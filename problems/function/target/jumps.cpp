#include "problems/function/target/jumps.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/drive_angle.hpp"

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

/// The greatest value less the least.
double variation(const std::vector<Sample>& samples) {
  double least = samples.front().value, greatest = least;
  for (const Sample& sample : samples) {
    least = std::fmin(least, sample.value);  // passes over what is NaN
    greatest = std::fmax(greatest, sample.value);
  }
  return greatest - least;
}

/// The jumps of at least `least` between neighbouring samples.
std::vector<double> jumps_among(const std::function<double(double)>& f,
                                const std::vector<Sample>& samples, double least) {
  std::vector<double> jumps;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (const auto jump = jump_between(f, samples[i - 1], samples[i], least)) {
      jumps.push_back(*jump);
    }
  }
  return jumps;
}

}  // namespace

std::vector<double> find_jumps(const std::function<double(double)>& f, int intervals) {
  const auto angle = [&](int i) { return kTurn * i / intervals; };
  std::vector<Sample> samples;
  for (int i = 0; i < intervals; ++i) samples.push_back({angle(i), f(angle(i))});
  const double before_turn = std::nextafter(kTurn, 0);
  samples.push_back({before_turn, f(before_turn)});
  const double least = kLeastShare * variation(samples);
  if (!(least > 0)) return {};
  std::vector<double> jumps = jumps_among(f, samples, least);
  const bool at_seam = std::abs(samples.back().value - samples.front().value) >= least;
  if (at_seam) jumps.insert(jumps.begin(), 0);
  return jumps;
}

std::vector<double> find_jumps(const std::function<double(double)>& f, const Range& domain,
                               int intervals) {
  std::vector<Sample> samples;
  for (int i = 0; i <= intervals; ++i) {
    const double x =
        i == intervals ? domain.max : std::lerp(domain.min, domain.max, double(i) / intervals);
    samples.push_back({x, f(x)});
  }
  const double least = kLeastShare * variation(samples);
  return least > 0 ? jumps_among(f, samples, least) : std::vector<double>{};
}

}  // namespace cognate::problems::reading
