/// Mechanisms with dwells from problem to designs: search, conversion to the file's units,
/// verification.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/chain/found_designs.hpp"
#include "problems/chain/front/front.hpp"
#include "problems/chain/output/question.hpp"
#include "problems/dwell/given.hpp"
#include "problems/dwell/raster.hpp"
#include "problems/dwell/search.hpp"
#include "problems/dwell/verify.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/raster/report.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/search/solver_origin.hpp"
#include "problems/search/statistics.hpp"

namespace cognate::problems {
namespace {

/// Those that meet every limit, the best first; the others only where there are no such.
std::vector<Design> designs_of_dwells(const DwellProblem& problem,
                                      const std::vector<DwellMinimum>& found) {
  using synthesis::Solver;
  std::vector<Design> designs;
  for (const DwellMinimum& one : found) {
    if (!std::isfinite(one.half_band)) continue;
    const DwellSpace& space = *one.space;
    auto mechanism = named(*space.topology, space.scale.out_of(space.chain, one.design.chain));
    Design design = verified(problem, *space.topology, std::move(mechanism), one.design.start);
    if (!std::isfinite(design.error.sum_of_squares)) continue;
    design.origin = search_origin({Solver::slsqp, Solver::gauss_newton});
    designs.push_back(std::move(design));
  }
  std::ranges::stable_sort(designs, {}, [](const Design& design) { return design.error.max; });
  return feasible_or_all(std::move(designs), problem.solve.designs);
}

/// Of the raster, from the minima without it.
void solve_dwells_on_raster(const DwellProblem& problem, const DwellSpace& space,
                            const DwellSearchResult& found, const Run& run,
                            const Deadline& deadline, Result& result) {
  const Topology& topology = *space.topology;
  const auto design_of = [&](const DwellDesign& one) {
    return verified(problem, topology, named(topology, one.chain), one.start);
  };
  const auto accepts = [&](const DwellDesign& one) {
    const Design design = design_of(one);
    return std::isfinite(design.error.sum_of_squares) && all_satisfied(design.constraints);
  };
  const RasterDwells best =
      search_dwell_raster(space, found.designs, accepts, on_values(run), deadline, result.work);
  for (const DwellDesign& one : best.designs) {
    result.designs.push_back(design_of(one));
    result.designs.back().origin = "raster";
  }
  const RasterMeasure measure{[](double half_band) { return degrees(half_band); }};
  std::ranges::move(raster_quantities(best.search, measure), std::back_inserter(result.quantities));
  result.notes = raster_notes(best.search, measure);
}

/// The mechanism that the file gives.
Result take_given(const DwellProblem& problem, const Deadline& deadline) {
  Result result;
  if (auto design = given_design(problem)) result.designs.push_back(*std::move(design));
  result.status = status_of(result.designs, deadline);
  return result;
}

/// The designs that the search finds, or those on the raster next to them.
Result find_dwells(const DwellProblem& problem, const std::vector<DwellSpace>& spaces,
                   const Run& run, const Deadline& deadline) {
  if (is_given(problem)) return take_given(problem, deadline);
  Result result;
  const DwellSearchResult found = search_dwells(
      spaces, problem.solve, problem.raster ? between_values(run) : run, deadline, result.work);
  result.quantities = quantities(found.statistics);
  if (problem.raster) {
    solve_dwells_on_raster(problem, spaces.front(), found, run, deadline, result);
  } else {
    result.designs = designs_of_dwells(problem, found.designs);
  }
  result.status = status_of(result.designs, deadline);
  return result;
}

std::vector<DwellSpace> spaces_of(const DwellProblem& problem) {
  std::vector<DwellSpace> spaces;
  for (const Topology& topology : problem.topologies) spaces.emplace_back(problem, topology);
  return spaces;
}

/// The error is the half band; nobody wants one that is half of the swing.
ChainFrontProblem front_of_dwell(const DwellProblem& problem) {
  const bool slides = problems::slides(problem);
  const double most = problem.swing_min > 0 ? 0.5 * problem.swing_min : 0.5 * kPi;
  const auto half_band = [](const Design& design) { return design.error.max; };
  const auto shown = [slides](const Design& design) {
    return slides ? design.error.max : degrees(design.error.max);
  };
  const auto solve = [&problem](const ChainDemand& demand, const Run& run, const Deadline& end) {
    const DwellProblem one = with_demand(problem, demand);
    return find_dwells(one, spaces_of(one), run, end);
  };
  return {*problem.against,
          demand_of(problem),
          kMetError * most,
          most,
          slides ? "half_band" : "half_band_deg",
          half_band,
          shown,
          solve};
}

/// The output in each dwell from the middle of its band there.
std::optional<ToleranceQuestion> dwell_question(const DwellProblem& problem, const Design& design) {
  constexpr int kSteps = 45;
  std::vector<double> angles;
  for (std::size_t k = 0; k + 1 < design.crank_angles.size(); k += 2) {
    for (int i = 0; i <= kSteps; ++i) {
      angles.push_back(design.crank_angles[k] + problem.dwells[k / 2].over * i / kSteps);
    }
  }
  auto asked = slides(problem) ? displacement_question(design.mechanism, problem.output[1], angles)
                               : output_question(design.mechanism, problem.output, angles);
  if (!asked) return std::nullopt;
  const auto& way = asked->way;
  auto& output = asked->question.quantities.front();
  for (std::size_t begin = 0; begin < way.size(); begin += kSteps + 1) {
    double least = 0, greatest = 0;
    for (std::size_t i = 0; i <= kSteps; ++i) {
      const double here = deviation(output.response.type, way[begin + i], way[begin]).x;
      least = std::min(least, here);
      greatest = std::max(greatest, here);
      output.offset.push_back(here);
    }
    for (std::size_t i = 0; i <= kSteps; ++i) {
      output.offset[begin + i] -= 0.5 * (least + greatest);
    }
  }
  add_transmissions(design.mechanism, asked->question);
  return std::move(asked->question);
}

void add_dwell_tolerances(const DwellProblem& problem, const Run& run, Result& result) {
  add_tolerances(
      problem.tolerances, problem.length_unit, run,
      [&](const Design& design) { return dwell_question(problem, design); }, result);
}

}  // namespace

Result solve(const DwellProblem& given, const Run& run) {
  const auto valid = KindTraits<DwellProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const DwellProblem& problem = *valid;
  const Deadline deadline(run);
  const std::vector<DwellSpace> spaces = spaces_of(problem);
  const auto source = is_given(problem) ? DesignSource::exact : DesignSource::search;
  Result result =
      solve_in_layers(problem, run, source, [&](const DwellProblem& one, const Run& own) {
        return one.against ? chain_front(front_of_dwell(one), own, deadline)
                           : find_dwells(one, spaces, own, deadline);
      });
  add_warnings(std::nullopt, problem.warnings, result);
  if (result.designs.empty() && !problem.raster) {
    result.notes.emplace_back(
        is_given(problem)
            ? "The mechanism given is not assembled over the whole turn; change its dimensions."
            : "No mechanism was found that is assembled over the whole turn within the limits; "
              "wider limits or more starts may help.");
  }
  add_dwell_tolerances(problem, run, result);
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
