#include "analysis/cam/subdivision.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::cam {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Between the nodes, nowhere near the middle between two or a symmetric pair.
constexpr double kChecks[] = {-0.8631, 0.3377};

double magnitude(double from, double to) {
  return std::max(std::abs(from), std::abs(to));
}

/// Infinite if one of the values is no number.
double largest(const ChebyshevSamples& values) {
  double size = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) return kInfinity;
    size = std::max(size, std::abs(value));
  }
  return size;
}

}  // namespace

Subdivision::Subdivision(FunctionRef f, double from, double to, double scale)
    : f_(f),
      end_{to, f(to)},
      scale_(scale > 0 && std::isfinite(scale) ? scale : 0),
      least_width_(std::ldexp(to - from, -50)) {
  pending_.reserve(64);
  pending_.push_back({from, to, f(from), end_.value, kInfinity});
  if (!(from < to)) taken_ = 1;
}

const Subinterval* Subdivision::next() {
  while (taken_ < pending_.size()) {
    const Pending pending = pending_[taken_++];
    sample(pending);
    is_resolved_ = is_good();
    if (is_resolved_ || !split(pending)) return &current_;
  }
  return nullptr;
}

void Subdivision::sample(const Pending& pending) {
  current_.from = pending.from;
  current_.to = pending.to;
  current_.coarser_misfit = pending.coarser_misfit;
  current_.values.front() = pending.at_from;
  current_.values.back() = pending.at_to;
  for (std::size_t j = 1; j + 1 < kChebyshevSize; ++j) {
    current_.values[j] = f_(current_.at(chebyshev_node(j)));
  }
  current_.size = std::max(scale_, largest(current_.values));
  current_.misfit = kInfinity;
  if (!std::isfinite(current_.size)) {
    current_.size = scale_;
    return;
  }
  current_.series = interpolant(current_.values);
  current_.misfit = misfit();
  // Rounding of the last coefficients would be multiplied by their orders in the derivative.
  drop_last(current_.series, 4 * kEpsilon * current_.size);
}

/// The greatest of the last coefficients; if these let it pass, of the errors at the checks too.
double Subdivision::misfit() const {
  double worst = 0;
  for (std::size_t k = kChebyshevSize - 3; k < kChebyshevSize; ++k) {
    worst = std::max(worst, std::abs(current_.series[k]));
  }
  if (worst > kTight * current_.size && !is_stagnant(worst)) return worst;
  for (const double t : kChecks) {
    const double error = f_(current_.at(t)) - value_and_slope(current_.series, t).value;
    worst = std::isfinite(error) ? std::max(worst, std::abs(error)) : kInfinity;
  }
  return worst;
}

/// The error that f itself may have.
double Subdivision::noise() const {
  double steepest = 0;
  for (std::size_t j = 1; j < kChebyshevSize; ++j) {
    const double width = current_.at(chebyshev_node(j)) - current_.at(chebyshev_node(j - 1));
    const double change = std::abs(current_.values[j] - current_.values[j - 1]);
    if (width > 0) steepest = std::max(steepest, change / width);
  }
  const double of_argument = 4 * kEpsilon * magnitude(current_.from, current_.to) * steepest;
  return std::clamp(of_argument, kNoise * current_.size, kSteepNoise * current_.size);
}

bool Subdivision::is_good() const {
  if (!std::isfinite(current_.misfit)) return false;
  if (current_.misfit <= kTight * current_.size) return true;
  return is_stagnant(current_.misfit) && current_.misfit <= noise();
}

/// Whether halving the interval has hardly improved the misfit.
bool Subdivision::is_stagnant(double misfit) const {
  return 4 * misfit >= current_.coarser_misfit;
}

bool Subdivision::split(const Pending& pending) {
  const auto [from, to, at_from, at_to, coarser] = pending;
  const auto is_number = [](double value) { return std::isfinite(value); };
  if (std::ranges::none_of(current_.values, is_number)) return false;
  const double least = std::max(least_width_, 8 * kEpsilon * magnitude(from, to));
  if (!(to - from > least) || pending_.size() + 2 > kMostIntervals) return false;
  const double middle = current_.at(0), at_middle = current_.values[kChebyshevDegree / 2];
  pending_.push_back({from, middle, at_from, at_middle, current_.misfit});
  pending_.push_back({middle, to, at_middle, at_to, current_.misfit});
  return true;
}

}  // namespace cognate::cam
