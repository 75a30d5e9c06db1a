/// @file The best design whose dimensions lie on a raster: branch and bound over dimensions that
/// take single values, by whoever can find minima within a box of them.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "synthesis/raster/values.hpp"
#include "synthesis/search/deadline.hpp"

namespace cognate::synthesis {

/// A dimension on the raster.
struct RasterAxis {
  std::string name;
  RasterValues values;  ///< at least one
};

/// Numbers of values, one for each axis.
using RasterNumbers = std::vector<std::int64_t>;

/// Of each axis the values from `first` to `last`, both among them.
struct RasterBox {
  RasterNumbers first, last;

  bool is_single() const { return first == last; }
};

/// A design, on the raster or between its values.
struct RasterPoint {
  std::vector<double> values;  ///< of the axes
  double objective = std::numeric_limits<double>::infinity();
  double violation = 0;   ///< of constraints, 0 or less than the feasibility where they are met
  std::vector<double> x;  ///< the unknowns of who found it, from where it goes on
  int form = 0;           ///< which of several models they belong to
};

/// What a search on the raster asks of who knows the problem. Every function may be called from
/// many threads at once.
class RasterTask {
 public:
  virtual ~RasterTask() = default;

  /// At least one.
  virtual std::span<const RasterAxis> axes() const = 0;

  /// Minima of the objective within `box`, no values of the axes but their ranges being prescribed;
  /// each found from one of `from`, which may lie outside. Different ones.
  virtual std::vector<RasterPoint> relax(const RasterBox& box,
                                         std::span<const RasterPoint> from) const = 0;

  /// Designs at one combination of values, from `from`, in any order: the best that is accepted
  /// counts. By default the minima that `relax` finds there.
  virtual std::vector<RasterPoint> evaluate(const RasterNumbers& at,
                                            std::span<const RasterPoint> from) const {
    return relax({at, at}, from);
  }

  /// Whether a design at one combination meets what `violation` does not know of.
  virtual bool accepts(const RasterPoint& /*point*/) const { return true; }
};

/// How a search on the raster is run.
struct RasterOptions {
  double feasibility = 1e-9;          ///< violations up to this count as none
  double met = 0;                     ///< objectives up to this are rounding
  std::size_t designs = 1;            ///< combinations to return
  std::uint64_t most_nodes = 20'000;  ///< boxes to examine at most
  /// Up to so many combinations each is evaluated, none being left to a bound.
  double enumerate = 20'000;
  /// Designs at combinations that are known already: looked at first.
  std::span<const RasterPoint> known{};
  std::size_t minima = 6;  ///< that a box keeps, from which its halves go on
  /// Designs at one combination from a search that begins with none known; set where something is
  /// free beside the axes. In the end the `searched` most promising combinations are searched by
  /// it, or all where there are no more. Called from many threads at once.
  std::function<std::vector<RasterPoint>(const RasterNumbers& at)> search{};
  std::size_t searched = 0;
  int threads = 0;  ///< as in `thread_count`; the result does not depend on it
  const Deadline* deadline = nullptr;
  /// Called now and then from one thread with the share of combinations covered and the best
  /// objective.
  std::function<void(double share, double best)> progress{};
};

/// What a search on the raster found.
struct RasterResult {
  std::vector<RasterPoint> designs;    ///< on the raster, best first, accepted ones alone
  std::optional<RasterPoint> relaxed;  ///< the best between the values
  std::optional<RasterPoint> rounded;  ///< at the values nearest to that
  bool rounded_is_accepted = false;    ///< whether the latter meets all constraints
  /// The least objective that a combination not covered may still have by the minima found in its
  /// box; the best design's where all are covered. Proven where `is_enumerated`; else as good as
  /// the minima, which are local.
  double bound = 0;
  bool is_complete = false;    ///< all combinations are covered
  bool is_enumerated = false;  ///< each was evaluated
  double combinations = 1;     ///< how many there are
  double covered = 0;  ///< how many were evaluated, or lie in boxes none of whose minima is better
  std::uint64_t evaluated = 0;  ///< combinations that were evaluated
  std::uint64_t boxes = 0;      ///< whose minima were found
  std::size_t searched = 0;     ///< combinations that were searched with none known
  bool ended_early = false;     ///< by its deadline
};

/// Two searches of rasters that together are one: the best and the bounds of either, their counts
/// added up.
RasterResult together(RasterResult a, RasterResult b);

/// Searches the raster from minima that are known, `from`, in any order.
///
/// Where there are few combinations each is evaluated. Else branch and bound (Land & Doig 1960, "An
/// automatic method of solving discrete programming problems"): a box whose minima are no better
/// than the best combination known is covered; another is divided where its best minimum lies
/// farthest between two values, those of the least minima first. Combinations come from rounding
/// the minima of each box, from fixing one axis after the other, and from the neighbours of the
/// best.
RasterResult search_raster(const RasterTask& task, std::span<const RasterPoint> from,
                           const RasterOptions& options);

}  // namespace cognate::synthesis
