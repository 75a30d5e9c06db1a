#include "problems/straight_line/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/search/solver_origin.hpp"
#include "problems/straight_line/model.hpp"
#include "problems/straight_line/peaks.hpp"
#include "problems/straight_line/placing.hpp"
#include "problems/straight_line/segment_rules.hpp"
#include "synthesis/optimise/solver.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {
namespace {

using synthesis::Solver;

/// Linkages drawn for each start that is refined.
constexpr int kDrawnPerStart = 150;
/// Cells between nodes and iterations: of the first refinement, and of the best ones.
constexpr int kCoarseCells = 20, kCoarseIterations = 60;
constexpr int kFineCells = 32, kFineIterations = 300;
/// Of the solver that takes over where the other leaves limits unmet.
constexpr int kMendingIterations = 300;
/// Rounds in which peaks between the nodes join them.
constexpr int kExchangeRounds = 10;
/// One of so many starts is drawn; the others are good designs that are disturbed.
constexpr int kStartsPerDraw = 3;
/// Disturbed designs between two looks at what they led to, and how many of the best are disturbed.
constexpr int kHopsInRound = 16, kParents = 6;
/// δ/L up to this is rounding: the line is exact.
constexpr double kExact = 1e-12;
/// Designs as close as this are one: valleys are flat.
constexpr double kSameOptimum = 1e-2;
/// Those on their way to one minimum, mostly. The best of each such heap goes on, lest all that go
/// on end at the same.
constexpr double kSameValley = 0.2;

Solver own_solver(SegmentObjective objective) {
  return objective == SegmentObjective::deviation ? Solver::gauss_newton : Solver::ipopt;
}

/// The problem of which a start is refined first: the least deviation at a length and for a size
/// over the length, for which no start is too far from its limits.
StraightLineProblem at_size(const StraightLineProblem& problem, double length, double size) {
  StraightLineProblem relaxed = problem;
  relaxed.goal->deviation.reset();
  relaxed.goal->deviation_relative.reset();
  if (!relaxed.goal->length) relaxed.goal->length = length;
  relaxed.segment.size_over_length_max = std::min(size, size_limit(problem));
  return relaxed;
}

/// Shares of the whole search, for progress, when its starts have been refined, designs disturbed,
/// and the best of them refined further.
constexpr double kBegun = 0.2, kHopped = 0.5, kDeepened = 0.7;

/// Counts for nothing until it is refined.
SegmentDesign unrefined(const LinkageSegment& segment, const std::string& origin) {
  return {.segment = segment, .violation = kInfinity, .origin = origin};
}

/// The stages of a search.
class Search {
 public:
  Search(const StraightLineProblem& problem, const Run& run, const Deadline& deadline, Work& work)
      : problem_(problem),
        run_(run),
        deadline_(deadline),
        work_(work),
        objective_(objective_of(problem)),
        solver_(last_solver(problem)),
        has_place_(limits_place(problem)),
        search_({.has_place = has_place_}, {run.threads, deadline, run.progress}) {}

  std::vector<SegmentStart> draw(int wanted);
  void begin(const std::vector<LinkageSegment>& known, const std::vector<SegmentStart>& starts);
  void hop(int hops);
  void deepen(std::size_t reserve);
  void finish(std::size_t reserve);
  SegmentSearchResult take() && {
    work_.gradients += solved_.total().gradients;
    work_.solver_iterations += solved_.total().iterations;
    const SearchStatistics statistics = search_.statistics();
    return {std::move(search_.all()), statistics};
  }

 private:
  void refine(SegmentDesign& found, std::vector<double> nodes, Solver solver,
              int iterations) const {
    refine(problem_, found, std::move(nodes), solver, iterations);
  }
  void refine(const StraightLineProblem& problem, SegmentDesign& found, std::vector<double> nodes,
              Solver solver, int iterations) const;
  void refine_start(SegmentDesign& found) const;
  LinkageSegment in_place(LinkageSegment segment) const;
  SegmentDesign disturbed(std::uint64_t number) const;
  void approach(SegmentDesign& found, const std::vector<double>& nodes) const;
  void refine_within(SegmentDesign& found, const std::vector<double>& nodes, Solver solver) const;
  void exchange(SegmentDesign& found) const;
  void assess(SegmentDesign& found, const SegmentModel& model, SegmentObjective objective) const;
  void merge_and_keep(std::size_t reserve) {
    search_.merge(kSameOptimum);
    search_.keep(reserve + static_cast<std::size_t>(problem_.solve.designs));
  }

