#include "problems/straight_line/search.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "analysis/numbers/parallel.hpp"
#include "analysis/numbers/zeros.hpp"
#include "problems/search/backend_choice.hpp"
#include "problems/straight_line/model.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {
namespace {

using synthesis::Backend;

/// Linkages drawn for each start that is refined.
constexpr int kDrawnPerStart = 60;
/// Cells between nodes and iterations: of the first refinement, and of the best ones.
constexpr int kCoarseCells = 20, kCoarseIterations = 60;
constexpr int kFineCells = 32, kFineIterations = 80;
/// Rounds in which peaks between the nodes join them.
constexpr int kExchangeRounds = 4;
/// δ/L up to this is rounding: the line is exact.
constexpr double kExact = 1e-12;
constexpr double kSameOptimum = 1e-4;

bool is_feasible(const FoundStretch& found) {
  return found.violation <= kStretchFeasibility;
}

bool is_better(const FoundStretch& a, const FoundStretch& b) {
  if (is_feasible(a) != is_feasible(b)) return is_feasible(a);
  return is_feasible(a) ? a.objective < b.objective : a.violation < b.violation;
}

/// The problem of which a start is refined first: the least deviation at a length and for a size
/// over the length, for which no start is too far from its limits.
StraightLineProblem at_size(const StraightLineProblem& problem, double length, double size) {
  StraightLineProblem relaxed = problem;
  relaxed.goal->deviation.reset();
  relaxed.goal->deviation_relative.reset();
  if (!relaxed.goal->length) relaxed.goal->length = length;
  relaxed.stretch.size_over_length_max = std::min(size, size_limit(problem));
  return relaxed;
}

double size_over_length(const LineStretch& stretch) {
  return largest_dimension(stretch) / stretch.length;
}

double difference(double a, double b) {
  return std::abs(std::remainder(a - b, kTurn));
}

/// Adds the places between nodes where `value` is greater by `more` than at any node.
template <class Value>
void add_peaks(const Value& value, const std::vector<double>& nodes, double more,
               std::vector<double>& peaks) {
  double most = value(nodes.front());
  for (const double node : nodes) most = std::max(most, value(node));
  constexpr int kCells = 400;
  const std::vector<double> places = crowded(-1, 1, kCells);
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const double here = value(places[i]);
    if (here < value(places[i - 1]) || here <= value(places[i + 1])) continue;
    const auto depth = [&](double place) { return -value(place); };
    constexpr int kSteps = 40;
    const double peak = golden_section(depth, places[i - 1], places[i + 1], kSteps).middle();
    if (value(peak) > most + more + 1e-9 * std::abs(most)) peaks.push_back(peak);
  }
}

/// The places between nodes where the curve is farther from the line than at any of them, or,
/// where the change of speed is limited, faster or slower by more than a little of that.
std::vector<double> peaks_beyond(const LineStretch& stretch, const std::vector<double>& nodes,
                                 const std::optional<double>& variation) {
  const CouplerMotion<double> motion(stretch.type, stretch.dimensions, sign(stretch.assembly));
  const Vec2d along{std::cos(stretch.line), std::sin(stretch.line)};
  const auto at = [&](double node) { return motion.at(stretch.centre + node * stretch.reach); };
  const auto height = [&](double node) {
    const auto point = at(node);
    return point.closes ? std::abs(cross(along, point.at) - stretch.height) : 0.0;
  };
  std::vector<double> peaks;
  add_peaks(height, nodes, 0, peaks);
  if (!variation) return peaks;
  constexpr double kLittle = 3e-4;
  const double unit = 2 * stretch.reach / stretch.length;
  for (const double sense : {1.0, -1.0}) {
    const auto speed = [&](double node) {
      const auto point = at(node);
      return point.closes ? sense * unit * dot(along, point.rate) : sense;
    };
    add_peaks(speed, nodes, kLittle * *variation, peaks);
  }
  return peaks;
}

/// The stages of a search.
/// Shares of the whole search, for progress, when its starts have been refined and the best of
/// them.
constexpr double kBegun = 0.3, kDeepened = 0.6;

class Search {
 public:
  Search(const StraightLineProblem& problem, const Run& run, const Deadline& deadline, Work& work)
      : problem_(problem),
        run_(run),
        deadline_(deadline),
        work_(work),
        objective_(objective_of(problem)),
        automatic_(problem.solve.solver == SolverChoice::automatic) {
    backend_ = automatic_ ? Backend::ipopt : backend_of(problem.solve.solver);
  }

