#include "problems/chain/raster/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "problems/chain/crank_angles/in_order.hpp"
#include "problems/chain/crank_angles/starts.hpp"
#include "problems/chain/placed_fit.hpp"
#include "problems/chain/raster/axes.hpp"
#include "problems/chain/raster/descent.hpp"
#include "problems/chain/refine.hpp"
#include "problems/chain/starts/placed.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/raster/options.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/raster/shared_work.hpp"

namespace cognate::problems {
namespace {

using synthesis::RasterBox;
using synthesis::RasterNumbers;
using synthesis::RasterPoint;

constexpr double kRelaxedTolerance = 1e-10;
constexpr int kRelaxedIterations = 60;
constexpr double kChainFeasibility = 1e-9;  ///< of a cosine
/// Of a target that may be moved: minima of one design at several directions and sizes.
constexpr std::size_t kMovedMinima = 16;

/// How many of the best combinations are each searched as a problem of its own, where dimensions
/// are free beside the raster.
constexpr std::size_t kSearchedChains = 6;

class ChainRaster final : public synthesis::RasterTask {
 public:
  ChainRaster(const Raster& raster, const ScaledChain& scaled, const TargetScale& scale,
              const ChainAcceptance& accepts)
      : scaled_(scaled),
        scale_(scale),
        accepts_(accepts),
        all_(chain_axes(raster, scaled, scale)) {}

  std::span<const synthesis::RasterAxis> axes() const override { return all_.axes; }
  const ChainAxes& all() const { return all_; }

  std::vector<RasterPoint> relax(const RasterBox& box,
                                 std::span<const RasterPoint> from) const override {
    const ScaledChain restricted = within(box);
    std::vector<RasterPoint> minima;
    for (const RasterPoint& start : from) {
      auto found = relaxed(restricted, start);
      const auto same = [&](const RasterPoint& known) {
        return known.form == found.form &&
               std::abs(known.objective - found.objective) <= 1e-9 * known.objective &&
               (!scaled_.is_movable || are_near(known, found));
      };
      if (std::isfinite(found.objective) && std::ranges::none_of(minima, same)) {
        minima.push_back(std::move(found));
      }
    }
    return minima;
  }

  /// The minima of one combination that a search begun with none known finds.
  std::vector<RasterPoint> searched(const RasterNumbers& at, const Solve& options, const Run& run,
                                    const Deadline& deadline, Work& work) const {
    const std::vector<ScaledChain> single{within({at, at})};
    std::vector<RasterPoint> points;
    for (const ChainMinimum& one : search_chains(single, options, run, deadline, work).designs) {
      points.push_back(point(one));
    }
    return relax({at, at}, points);
  }

  /// From the minima known, and from wherever the crank may be at the points.
  std::vector<RasterPoint> evaluate(const RasterNumbers& at,
                                    std::span<const RasterPoint> from) const override {
    if (scaled_.is_movable) return evaluate_moved(at, from);
    std::vector<RasterPoint> starts(from.begin(), from.end());
    for (const synthesis::ChainDesign& design : designs_at(at, from)) {
      for (auto& angles : scaled_.timed() ? first_phases(scaled_, design, kPhasesInTurn)
                                          : ordered_angles(scaled_, design)) {
        starts.push_back(point_of({design, std::move(angles), {}}));
      }
    }
    return RasterTask::evaluate(at, starts);
  }

  bool accepts(const RasterPoint& point) const override { return accepts_(chain(point)); }

  /// Whether a combination leaves no dimension free.
  bool is_given_whole() const { return scaled_.free.size() == all_.axes.size(); }

  RasterPoint point(const ChainMinimum& found) const {
    return point_of({found.design, found.angles, {}, found.rms * found.rms});
  }

  RasterPoint point(const PlacedChain& placed) const {
    return point_of({placed.design, placed.angles, placed.at, placed.objective});
  }

  RasterChain chain(const RasterPoint& point) const {
    RasterChain made{scale_.out_of(scaled_.chain, design_of(point)), angles_of(point), {}};
    if (scaled_.is_movable) made.placement = placement(place_of(point));
    for (std::size_t i = 0; i < all_.places.size(); ++i) {
      // Without the rounding of the scale.
      const auto& values = all_.axes[i].values;
      made.design.parameters[all_.places[i].parameter] = values.at(values.nearest(point.values[i]));
    }
    return made;
  }

