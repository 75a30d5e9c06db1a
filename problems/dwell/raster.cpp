#include "problems/dwell/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/raster/axes.hpp"
#include "problems/raster/options.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/raster/shared_work.hpp"

namespace cognate::problems {
namespace {

using synthesis::RasterBox;
using synthesis::RasterNumbers;
using synthesis::RasterPoint;

/// So few combinations are evaluated one by one: each is fitted in every assembly.
constexpr double kEvaluatedDwells = 2000;
/// Minima of a box, from which its halves go on.
constexpr std::size_t kDwellMinima = 3;
/// Crank angles at which the dwell of one combination is looked for.
constexpr int kDwellScan = 360;
/// A half band that is none: rounding of angles.
constexpr double kNoBand = 1e-9;

/// Where, of evenly spread crank angles, a dwell of one mechanism begins best; the start that it
/// has where the output is nowhere assembled for so long.
double scanned_start(const DwellSpace& space, const DwellDesign& design, double over) {
  const std::vector<double> side(design.chain.side.begin(), design.chain.side.end());
  FreeChain chain(space, design.chain.parameters, side);
  std::vector<Vec2d> way;
  for (int i = 0; i < kDwellScan; ++i) {
    const Vec2d* at = chain.at(kTurn * i / kDwellScan);
    way.push_back(at[space.to] - at[space.from]);
  }
  const int window = static_cast<int>(std::ceil(over / kTurn * kDwellScan));
  double start = design.start.front(), least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kDwellScan; ++i) {
    double low = 0, high = 0;
    for (int k = 1; k <= window && high - low < least; ++k) {
      const double angle = relative_angle(way[static_cast<std::size_t>((i + k) % kDwellScan)],
                                          way[static_cast<std::size_t>(i)]);
      low = std::min(low, angle);
      high = std::isfinite(angle) ? std::max(high, angle) : least;
    }
    if (high - low >= least) continue;
    least = high - low;
    start = kTurn * i / kDwellScan;
  }
  return start;
}

/// How many of the best combinations are each searched as a problem of its own, where more than the
/// start of a dwell is free beside the raster.
constexpr std::size_t kSearchedDwells = 6;

class DwellRaster final : public synthesis::RasterTask {
 public:
  DwellRaster(const DwellSpace& space, const DwellAcceptance& accepts, const Deadline& deadline)
      : space_(space),
        accepts_(accepts),
        deadline_(deadline),
        all_(chain_axes(*space.problem->raster, space, space.scale)) {}

  std::span<const synthesis::RasterAxis> axes() const override { return all_.axes; }

  /// Whether every dimension is on the raster or given, and the start of the dwell alone is sought.
  bool is_given_whole() const {
    return all_.axes.size() == space_.free.size() && space_.problem->dwells.size() == 1;
  }

  std::vector<RasterPoint> relax(const RasterBox& box,
                                 std::span<const RasterPoint> from) const override {
    const DwellSpace restricted = within(box);
    std::vector<RasterPoint> minima;
    for (const RasterPoint& start : from) {
      const RasterPoint found = fitted_within(restricted, design_of(start));
      const auto same = [&](const RasterPoint& known) {
        return known.form == found.form &&
               std::abs(known.objective - found.objective) <= 1e-9 * known.objective;
      };
      if (std::isfinite(found.objective) && std::ranges::none_of(minima, same)) {
        minima.push_back(found);
      }
    }
    return minima;
  }

  /// In every assembly, with starts from the points known and, of a single dwell, from where it is
  /// best among evenly spread ones.
  std::vector<RasterPoint> evaluate(const RasterNumbers& at,
                                    std::span<const RasterPoint> from) const override {
    if (from.empty()) return {};
    const DwellSpace single = within({at, at});
    std::vector<RasterPoint> all;
    for (int assembly = 0; assembly < assemblies(); ++assembly) {
      DwellDesign design = within_bounds(single, in_assembly(design_of(from.front()), assembly));
      if (space_.problem->dwells.size() == 1 && !space_.problem->dwells.front().from) {
        design.start.front() = scanned_start(single, design, space_.problem->dwells.front().over);
      }
      all.push_back(fitted_within(single, design));
    }
    if (!is_given_whole()) {
      for (const RasterPoint& point : from) {
        all.push_back(fitted_within(single, design_of(point)));
      }
    }
    std::erase_if(all, [](const RasterPoint& point) { return !std::isfinite(point.objective); });
    return all;
  }

  bool accepts(const RasterPoint& point) const override { return accepts_(design(point)); }

  /// The minima of one combination that a search begun with none known finds.
  std::vector<RasterPoint> searched(const RasterNumbers& at, const Run& run, Work& work) const {
    const std::vector<DwellSpace> single{within({at, at})};
    std::vector<RasterPoint> points;
    for (const DwellMinimum& found :
         search_dwells(single, space_.problem->solve, run, deadline_, work).designs) {
      // Combinations are compared: all are measured alike.
      points.push_back(fitted_within(single.front(), found.design));
    }
    std::erase_if(points, [](const RasterPoint& point) { return !std::isfinite(point.objective); });
    return points;
  }

  RasterPoint point(const DwellMinimum& found) const {
    return point_of({found.design, found.half_band, found.violation});
  }

  /// In the file's unit, without the rounding of the scale.
  DwellDesign design(const RasterPoint& point) const {
    DwellDesign made = design_of(point);
    made.chain = space_.scale.out_of(space_.chain, made.chain);
    for (std::size_t i = 0; i < all_.places.size(); ++i) {
      const auto& values = all_.axes[i].values;
      made.chain.parameters[all_.places[i].parameter] = values.at(values.nearest(point.values[i]));
    }
    return made;
  }