  std::vector<StretchStart> draw(int wanted);
  void begin(const std::vector<LineStretch>& known, const std::vector<StretchStart>& starts);
  void deepen(std::size_t reserve);
  void finish(std::size_t reserve);
  StretchSearchResult take() && {
    work_.gradients += gradients_;
    work_.solver_iterations += iterations_;
    return {std::move(all_), thoroughness_};
  }

 private:
  void refine(FoundStretch& found, std::vector<double> nodes, Backend backend,
              int iterations) const {
    refine(problem_, found, std::move(nodes), backend, iterations);
  }
  void refine(const StraightLineProblem& problem, FoundStretch& found, std::vector<double> nodes,
              Backend backend, int iterations) const;
  void refine_start(FoundStretch& found) const;
  void approach(FoundStretch& found, const std::vector<double>& nodes) const;
  void exchange(FoundStretch& found) const;
  void assess(FoundStretch& found, const StretchModel& model, StretchObjective objective) const;
  void keep_best(std::size_t count);
  void keep_most_promising(std::size_t count);
  void merge(std::size_t count);
  std::size_t kept(std::size_t reserve) const {
    return reserve + static_cast<std::size_t>(problem_.solve.designs);
  }
  void report(double share) const;

  const StraightLineProblem& problem_;
  const Run& run_;
  const Deadline& deadline_;
  Work& work_;
  StretchObjective objective_;
  bool automatic_;
  Backend backend_ = Backend::slsqp;
  SearchThoroughness thoroughness_;
  std::vector<FoundStretch> all_;
  mutable std::atomic<std::uint64_t> gradients_{0}, iterations_{0};  ///< of all threads
};

void Search::report(double share) const {
  if (!run_.progress) return;
  const bool any = !all_.empty() && is_feasible(all_.front());
  run_.progress(share, any ? all_.front().objective : std::numeric_limits<double>::infinity());
}

/// The most promising of many, shared out over the families: each in turn gives its next best.
std::vector<StretchStart> Search::draw(int wanted) {
  const int count = wanted * kDrawnPerStart;
  constexpr int kBlock = 64;
  const int blocks = (count + kBlock - 1) / kBlock;
  std::vector<std::vector<StretchStart>> drawn(static_cast<std::size_t>(blocks));
  parallel_for(blocks, run_.threads, [&](int block, int) {
    StretchStarts starts(problem_);
    for (int i = block * kBlock; i < (block + 1) * kBlock && !deadline_.reached(); ++i) {
      auto start = starts.draw(run_.seed, static_cast<std::uint64_t>(i));
      if (start) drawn[static_cast<std::size_t>(block)].push_back(*start);
    }
  });
  work_.candidates += static_cast<std::uint64_t>(count);
  std::array<std::vector<StretchStart>, static_cast<std::size_t>(StretchFamily::count)> families;
  for (const auto& block : drawn) {
    for (const StretchStart& start : block) {
      families.at(static_cast<std::size_t>(start.family)).push_back(start);
    }
  }
  for (auto& family : families) std::ranges::stable_sort(family, {}, &StretchStart::score);
  std::vector<StretchStart> best;
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

/// Measures the stretch by its own best line and checks the limits there.
void Search::assess(FoundStretch& found, const StretchModel& model,
                    StretchObjective objective) const {
  LineStretch& stretch = found.stretch;
  found.violation = std::numeric_limits<double>::infinity();
  const double size = largest_dimension(stretch);
  const CouplerMotion<double> motion(stretch.type, stretch.dimensions, sign(stretch.assembly));
  if (!motion.at(stretch.from()).closes || !motion.at(stretch.to()).closes) return;
  const std::vector<double> x = model.variables_of(stretch);
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
    case StretchObjective::deviation:
      found.objective = 0;
      for (const double r : residuals) found.objective = std::max(found.objective, std::abs(r));
      break;
    case StretchObjective::length:
      found.objective = 1 / stretch.length;
      break;
    case StretchObjective::size:
      found.objective = size / stretch.length;
      break;
  }
}