 private:
  static constexpr int kPhasesInTurn = 8;

  /// The designs of a combination: where the raster leaves a dimension free those of `from`, else
  /// one for each assembly that the file allows.
  std::vector<synthesis::ChainDesign> designs_at(const RasterNumbers& at,
                                                 std::span<const RasterPoint> from) const {
    std::vector<synthesis::ChainDesign> designs;
    for (const RasterPoint& point : from) {
      designs.push_back(design_of(point));
      set_numbers(all_, at, designs.back());
      if (is_given_whole()) break;
    }
    if (designs.empty() || !is_given_whole()) return designs;
    for (std::size_t i = 0; i < scaled_.lines.size(); ++i) {
      if (!is_dyad(scaled_.lines[i].line.type) || scaled_.topology->lines[i].assembly) continue;
      const std::size_t count = designs.size();
      for (std::size_t k = 0; k < count; ++k) {
        designs.push_back(designs[k]);
        designs.back().side[i] *= -1;
      }
    }
    return designs;
  }

  /// Of a target that may be moved its place and the crank are found first, the dimensions fixed,
  /// from the nearest design known.
  std::vector<RasterPoint> evaluate_moved(const RasterNumbers& at,
                                          std::span<const RasterPoint> from) const {
    const auto apart = [&](const RasterPoint& point) { return distance(point, at); };
    const auto nearest = std::ranges::min_element(from, {}, apart);
    if (nearest == from.end()) return {};
    PlacedChain chain = placed(*nearest);
    set_numbers(all_, at, chain.design);
    fit_place(scaled_, chain);
    if (!std::isfinite(chain.objective)) return {};
    return RasterTask::evaluate(at, std::array{point(chain)});
  }

  PlacedChain placed(const RasterPoint& point) const {
    return {design_of(point), angles_of(point), place_of(point), point.objective};
  }

  /// In values of the axes, their steps as the unit.
  double distance(const RasterPoint& point, const RasterNumbers& at) const {
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const double away =
          all_.axes[i].values.position(point.values[i]) - static_cast<double>(at[i]);
      sum += away * away;
    }
    return sum;
  }

  static bool are_near(const RasterPoint& a, const RasterPoint& b) {
    for (std::size_t i = 0; i < a.values.size(); ++i) {
      if (std::abs(a.values[i] - b.values[i]) > 1e-6 * (1 + std::abs(a.values[i]))) return false;
    }
    return true;
  }

  /// Where the target comes, in the file's unit.
  CurvePlacement placement(const TargetPlace& at) const {
    const double square = squared_norm(at.turn);
    const Vec2d back = (1 / square) * conj(at.turn);
    return {1 / std::sqrt(square), angle_of(back),
            scale_.centre - back * (scale_.centre + scale_.size * at.shift)};
  }

  ScaledChain within(const RasterBox& box) const {
    ScaledChain restricted = scaled_;
    for (std::size_t i = 0; i < all_.places.size(); ++i) {
      const auto& [parameter, origin, size] = all_.places[i];
      const double low = (all_.axes[i].values.at(box.first[i]) - origin) / size;
      const double high = (all_.axes[i].values.at(box.last[i]) - origin) / size;
      restricted.lower[parameter] = low;
      restricted.upper[parameter] = high;
      if (box.first[i] == box.last[i]) restricted.given[parameter] = low;
    }
    restricted.free.clear();
    for (std::size_t i = 0; i < restricted.given.size(); ++i) {
      if (!restricted.given[i]) restricted.free.push_back(static_cast<int>(i));
    }
    return restricted;
  }

  RasterPoint relaxed(const ScaledChain& restricted, const RasterPoint& from) const {
    synthesis::ChainDesign design = design_of(from);
    for (std::size_t i = 0; i < design.parameters.size(); ++i) {
      design.parameters[i] = restricted.given[i].value_or(
          std::clamp(design.parameters[i], restricted.lower[i], restricted.upper[i]));
    }
    return point_of(refine(restricted, design, angles_of(from), synthesis::Solver::gauss_newton,
                           {.tolerance = kRelaxedTolerance, .max_iterations = kRelaxedIterations},
                           place_of(from)));
  }

