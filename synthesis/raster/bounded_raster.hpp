/// @file The best combinations on a raster with a proof: branch and bound by whoever has a true
/// lower bound of the error over a box of combinations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/raster/raster.hpp"
#include "synthesis/search/deadline.hpp"

namespace cognate::synthesis {

/// How good a combination is, compared in this order, less being better. Numbers that differ by
/// rounding (`kSameMerit`) are equal.
struct RasterMerit {
  double error = 0;
  double second = 0;
  double size = 0;
};

/// Errors, or seconds, that round to the same multiple of it are equal.
inline constexpr double kSameMerit = 1e-11;

/// What the search asks of who knows the problem.
class BoundedRaster {
 public:
  virtual ~BoundedRaster() = default;

  /// At least one.
  virtual std::span<const RasterAxis> axes() const = 0;

  /// No more than the error of any combination within `box` that meets the limits, up to rounding;
  /// infinite where none meets them.
  virtual double bound(const RasterBox& box) const = 0;

  /// Of one combination; empty where it breaks a limit.
  virtual std::optional<RasterMerit> evaluate(const RasterNumbers& at) const = 0;

  /// Whether a combination that is good enough to be kept meets what `evaluate` does not look at.
  virtual bool accepts(const RasterNumbers& /*at*/) const { return true; }

  /// Whether two combinations are one design (in two sizes, or mirrored), of which the better is
  /// kept alone.
  virtual bool is_same(const RasterNumbers& /*a*/, const RasterNumbers& /*b*/) const {
    return false;
  }

  /// How much a unit of an axis matters for the bound, relative to one of the others: boxes are
  /// halved where that is most.
  virtual double weight(std::size_t /*axis*/) const { return 1; }
};

struct BoundedRasterOptions {
  std::size_t designs = 1;             ///< combinations to return
  std::uint64_t most_boxes = 200'000;  ///< to examine at most
  const Deadline* deadline = nullptr;
  /// Called now and then with the share of combinations covered and the least error.
  std::function<void(double share, double best)> progress{};
};

struct BoundedRasterResult {
  struct Kept {
    RasterNumbers at;
    RasterMerit merit;
  };
  std::vector<Kept> best;  ///< best first
  /// No combination has a lesser error: that of the best where the search is complete.
  double bound = 0;
  double combinations = 1;
  double covered = 0;  ///< evaluated, or in boxes whose bound excludes them
  std::uint64_t evaluated = 0;
  std::uint64_t boxes = 0;   ///< whose bound was found
  bool is_complete = false;  ///< all are covered
};

/// Best-first branch and bound (Land & Doig 1960); of boxes with the same bound the newest goes
/// first. Ties are resolved: the answer is that of trying every combination.
BoundedRasterResult search_bounded_raster(const BoundedRaster& task,
                                          const BoundedRasterOptions& options);

}  // namespace cognate::synthesis