void Search::refine(const StraightLineProblem& problem, FoundStretch& found,
                    std::vector<double> nodes, Backend backend, int iterations) const {
  const StretchObjective objective = objective_of(problem);
  const bool exact = objective == StretchObjective::deviation && found.objective <= kExact;
  if (exact && is_feasible(found) && found.objective > 0) return;
  const StretchModel model(problem, found.stretch, std::move(nodes));
  const synthesis::Options options{.tolerance = problem_.solve.tolerance.value_or(1e-9),
                                   .feasibility = 0.1 * kStretchFeasibility,
                                   .max_iterations = iterations,
                                   .time_limit = deadline_.remaining(),
                                   .interrupted = deadline_.flag(),
                                   .seed = run_.seed};
  const auto solution =
      synthesis::solve(backend, model, model.variables_of(found.stretch), options);
  gradients_ += solution.gradients;
  iterations_ += static_cast<std::uint64_t>(solution.iterations);
  if (solution.stop == synthesis::Stop::no_value) {
    found.violation = std::numeric_limits<double>::infinity();
    return;
  }
  found.stretch = model.stretch(solution.x);
  assess(found, model, objective);
}

/// The promise of a start: its objective, or where the deviation is limited that of a size at which
/// the limit is just met. Along fronts the deviation goes with the fourth power of the size.
void Search::refine_start(FoundStretch& found) const {
  const std::vector<double> nodes = stretch_nodes(kCoarseCells);
  if (objective_ == StretchObjective::deviation) {
    refine(found, nodes, Backend::slsqp, kCoarseIterations);
    found.promise = found.objective * (1 + 4 * found.violation);
    return;
  }
  const double length = found.stretch.length;
  refine(at_size(problem_, length, size_over_length(found.stretch)), found, nodes, Backend::slsqp,
         kCoarseIterations);
  const StraightLineGoal& goal = *problem_.goal;
  const double most = goal.deviation ? *goal.deviation / length : *goal.deviation_relative;
  const double missed = std::pow(found.objective / most, 0.25);
  const bool sized = objective_ == StretchObjective::size;
  const double own = sized ? size_over_length(found.stretch) : 1 / length;
  found.promise = own * missed * (1 + found.violation);
}

void Search::keep_best(std::size_t count) {
  std::ranges::stable_sort(all_, is_better);
  merge(count);
}

void Search::keep_most_promising(std::size_t count) {
  std::ranges::stable_sort(all_, {}, &FoundStretch::promise);
  merge(count);
}

/// Leaves the first `count` different ones.
void Search::merge(std::size_t count) {
  std::erase_if(all_, [](const FoundStretch& f) { return !std::isfinite(f.violation); });
  std::vector<FoundStretch> different;
  int hits = 0;
  for (const FoundStretch& found : all_) {
    const auto same = [&](const FoundStretch& known) {
      return same_stretch(found.stretch, known.stretch, kSameOptimum);
    };
    const auto known = std::ranges::find_if(different, same);
    if (known == different.begin() && !different.empty()) ++hits;
    if (known == different.end() && different.size() < count) different.push_back(found);
  }
  thoroughness_.best_hits = std::max(thoroughness_.best_hits, 1 + hits);
  all_ = std::move(different);
}

void Search::begin(const std::vector<LineStretch>& known, const std::vector<StretchStart>& starts) {
  for (const LineStretch& stretch : known) all_.push_back({stretch, 0, 0, 0, "neighbour"});
  for (const StretchStart& start : starts) {
    all_.push_back({start.stretch, 0, 0, 0, std::string(name(start.family))});
  }
  thoroughness_.starts = static_cast<int>(all_.size());
  parallel_for(static_cast<int>(all_.size()), run_.threads, [&](int i, int thread) {
    FoundStretch& found = all_[static_cast<std::size_t>(i)];
    if (deadline_.reached()) {
      found.violation = std::numeric_limits<double>::infinity();
      return;
    }
    refine_start(found);
    if (thread == 0 && run_.progress) {
      run_.progress(kBegun * i / double(all_.size()), std::numeric_limits<double>::infinity());
    }
  });
}

/// To the least deviation at the size or length at which the limit is expected to be met.
void Search::approach(FoundStretch& found, const std::vector<double>& nodes) const {
  const bool sized = objective_ == StretchObjective::size;
  const double length = sized ? found.stretch.length : 1 / found.promise;
  const double size = sized ? found.promise : size_limit(problem_);
  if (!sized && !problem_.goal->length) found.stretch.length = length;
  refine(at_size(problem_, length, size), found, nodes, Backend::ipopt, kFineIterations);
}