  const StraightLineProblem& problem_;
  const Run& run_;
  const Deadline& deadline_;
  Work& work_;
  SegmentObjective objective_;
  Solver solver_;
  bool has_place_;
  synthesis::MultiStart<SegmentRules> search_;
  synthesis::WorkCounter solved_;
};

/// In the best of its places on the line, by its own best line.
LinkageSegment Search::in_place(LinkageSegment segment) const {
  if (!has_place_ || !fit_line(segment)) return segment;
  return placed(problem_, segment);
}

/// The most promising of many, shared out over the families: each in turn gives its next best.
std::vector<SegmentStart> Search::draw(int wanted) {
  const int count = wanted * kDrawnPerStart;
  constexpr int kBlock = 64;
  const int blocks = (count + kBlock - 1) / kBlock;
  std::vector<std::vector<SegmentStart>> drawn(static_cast<std::size_t>(blocks));
  parallel_for(blocks, run_.threads, [&](int block, int) {
    SegmentStarts starts(problem_);
    for (int i = block * kBlock; i < (block + 1) * kBlock && !deadline_.reached(); ++i) {
      auto start = starts.draw(run_.seed, static_cast<std::uint64_t>(i));
      if (start) drawn[static_cast<std::size_t>(block)].push_back(*start);
    }
  });
  work_.candidates += static_cast<std::uint64_t>(count);
  std::array<std::vector<SegmentStart>, static_cast<std::size_t>(SegmentFamily::count)> families;
  for (const auto& block : drawn) {
    for (const SegmentStart& start : block) {
      families.at(static_cast<std::size_t>(start.family)).push_back(start);
    }
  }
  for (auto& family : families) std::ranges::stable_sort(family, {}, &SegmentStart::score);
  std::vector<SegmentStart> best;
  for (std::size_t rank = 0; best.size() < static_cast<std::size_t>(wanted); ++rank) {
    const std::size_t before = best.size();
    for (const auto& family : families) {
      if (rank < family.size() && best.size() < static_cast<std::size_t>(wanted)) {
        best.push_back(family[rank]);
      }
    }
    if (best.size() == before) break;
  }
  return best;
}

/// Measures the segment by its own best line and checks the limits there.
void Search::assess(SegmentDesign& found, const SegmentModel& model,
                    SegmentObjective objective) const {
  LinkageSegment& segment = found.segment;
  found.violation = std::numeric_limits<double>::infinity();
  const double size = largest_dimension(segment);
  const CouplerMotion<double> motion(segment.type, segment.dimensions, sign(segment.assembly));
  if (!motion.at(segment.from()).closes || !motion.at(segment.to()).closes) return;
  const std::vector<double> x = model.variables_of(segment);
  std::vector<double> residuals(static_cast<std::size_t>(model.residual_count()));
  std::vector<double> limits(static_cast<std::size_t>(model.constraint_count()));
  if (!model.residuals(x, residuals, {}, {})) return;
  model.constraints(x, limits, {});
  found.violation = 0;
  const auto equalities = static_cast<std::size_t>(model.equality_count());
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double miss = i < equalities ? std::abs(limits[i]) : -limits[i];
    found.violation = std::max(found.violation, miss);
  }
  switch (objective) {
    case SegmentObjective::deviation:
      found.objective = 0;
      for (const double r : residuals) found.objective = std::max(found.objective, std::abs(r));
      break;
    case SegmentObjective::length:
      found.objective = 1 / segment.length;
      break;
    case SegmentObjective::size:
      found.objective = size / segment.length;
      break;
  }
}