  /// The parameters, the target's place, then the angles; the sides as the form, a bit for each
  /// line to the left.
  RasterPoint point_of(const RefinedChain& refined) const {
    RasterPoint made;
    made.objective = refined.objective;
    made.violation = refined.violation;
    made.x = refined.design.parameters;
    made.x.insert(made.x.end(),
                  {refined.at.turn.x, refined.at.turn.y, refined.at.shift.x, refined.at.shift.y});
    made.x.insert(made.x.end(), refined.angles.begin(), refined.angles.end());
    for (std::size_t i = 0; i < refined.design.side.size(); ++i) {
      if (refined.design.side[i] > 0) made.form |= 1 << i;
    }
    for (const auto& [parameter, origin, size] : all_.places) {
      made.values.push_back(origin + size * made.x[parameter]);
    }
    return made;
  }

  synthesis::ChainDesign design_of(const RasterPoint& point) const {
    synthesis::ChainDesign design;
    const auto count = static_cast<std::ptrdiff_t>(scaled_.given.size());
    design.parameters.assign(point.x.begin(), point.x.begin() + count);
    for (std::size_t i = 0; i < scaled_.lines.size(); ++i) {
      const bool has_side = is_dyad(scaled_.lines[i].line.type);
      design.side.push_back(!has_side ? 0 : (point.form & (1 << i)) != 0 ? 1 : -1);
    }
    return design;
  }

  TargetPlace place_of(const RasterPoint& point) const {
    const double* own = point.x.data() + scaled_.given.size();
    return {{own[0], own[1]}, {own[2], own[3]}};
  }

  std::vector<double> angles_of(const RasterPoint& point) const {
    const std::size_t before = scaled_.given.size() + TargetPlace::kNumbers;
    return {point.x.begin() + static_cast<std::ptrdiff_t>(before), point.x.end()};
  }

  const ScaledChain& scaled_;
  const TargetScale& scale_;
  const ChainAcceptance& accepts_;
  ChainAxes all_;
};

}  // namespace

RasterChainResult search_chain_raster(const ChainPathProblem& problem, const ScaledChain& scaled,
                                      const TargetScale& scale,
                                      const std::vector<ChainMinimum>& found,
                                      const ChainAcceptance& accepts, const Run& run,
                                      const Deadline& deadline, Work& work) {
  const ChainRaster raster(*problem.raster, scaled, scale, accepts);
  std::vector<RasterPoint> from, known;
  auto options = raster_options(problem.solve, *problem.raster, run, deadline);
  options.feasibility = kChainFeasibility;
  options.met = kMetExactly;
  options.searched = kSearchedChains;
  if (scaled.is_movable) {
    const auto starts = placed_starts(scaled, found);
    for (const PlacedChain& start : starts) from.push_back(raster.point(start));
    for (const PlacedChain& chain :
         descend_on_raster(scaled, raster.all(), starts, run.threads, deadline)) {
      known.push_back(raster.point(chain));
    }
    options.known = known;
    options.minima = kMovedMinima;
  } else {
    for (const ChainMinimum& one : found) from.push_back(raster.point(one));
  }
  SharedWork shared(work);
  const Run alone = of_one_combination(run);
  if (!scaled.is_movable && !raster.is_given_whole()) {
    options.search = [&](const RasterNumbers& at) {
      return shared.counted(
          [&](Work& own) { return raster.searched(at, problem.solve, alone, deadline, own); });
    };
  }
  RasterChainResult result;
  result.search = synthesis::search_raster(raster, from, options);
  // What is free beside the raster, and a target's place, are minima found from others.
  result.search.is_enumerated =
      result.search.is_enumerated && raster.is_given_whole() && !scaled.is_movable;
  for (const RasterPoint& point : result.search.designs) {
    result.designs.push_back(raster.chain(point));
  }
  return result;
}

}  // namespace cognate::problems