void Search::deepen(std::size_t reserve) {
  keep_most_promising(kept(reserve));
  report(kBegun);
  const std::vector<double> nodes = stretch_nodes(kFineCells);
  parallel_for(static_cast<int>(all_.size()), run_.threads, [&](int i, int thread) {
    if (deadline_.reached()) return;
    FoundStretch& found = all_[static_cast<std::size_t>(i)];
    FoundStretch next = found;
    if (thread == 0 && run_.progress) {
      run_.progress(kBegun + (kDeepened - kBegun) * i / double(all_.size()),
                    std::numeric_limits<double>::infinity());
    }
    if (objective_ != StretchObjective::deviation) approach(next, nodes);
    refine(next, nodes, Backend::ipopt, kFineIterations);
    const bool other = objective_ != StretchObjective::deviation;  // than that of the start
    if (other || is_better(next, found) || !is_feasible(found)) found = next;
  });
}

/// Remez's exchange: the peaks between the nodes join them until no peak is higher.
void Search::exchange(FoundStretch& found) const {
  std::vector<double> nodes = stretch_nodes(kFineCells);
  FoundStretch next = found;
  for (int round = 0; round < kExchangeRounds && !deadline_.reached(); ++round) {
    refine(next, nodes, backend_, kFineIterations);
    if (!std::isfinite(next.violation)) break;
    found = next;
    const std::vector<double> peaks =
        peaks_beyond(found.stretch, nodes, problem_.stretch.speed_variation_max);
    if (peaks.empty()) break;
    nodes.insert(nodes.end() - 1, peaks.begin(), peaks.end());
    std::ranges::sort(nodes);
  }
  LineStretch fitted = found.stretch;
  const auto deviation = fit_line(fitted);
  if (deviation && objective_ == StretchObjective::deviation) {
    found.objective = *deviation / fitted.length;
  }
}

void Search::finish(std::size_t reserve) {
  keep_best(kept(reserve));
  report(kDeepened);
  const double best = !all_.empty() && is_feasible(all_.front())
                          ? all_.front().objective
                          : std::numeric_limits<double>::infinity();
  parallel_for(static_cast<int>(all_.size()), run_.threads, [&](int i, int thread) {
    if (thread == 0 && run_.progress) {
      run_.progress(kDeepened + (1 - kDeepened) * i / double(all_.size()), best);
    }
    exchange(all_[static_cast<std::size_t>(i)]);
  });
  keep_best(kept(reserve));
  report(1);
}

}  // namespace

bool same_stretch(const LineStretch& a, const LineStretch& b, double tolerance) {
  if (a.type != b.type) return false;
  const double size = tolerance * std::max(largest_dimension(a), largest_dimension(b));
  for (std::size_t i = 0; i < 4; ++i) {
    const double own = a.dimensions.links[i], other = b.dimensions.links[i];
    const bool offset = a.type == MechanismType::slider_crank && i == 2;
    const bool mirrored = offset && a.assembly == b.assembly;
    if (std::abs(own - other) > size && !(mirrored && std::abs(own + other) <= size)) return false;
  }
  const Vec2d own = a.dimensions.point, other = b.dimensions.point;
  const bool mirror = a.type == MechanismType::four_bar
                          ? a.assembly != b.assembly
                          : difference(a.centre, -b.centre) < difference(a.centre, b.centre);
  if (norm(own - (mirror ? conj(other) : other)) > size) return false;
  const double centre = mirror ? -b.centre : b.centre;
  return difference(a.centre, centre) <= 30 * tolerance &&
         std::abs(a.reach - b.reach) <= 30 * tolerance;
}

StretchSearchResult search_stretches(const StraightLineProblem& problem,
                                     const std::vector<LineStretch>& known,
                                     const StretchEffort& effort, const Run& run,
                                     const Deadline& deadline, Work& work) {
  Search search(problem, run, deadline, work);
  std::vector<StretchStart> starts;
  if (effort.starts > 0) starts = search.draw(problem.solve.starts.value_or(effort.starts));
  search.begin(known, starts);
  // Few starts are worth few of the dearer refinements.
  const std::size_t share = 1 + (starts.size() + known.size()) / 8;
  search.deepen(std::min(effort.deepened, share));
  search.finish(effort.finished);
  return std::move(search).take();
}

}  // namespace cognate::problems
