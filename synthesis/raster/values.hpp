/// @file The values that a dimension on a raster may take.
#pragma once

#include <cstdint>
#include <vector>

namespace cognate::synthesis {

/// Ascending values, either multiples of a step or a list. Numbered from 0.
class RasterValues {
 public:
  /// k·step for all whole k within [lower, upper], which are finite, of step > 0; at most
  /// `kMostValues`, beyond which the upper ones are left out.
  static RasterValues multiples(double step, double lower, double upper);
  /// Those of `values` within [lower, upper], ascending, each once.
  static RasterValues list(std::vector<double> values, double lower, double upper);

  static constexpr std::int64_t kMostValues = std::int64_t{1} << 40;

  std::int64_t count() const { return count_; }
  double at(std::int64_t number) const;
  /// The number of the greatest value that is no greater than `value`; −1 where there is none.
  std::int64_t floor(double value) const;
  /// The number of the value nearest to `value`; there is at least one value.
  std::int64_t nearest(double value) const;
  /// Where `value` lies among the numbers, linear between neighbours; 0 … count − 1.
  double position(double value) const;

 private:
  std::int64_t count_ = 0;
  double step_ = 0;            ///< 0: a list
  double steps_per_unit_ = 0;  ///< 1/step where that is a whole number, else 0
  double first_ = 0;           ///< k of the first multiple, which is exact in a double
  std::vector<double> values_;
};

}  // namespace cognate::synthesis