 private:
  int assemblies() const {
    int count = 1;
    for (const auto& line : space_.lines) count *= is_dyad(line.line.type) ? 2 : 1;
    return count;
  }

  /// The dyads put together by the bits of `assembly`.
  DwellDesign in_assembly(DwellDesign design, int assembly) const {
    for (std::size_t i = 0; i < space_.lines.size(); ++i) {
      if (!is_dyad(space_.lines[i].line.type)) continue;
      design.chain.side[i] = assembly % 2 == 0 ? 1 : -1;
      assembly /= 2;
    }
    return design;
  }

  DwellSpace within(const RasterBox& box) const {
    DwellSpace restricted = space_;
    for (std::size_t i = 0; i < all_.places.size(); ++i) {
      const auto& [parameter, origin, size] = all_.places[i];
      const double low = (all_.axes[i].values.at(box.first[i]) - origin) / size;
      restricted.lower[parameter] = low;
      restricted.upper[parameter] = (all_.axes[i].values.at(box.last[i]) - origin) / size;
      if (box.first[i] == box.last[i]) restricted.given[parameter] = low;
    }
    restricted.free.clear();
    for (std::size_t i = 0; i < restricted.given.size(); ++i) {
      if (!restricted.given[i]) restricted.free.push_back(static_cast<int>(i));
    }
    return restricted;
  }

  static DwellDesign within_bounds(const DwellSpace& restricted, DwellDesign design) {
    auto& values = design.chain.parameters;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = restricted.given[i].value_or(
          std::clamp(values[i], restricted.lower[i], restricted.upper[i]));
    }
    return design;
  }

  RasterPoint fitted_within(const DwellSpace& restricted, DwellDesign design) const {
    // Combinations are compared: they are measured as finished designs are.
    const bool is_single = restricted.free.size() + all_.axes.size() == space_.free.size();
    return point_of(
        fit_dwell(restricted, within_bounds(restricted, std::move(design)), is_single, deadline_));
  }

  /// The parameters, then the starts; the sides as the form, a bit for each line to the left.
  RasterPoint point_of(const DwellFit& fit) const {
    RasterPoint made;
    made.objective = std::max(fit.half_band, 0.0);
    made.violation = fit.violation;
    made.x = fit.design.chain.parameters;
    made.x.insert(made.x.end(), fit.design.start.begin(), fit.design.start.end());
    for (std::size_t i = 0; i < fit.design.chain.side.size(); ++i) {
      if (fit.design.chain.side[i] > 0) made.form |= 1 << i;
    }
    for (const auto& [parameter, origin, size] : all_.places) {
      made.values.push_back(origin + size * made.x[parameter]);
    }
    return made;
  }

  DwellDesign design_of(const RasterPoint& point) const {
    DwellDesign made;
    const auto count = static_cast<std::ptrdiff_t>(space_.given.size());
    made.chain.parameters.assign(point.x.begin(), point.x.begin() + count);
    made.start.assign(point.x.begin() + count, point.x.end());
    for (std::size_t i = 0; i < space_.lines.size(); ++i) {
      const bool has_side = is_dyad(space_.lines[i].line.type);
      made.chain.side.push_back(!has_side ? 0 : (point.form & (1 << i)) != 0 ? 1 : -1);
    }
    return made;
  }

  const DwellSpace& space_;
  const DwellAcceptance& accepts_;
  const Deadline& deadline_;
  ChainAxes all_;
};

/// The best between the values is no worse than what is found from the best on them.
void improve_relaxed(const DwellRaster& raster, synthesis::RasterResult& search) {
  if (search.designs.empty() || !search.relaxed) return;
  RasterBox whole;
  for (const synthesis::RasterAxis& axis : raster.axes()) {
    whole.first.push_back(0);
    whole.last.push_back(axis.values.count() - 1);
  }
  for (const RasterPoint& found : raster.relax(whole, std::span(search.designs).first(1))) {
    const bool is_sound = found.violation <= kDwellFeasibility;
    if (is_sound && found.objective < search.relaxed->objective) search.relaxed = found;
  }
}

}  // namespace

RasterDwells search_dwell_raster(const DwellSpace& space, const std::vector<DwellMinimum>& found,
                                 const DwellAcceptance& accepts, const Run& run,
                                 const Deadline& deadline, Work& work) {
  const DwellRaster raster(space, accepts, deadline);
  std::vector<RasterPoint> from;
  for (const DwellMinimum& one : found) {
    if (std::isfinite(one.half_band)) from.push_back(raster.point(one));
  }
  RasterDwells result;
  if (from.empty()) return result;
  const DwellProblem& problem = *space.problem;
  auto options = raster_options(problem.solve, *problem.raster, run, deadline);
  options.feasibility = kDwellFeasibility;
  options.met = kNoBand;
  options.enumerate = kEvaluatedDwells;
  options.minima = kDwellMinima;
  options.searched = kSearchedDwells;
  SharedWork shared(work);
  const Run alone = of_one_combination(run);
  if (!raster.is_given_whole()) {
    options.search = [&](const RasterNumbers& at) {
      return shared.counted([&](Work& own) { return raster.searched(at, alone, own); });
    };
  }
  result.search = synthesis::search_raster(raster, from, options);
  result.search.is_enumerated = result.search.is_enumerated && raster.is_given_whole();
  improve_relaxed(raster, result.search);
  for (const RasterPoint& point : result.search.designs) {
    result.designs.push_back(raster.design(point));
  }
  return result;
}

}  // namespace cognate::problems
