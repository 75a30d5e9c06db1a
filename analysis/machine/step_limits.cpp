#include "analysis/machine/step_limits.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::machine {
namespace {

/// Bends by less than this part of the size are left to the control of errors.
constexpr double kBend = 0.1;
/// The longest step anywhere, in parts of the interval.
constexpr double kCoarsest = 1.0 / 24;

}  // namespace

StepLimits::StepLimits(double from, double length, std::size_t samples)
    : from_(from),
      cell_(length / static_cast<double>(samples)),
      longest_(samples, kCoarsest * length) {}

void StepLimits::shorten(std::span<const double> values, std::span<const int> stretches,
                         double size) {
  const std::size_t count = samples();
  const double least = kBend * size;
  for (std::size_t stride = 1; static_cast<double>(stride) <= kCoarsest * double(count);
       stride *= 2) {
    const double step = static_cast<double>(stride) * cell_;
    for (std::size_t i = stride; i + stride < count; ++i) {
      if (stretches[i - stride] != stretches[i + stride]) continue;
      const double bend = values[i - stride] - 2 * values[i] + values[i + stride];
      if (std::abs(bend) > least) longest_[i] = std::min(longest_[i], step);
    }
  }
  grade();
}

void StepLimits::shorten(double longest) {
  for (double& step : longest_) step = std::min(step, longest);
}

void StepLimits::grade() {
  for (std::size_t i = 1; i < samples(); ++i) {
    longest_[i] = std::min(longest_[i], longest_[i - 1] + cell_);
  }
  for (std::size_t i = samples() - 1; i > 0; --i) {
    longest_[i - 1] = std::min(longest_[i - 1], longest_[i] + cell_);
  }
}

double StepLimits::at(double x) const {
  const double cell = std::clamp((x - from_) / cell_, 0.0, static_cast<double>(samples() - 1));
  return longest_[static_cast<std::size_t>(cell)];
}

}  // namespace cognate::machine
