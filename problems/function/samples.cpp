#include "problems/function/samples.hpp"

#include <algorithm>
#include <memory>
#include <mutex>

#include "problems/function/target/derivatives.hpp"
#include "problems/function/target/fast_places.hpp"
#include "synthesis/exact/chebyshev.hpp"

namespace cognate::problems {
namespace {

using synthesis::AnglePair;
using synthesis::PrecisionPoint;

/// The increments that belong to x.
class Mapping {
 public:
  explicit Mapping(const FunctionOfX& function)
      : function_(function), x0_(function.domain.min), y0_(function.y(x0_)) {
    if (!function.input_range || !function.output_range) return;
    const double x_span = function.domain.max - x0_;
    const double y_span = function.y(function.domain.max) - y0_;
    input_slope_ = *function.input_range / x_span;
    output_slope_ = y_span == 0 ? 0 : *function.output_range / y_span;
    ranged_ = true;
  }

  AnglePair operator()(double x) const {
    const double y = function_.y(x);
    if (!ranged_) return {x, y};
    return {input_slope_ * (x - x0_), output_slope_ * (y - y0_)};
  }

  /// The pair at x as a precision point, with derivatives of the function there found numerically.
  PrecisionPoint point(double x, std::size_t multiplicity, double& error) const {
    const AnglePair pair = (*this)(x);
    PrecisionPoint point{
        .input = pair.input, .output = {pair.output}, .multiplicity = multiplicity};
    if (multiplicity == 1) return point;
    const auto slopes = derivatives(function_.y, x, function_.domain, multiplicity - 1);
    double factor = output_slope_;
    for (std::size_t k = 1; k < multiplicity; ++k) {
      factor /= input_slope_;
      point.output[k] = factor * slopes[k - 1].value;
      error = std::max(error, slopes[k - 1].relative_error);
    }
    return point;
  }

 private:
  FunctionOfX function_;
  double x0_, y0_;
  double input_slope_ = 1, output_slope_ = 1;
  bool ranged_ = false;
};

void sample_function(const FunctionOfX& function, const FunctionProblem& problem,
                     FunctionSamples& result) {
  const Mapping mapping(function);
  const Range domain = function.domain;
  // The function of the problem serves one thread at a time.
  result.at = [mapping, domain, guard = std::make_shared<std::mutex>()](double share) {
    const std::scoped_lock lock(*guard);
    return mapping(share == 1 ? domain.max : domain.min + share * (domain.max - domain.min));
  };
  for (int i = 0; i <= kRangeSteps; ++i) {
    result.range.push_back(result.at(static_cast<double>(i) / kRangeSteps));
  }
  const auto output = [&](double share) { return result.at(share).output; };
  for (const double share : fast_places(output, kRangeSteps)) {
    result.between.emplace_back(share, result.at(share));
  }
  for (const double x : problem.sample_at) result.samples.push_back(mapping(x));
  if (problem.objective == FunctionObjective::exact) {
    const auto at = problem.at.empty() ? synthesis::chebyshev_spacing(domain.min, domain.max,
                                                                      problem.precision_points)
                                       : problem.at;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const int multiplicity = problem.multiplicity.empty() ? 1 : problem.multiplicity[i];
      result.precision.push_back(
          mapping.point(at[i], static_cast<std::size_t>(multiplicity), result.derivative_error));
    }
    result.samples = result.range;
  }
  if (result.samples.empty()) result.samples = result.range;
}

/// The pairs as precision points, with the derivatives that the file gives.
std::vector<PrecisionPoint> precision_of(const AnglePairs& pairs, const FunctionProblem& problem) {
  std::vector<PrecisionPoint> points;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    PrecisionPoint point{.input = pairs[i].first, .output = {pairs[i].second}};
    if (!problem.derivatives.empty()) {
      for (const double derivative : problem.derivatives[i]) {
        point.output[point.multiplicity++] = derivative;
      }
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace

FunctionSamples function_samples(const FunctionProblem& problem) {
  FunctionSamples result;
  if (const auto* pairs = std::get_if<AnglePairs>(&problem.target)) {
    for (const auto& [input, output] : *pairs) result.samples.push_back({input, output});
    if (problem.objective == FunctionObjective::exact) {
      result.precision = precision_of(*pairs, problem);
    }
  } else {
    sample_function(std::get<FunctionOfX>(problem.target), problem, result);
  }
  const auto& motion = result.range.empty() ? result.samples : result.range;
  const auto [least, greatest] = std::ranges::minmax(motion, {}, &AnglePair::input);
  result.sweep = {least.input, greatest.input};
  return result;
}

}  // namespace cognate::problems
