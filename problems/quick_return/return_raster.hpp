/// @file The types of quick returns on a raster: how far any combination of a box is from what is
/// desired, at least, and what one combination is.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/quick_return/problem.hpp"
#include "synthesis/raster/bounded_raster.hpp"

namespace cognate::problems {

/// Boxes that branch and bound examines at most: a few seconds.
inline constexpr int kReturnBoxes = 1'000'000;

/// By `ReturnLength`; those that a type has not are 0.
using ReturnLengths = std::array<double, kReturnLengths>;
using ReturnRanges = std::array<Range, kReturnLengths>;

/// The lengths that a type has.
std::span<const ReturnLength> lengths_of(QuickReturnType type);

/// What the file gives of a length; empty where it is open.
std::optional<double> given_length(const QuickReturnProblem& problem, ReturnLength length);

/// The values of the open lengths that the raster of `problem` has a rule for, in their order.
struct ReturnAxes {
  std::vector<ReturnLength> lengths;
  std::vector<synthesis::RasterAxis> axes;
};
ReturnAxes return_axes(const QuickReturnProblem& problem);

/// A type of quick return whose open lengths lie on a raster. The error is the larger of that of
/// θ (see quick_return.hpp), in radians, and that of a four-bar's swing, in radians, or of a
/// slider-crank's or shaper's stroke, relative to it. Second counts the transmission or pressure
/// angle, then the sum of the lengths. Of similar linkages that do the same, and of mirror images,
/// one is kept.
class ReturnRaster : public synthesis::BoundedRaster {
 public:
  explicit ReturnRaster(const QuickReturnProblem& problem);

  std::span<const synthesis::RasterAxis> axes() const override { return axes_.axes; }
  double bound(const synthesis::RasterBox& box) const override;
  std::optional<synthesis::RasterMerit> evaluate(const synthesis::RasterNumbers& at) const override;
  bool accepts(const synthesis::RasterNumbers& at) const override;
  bool is_same(const synthesis::RasterNumbers& a, const synthesis::RasterNumbers& b) const override;

  ReturnLengths lengths(const synthesis::RasterNumbers& at) const;
  /// The values nearest to `between`.
  synthesis::RasterNumbers nearest(const ReturnLengths& between) const;

  /// The error, transmission or pressure, and size of one; empty where its crank does not turn
  /// fully between two limits of the output.
  virtual std::optional<synthesis::RasterMerit> merit(const ReturnLengths& at) const = 0;
  /// The design, where there is a merit.
  virtual std::optional<Design> design(const ReturnLengths& at) const = 0;

 protected:
  /// A true lower bound of the error; infinite where nothing in the ranges meets the limits.
  virtual double least_error(const ReturnRanges& ranges) const = 0;
  virtual bool is_same_design(const ReturnLengths& a, const ReturnLengths& b) const = 0;

  const QuickReturnProblem& problem() const { return problem_; }

 private:
  const QuickReturnProblem& problem_;
  ReturnAxes axes_;
  ReturnRanges given_{};
};

/// The raster of the type of `problem`, which must outlive it.
std::unique_ptr<ReturnRaster> return_raster(const QuickReturnProblem& problem);

/// Each type by itself.
std::unique_ptr<ReturnRaster> rocker_raster(const QuickReturnProblem& problem);
std::unique_ptr<ReturnRaster> slider_raster(const QuickReturnProblem& problem);
std::unique_ptr<ReturnRaster> guide_raster(const QuickReturnProblem& problem);
std::unique_ptr<ReturnRaster> shaper_raster(const QuickReturnProblem& problem);

/// How far `wanted` is from a range, 0 within.
double distance_from(const Range& range, double wanted);

/// Whether a and b are the same but for their size.
bool are_proportional(std::span<const double> a, std::span<const double> b);

}  // namespace cognate::problems
