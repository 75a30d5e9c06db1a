#include "synthesis/exact/function/precision_point.hpp"

#include <cmath>

namespace cognate::synthesis {

std::size_t condition_count(std::span<const PrecisionPoint> points) {
  std::size_t count = 0;
  for (const PrecisionPoint& point : points) count += point.multiplicity;
  return count;
}

RealSeries output_series(const PrecisionPoint& point) {
  RealSeries series{};
  double factorial = 1;
  for (std::size_t k = 0; k < point.multiplicity; ++k) {
    if (k > 1) factorial *= static_cast<double>(k);
    series[k] = point.output[k] / factorial;
  }
  return series;
}

ComplexSeries direction_series(const RealSeries& angle, std::size_t count) {
  ComplexSeries e{};
  e[0] = {std::cos(angle[0]), std::sin(angle[0])};
  for (std::size_t k = 1; k < count; ++k) {
    for (std::size_t j = 1; j <= k; ++j) {
      const double weight = static_cast<double>(j) * angle[j] / static_cast<double>(k);
      e[k] = e[k] + weight * perp(e[k - j]);
    }
  }
  return e;
}

RealSeries product(const RealSeries& a, const RealSeries& b, std::size_t count) {
  RealSeries result{};
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t j = 0; j <= k; ++j) result[k] += a[j] * b[k - j];
  }
  return result;
}

ComplexSeries product(const RealSeries& a, const ComplexSeries& b, std::size_t count) {
  ComplexSeries result{};
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t j = 0; j <= k; ++j) result[k] = result[k] + a[j] * b[k - j];
  }
  return result;
}

}  // namespace cognate::synthesis
