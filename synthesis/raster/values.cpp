#include "synthesis/raster/values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cognate::synthesis {
namespace {

/// A multiple that misses a limit by so many steps is rounding.
constexpr double kRounding = 1e-9;

}  // namespace

RasterValues RasterValues::multiples(double step, double lower, double upper) {
  RasterValues made;
  made.step_ = step;
  const double per_unit = std::round(1 / step);
  // 3/10 is the double nearest to 0.3, 3·0.1 is not.
  if (per_unit >= 1 && std::abs(per_unit * step - 1) < 1e-14) made.steps_per_unit_ = per_unit;
  made.first_ = std::ceil(lower / step - kRounding);
  const double last = std::floor(upper / step + kRounding);
  const double count = std::max(0.0, last - made.first_ + 1);
  made.count_ = static_cast<std::int64_t>(std::min(count, double(kMostValues)));
  return made;
}

RasterValues RasterValues::list(std::vector<double> values, double lower, double upper) {
  RasterValues made;
  std::erase_if(values, [&](double value) { return value < lower || value > upper; });
  std::ranges::sort(values);
  const auto repeated = std::ranges::unique(values);
  values.erase(repeated.begin(), repeated.end());
  made.values_ = std::move(values);
  made.count_ = std::ssize(made.values_);
  return made;
}

double RasterValues::at(std::int64_t number) const {
  if (step_ == 0) return values_[static_cast<std::size_t>(number)];
  const double multiple = first_ + static_cast<double>(number);
  return steps_per_unit_ > 0 ? multiple / steps_per_unit_ : multiple * step_;
}

std::int64_t RasterValues::floor(double value) const {
  if (step_ == 0) {
    return std::ranges::upper_bound(values_, value) - values_.begin() - 1;
  }
  const double number =
      std::clamp(std::floor(value / step_) - first_, -1.0, static_cast<double>(count_ - 1));
  auto found = static_cast<std::int64_t>(number);
  // The quotient may be rounded across a whole number.
  if (found + 1 < count_ && at(found + 1) <= value) ++found;
  if (found >= 0 && at(found) > value) --found;
  return found;
}

std::int64_t RasterValues::nearest(double value) const {
  const std::int64_t below = floor(value);
  if (below < 0) return 0;
  if (below + 1 >= count_) return below;
  return value - at(below) <= at(below + 1) - value ? below : below + 1;
}

double RasterValues::position(double value) const {
  const std::int64_t below = floor(value);
  if (below < 0) return 0;
  if (below + 1 >= count_) return static_cast<double>(below);
  const double low = at(below), high = at(below + 1);
  return static_cast<double>(below) + (value - low) / (high - low);
}

}  // namespace cognate::synthesis
