#include "problems/function/target/poles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace cognate::problems::reading {
namespace {

/// The last halvings, over which |y| must still grow.
constexpr std::size_t kLastSteps = 8;

/// Least growth with each halving: of |x|^-1/4.
const double kGrowth = std::pow(2, 0.25);

/// Follows |y| from a maximum among samples.
class Ascent {
 public:
  Ascent(const std::function<double(double)>& y, const Range& domain, double x)
      : y_(y), domain_(domain), x_(x), size_(size(x)) {}

  double x() const { return x_; }

  /// Whether |y| grows from the distance `step` between samples down to the last digits of x.
  bool grows_without_bound(double step) {
    const double scale = std::max(std::abs(domain_.min), std::abs(domain_.max));
    const double least = 8 * std::numeric_limits<double>::epsilon() * scale;
    std::vector<double> sizes{size_};
    while ((step *= 0.5) > least) {
      move(x_ - step, x_ + step);
      sizes.push_back(size_);
      if (std::isinf(size_)) return true;
    }
    if (sizes.size() > kLastSteps && grew(size_, sizes[sizes.size() - 1 - kLastSteps])) return true;
    // Where the maximum is an end next to the pole, |y| does not grow from there but towards it.
    return grew(size_beside(least), size_beside(std::ldexp(least, kLastSteps)));
  }

 private:
  double size(double x) const {
    const double value = std::abs(y_(x));
    return std::isnan(value) ? 0 : value;
  }

  static bool grew(double size, double before) {
    return size > 0 && size >= before * std::pow(kGrowth, static_cast<double>(kLastSteps));
  }

  /// The greater size at a distance from the maximum, within the domain.
  double size_beside(double distance) const {
    double greatest = 0;
    for (const double x : {x_ - distance, x_ + distance}) {
      if (x >= domain_.min && x <= domain_.max) greatest = std::max(greatest, size(x));
    }
    return greatest;
  }

  void move(double left, double right) {
    const double centre = x_;
    for (const double x : {left, right}) {
      if (x < domain_.min || x > domain_.max || x == centre) continue;
      const double there = size(x);
      if (!(there > size_)) continue;
      x_ = x;
      size_ = there;
    }
  }

  const std::function<double(double)>& y_;
  Range domain_;
  double x_, size_;
};

}  // namespace

std::optional<double> find_pole(const std::function<double(double)>& y, const Range& domain,
                                int intervals) {
  const double step = (domain.max - domain.min) / intervals;
  std::vector<double> sizes;
  const auto x_at = [&](int i) { return i == intervals ? domain.max : domain.min + step * i; };
  for (int i = 0; i <= intervals; ++i) sizes.push_back(std::abs(y(x_at(i))));
  for (int i = 0; i <= intervals; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool from_left = i == 0 || sizes[k] >= sizes[k - 1];
    const bool from_right = i == intervals || sizes[k] >= sizes[k + 1];
    if (!from_left || !from_right) continue;
    Ascent climb(y, domain, x_at(i));
    if (climb.grows_without_bound(step)) return climb.x();
  }
  return std::nullopt;
}

}  // namespace cognate::problems::reading