void Search::refine(const StraightLineProblem& problem, SegmentDesign& found,
                    std::vector<double> nodes, Solver solver, int iterations) const {
  const SegmentObjective objective = objective_of(problem);
  const bool exact = objective == SegmentObjective::deviation && found.objective <= kExact;
  if (exact && is_feasible(found) && found.objective > 0) return;
  const SegmentModel model(problem, found.segment, std::move(nodes));
  const auto options =
      synthesis::until(deadline_, {.tolerance = problem_.solve.tolerance.value_or(1e-9),
                                   .feasibility = 0.1 * kSegmentFeasibility,
                                   .max_iterations = iterations,
                                   .seed = run_.seed,
                                   .learns_curvature = true});
  const auto solution = synthesis::solve(solver, model, model.variables_of(found.segment), options);
  solved_.count(solution);
  if (solution.stop == synthesis::Stop::no_value) {
    found.violation = std::numeric_limits<double>::infinity();
    return;
  }
  found.segment = model.segment(solution.x);
  assess(found, model, objective);
}

/// The promise of a start: its objective, or where the deviation is limited that of a size at which
/// the limit is just met. Along fronts the deviation goes with the fourth power of the size.
void Search::refine_start(SegmentDesign& found) const {
  const std::vector<double> nodes = segment_nodes(kCoarseCells);
  if (objective_ == SegmentObjective::deviation) {
    refine(found, nodes, Solver::gauss_newton, kCoarseIterations);
    found.promise = found.objective * (1 + 4 * found.violation);
    return;
  }
  const double length = found.segment.length;
  refine(at_size(problem_, length, size_over_length(found.segment)), found, nodes,
         Solver::gauss_newton, kCoarseIterations);
  const StraightLineGoal& goal = *problem_.goal;
  const double most = goal.deviation ? *goal.deviation / length : *goal.deviation_relative;
  const double missed = std::pow(found.objective / most, 0.25);
  const bool sized = objective_ == SegmentObjective::size;
  const double own = sized ? size_over_length(found.segment) : 1 / length;
  found.promise = own * missed * (1 + found.violation);
}

void Search::begin(const std::vector<LinkageSegment>& known,
                   const std::vector<SegmentStart>& starts) {
  std::vector<SegmentDesign> fresh;
  for (const LinkageSegment& segment : known) {
    fresh.push_back(unrefined(in_place(segment), "neighbour"));
  }
  for (const SegmentStart& start : starts) {
    fresh.push_back(unrefined(start.segment, std::string(name(start.family))));
  }
  const int count = static_cast<int>(fresh.size());
  search_.explore({.starts = count, .round = count}, {0, kBegun}, [&](int, int) {
    search_.for_each(fresh.size(), [&](std::size_t i) { refine_start(fresh[i]); });
    search_.add(std::move(fresh), kSameValley);
  });
}

/// A good design, more often one of the best, of which all dimensions are changed a little or much.
SegmentDesign Search::disturbed(std::uint64_t number) const {
  constexpr double kLeastHop = 0.005, kMostHop = 0.7, kLeastUnit = 0.1;
  std::seed_seq seed{run_.seed, number};
  std::mt19937_64 random(seed);
  const auto& all = search_.all();
  const auto parents = std::min(kParents, static_cast<int>(all.size()));
  const double rank = parents * std::pow(uniform(random, 0, 1), 2);
  const SegmentDesign& parent = all[static_cast<std::size_t>(rank)];
  const SegmentModel model(problem_, parent.segment, segment_nodes(1));
  std::vector<double> x = model.variables_of(parent.segment);
  const double size = std::exp(uniform(random, std::log(kLeastHop), std::log(kMostHop)));
  for (double& value : x) {
    value += size * uniform(random, -1, 1) * std::max(kLeastUnit, std::abs(value));
  }
  return unrefined(in_place(model.segment(x)), parent.origin);
}

/// Further starts: designs found before, disturbed. Local minima lie close together, so that good
/// ones lead to better ones more often than what is drawn anew.
void Search::hop(int hops) {
  const int known = search_.starts();
  search_.explore({.starts = known + hops, .round = kHopsInRound}, {kBegun, kHopped},
                  [&](int first, int count) {
                    if (search_.all().empty()) return;
                    std::vector<SegmentDesign> fresh(static_cast<std::size_t>(count),
                                                     unrefined({}, {}));
                    search_.for_each(fresh.size(), [&](std::size_t i) {
                      fresh[i] = disturbed(static_cast<std::uint64_t>(first) + i);
                      refine_start(fresh[i]);
                    });
                    search_.add(std::move(fresh), kSameValley);
                  });
}

/// To the least deviation at the size or length at which the limit is expected to be met.
void Search::approach(SegmentDesign& found, const std::vector<double>& nodes) const {
  const bool sized = objective_ == SegmentObjective::size;
  const double length = sized ? found.segment.length : 1 / found.promise;
  const double size = sized ? found.promise : size_limit(problem_);
  if (!sized && !problem_.goal->length) found.segment.length = length;
  refine(at_size(problem_, length, size), found, nodes, Solver::gauss_newton, kFineIterations);
}

void Search::deepen(std::size_t reserve) {
  merge_and_keep(reserve);
  const std::vector<double> nodes = segment_nodes(kFineCells);
  search_.refine({kHopped, kDeepened}, [&](SegmentDesign& found) {
    SegmentDesign next = found;
    if (objective_ != SegmentObjective::deviation) approach(next, nodes);
    refine_within(next, nodes, own_solver(objective_));
    const bool other = objective_ != SegmentObjective::deviation;  // than that of the start
    if (other || is_better(next, found) || !is_feasible(found)) found = next;
  });
}

/// Where the usual solver ends outside the limits another goes on from the same start, and what is
/// better is kept.
void Search::refine_within(SegmentDesign& found, const std::vector<double>& nodes,
                           Solver solver) const {
  const SegmentDesign start = found;
  refine(found, nodes, solver, kFineIterations);
  if (is_feasible(found) || solver != own_solver(objective_)) return;
  SegmentDesign other = start;
  refine(other, nodes, Solver::slsqp, kMendingIterations);
  if (is_better(other, found)) found = other;
}

/// Remez's exchange: the peaks between the nodes join them until no peak is higher.
void Search::exchange(SegmentDesign& found) const {
  std::vector<double> nodes = segment_nodes(kFineCells);
  SegmentDesign next = found;
  for (int round = 0; round < kExchangeRounds && !deadline_.reached(); ++round) {
    refine_within(next, nodes, solver_);
    if (!std::isfinite(next.violation)) break;
    found = next;
    const std::vector<double> peaks =
        peaks_beyond(found.segment, nodes, problem_.segment.speed_variation_max);
    if (peaks.empty()) break;
    nodes.insert(nodes.end() - 1, peaks.begin(), peaks.end());
    std::ranges::sort(nodes);
  }
  LinkageSegment fitted = found.segment;
  const auto deviation = fit_line(fitted);
  if (deviation && objective_ == SegmentObjective::deviation) {
    found.objective = *deviation / fitted.length;
  }
}

void Search::finish(std::size_t reserve) {
  search_.rules().by_promise = false;
  merge_and_keep(reserve);
  search_.refine({kDeepened, 1}, [&](SegmentDesign& found) { exchange(found); });
  merge_and_keep(reserve);
}

}  // namespace

Solver last_solver(const StraightLineProblem& problem) {
  return chosen(problem.solve.solver, own_solver(objective_of(problem)));
}

SegmentSearchResult search_segments(const StraightLineProblem& problem,
                                    const std::vector<LinkageSegment>& known,
                                    const SegmentEffort& effort, const Run& run,
                                    const Deadline& deadline, Work& work) {
  Search search(problem, run, deadline, work);
  const int all = effort.starts > 0 ? problem.solve.starts.value_or(effort.starts) : 0;
  const int drawn = (all + kStartsPerDraw - 1) / kStartsPerDraw;
  const std::vector<SegmentStart> starts = search.draw(drawn);
  search.begin(known, starts);
  search.hop(starts.empty() ? 0 : all - drawn);
  // Few starts are worth few of the dearer refinements, more than usual are worth more.
  const std::size_t few = 1 + (starts.size() + known.size()) / 8, many = starts.size() / 20;
  search.deepen(std::max(std::min(effort.deepened, few), many));
  search.finish(effort.finished);
  return std::move(search).take();
}

}  // namespace cognate::problems
