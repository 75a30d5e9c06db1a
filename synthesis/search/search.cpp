#include "synthesis/search/search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"

namespace cognate::synthesis {
namespace {

/// Half the side, in scales, of the box of starts where there is no bound.
constexpr double kBoxReach = 10;
constexpr double kExploringTolerance = 1e-10;
/// Shares of the whole search, for progress, when its starts have been explored.
constexpr double kExplored = 0.7;

/// The side of the box of starts.
Shares side_of(const Variable& variable) {
  const double reach = kBoxReach * variable.scale;
  const bool low = std::isfinite(variable.lower), high = std::isfinite(variable.upper);
  if (low && high) return {variable.lower, variable.upper};
  if (low) return {variable.lower, variable.lower + reach};
  if (high) return {variable.upper - reach, variable.upper};
  return {-reach, reach};
}

/// Greatest violation of constraints and bounds.
double violation_of(const Model& model, std::span<const double> x) {
  std::vector<double> c(static_cast<std::size_t>(model.constraint_count()));
  model.constraints(x, c, {});
  double most = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const bool equality = i < static_cast<std::size_t>(model.equality_count());
    most = std::max(most, equality ? std::abs(c[i]) : -c[i]);
  }
  return most;
}

/// The model's objective; empty where it has no value.
std::optional<double> objective_of(const Model& model, std::span<const double> x) {
  std::vector<double> r(static_cast<std::size_t>(model.residual_count()));
  if (!model.residuals(x, r, {}, {})) return std::nullopt;
  if (model.objective() == Objective::sum_of_squares) {
    return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
  }
  double most = 0;
  for (const double value : r) most = std::max(most, std::abs(value));
  return most;
}

bool is_close(std::span<const Variable> variables, const std::vector<double>& a,
              const std::vector<double>& b, double tolerance) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double size = variables[i].scale + std::abs(a[i]);
    if (std::abs(a[i] - b[i]) > tolerance * size) return false;
  }
  return true;
}

/// Minima within limits first, by objective, then others by violation.
struct MinimumRules {
  using Candidate = Minimum;
  const SearchOptions& options;
  const Model* model;

  const Model& model_of(const Minimum& one) const { return one.model ? *one.model : *model; }
  bool is_feasible(const Minimum& one) const {
    return one.solution.violation <= options.feasibility;
  }
  static bool has_value(const Minimum& one) {
    return !one.solution.x.empty() && one.solution.stop != Stop::no_value;
  }
  bool precedes(const Minimum& a, const Minimum& b) const {
    if (is_feasible(a) != is_feasible(b)) return is_feasible(a);
    return is_feasible(a) ? a.solution.objective < b.solution.objective
                          : a.solution.violation < b.solution.violation;
  }
  double value(const Minimum& one) const {
    return is_feasible(one) ? one.solution.objective : kInfinity;
  }
  bool is_same(const Minimum& known, const Minimum& other, double tolerance) const {
    if (options.is_same) return options.is_same(known, other, tolerance);
    if (known.model != other.model) return false;
    const auto close = [&](const std::vector<double>& at) {
      return is_close(model_of(known).variables(), at, other.solution.x, tolerance);
    };
    if (close(known.solution.x)) return true;
    return options.images && std::ranges::any_of(options.images(known), close);
  }
};

class ModelSearch {
 public:
  ModelSearch(const Model* model, const StartSource& starts, const SearchOptions& options)
      : starts_(starts),
        options_(options),
        deadline_(options.time_limit, options.cancelled),
        search_({options, model}, {options.threads, deadline_, options.progress}) {}

  SearchResult run() {
    add_known();
    search_.explore(options_.rule, {0, kExplored},
                    [&](int first, int count) { add_round(first, count); });
    search_.refine({kExplored, 1}, [&](Minimum& found) { finish(found); });
    search_.merge(options_.same_minimum);
    const SearchStatistics statistics = search_.statistics();
    search_.keep(options_.designs);
    return {status(), std::move(search_.all()), statistics, solved_.total()};
  }

 private:
  void add(std::vector<Minimum> fresh) {
    search_.add(std::move(fresh), options_.same_fit);
    search_.keep(options_.designs + options_.reserve);
  }

  void add_known() {
    std::vector<Minimum> fresh(options_.known.size());
    search_.for_each(fresh.size(), [&](std::size_t i) {
      fresh[i] = begun(options_.known[i]);
      fresh[i].hits = 0;  // no start of the search
    });
    add(std::move(fresh));
  }

  void add_round(int first, int count) {
    std::vector<Minimum> fresh(static_cast<std::size_t>(count));
    search_.for_each(fresh.size(), [&](std::size_t i) {
      const auto start = starts_(options_.seed, first + static_cast<int>(i));
      if (start) fresh[i] = begun(*start);
    });
    add(std::move(fresh));
  }

  Minimum begun(const SearchStart& start) const {
    Minimum made{.model = start.model};
    made.solution =
        descend(made, start.x, options_.solver, kExploringTolerance, options_.exploring_iterations);
    return made;
  }

  void finish(Minimum& found) const {
    Minimum next = found;
    next.solution = descend(found, found.solution.x, options_.finisher, options_.tolerance,
                            options_.finishing_iterations);
    const MinimumRules& rules = search_.rules();
    if (rules.has_value(next) && !rules.precedes(found, next)) found = std::move(next);
  }

  Solution descend(const Minimum& of, std::span<const double> start, Solver solver,
                   double tolerance, int iterations) const {
    Solution solution = solve(solver, search_.rules().model_of(of), start,
                              until(deadline_, {.tolerance = tolerance,
                                                .feasibility = options_.feasibility,
                                                .max_iterations = iterations,
                                                .seed = options_.seed}));
    solved_.count(solution);
    return solution;
  }

  SearchStatus status() const {
    if (deadline_.interrupted()) return SearchStatus::cancelled;
    if (deadline_.expired()) return SearchStatus::time_limit;
    if (search_.all().empty()) return SearchStatus::no_solution;
    const bool feasible = search_.rules().is_feasible(search_.all().front());
    return feasible ? SearchStatus::solved : SearchStatus::infeasible;
  }

  const StartSource& starts_;
  const SearchOptions& options_;
  Deadline deadline_;
  MultiStart<MinimumRules> search_;
  WorkCounter solved_;
};

}  // namespace

std::mt19937_64 start_random(std::uint64_t seed, int index) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                         static_cast<std::uint32_t>(index)};
  return std::mt19937_64(sequence);
}

StartSource uniform_starts(const Model& model) {
  return [&model](std::uint64_t seed, int index) -> std::optional<SearchStart> {
    std::mt19937_64 random = start_random(seed, index);
    SearchStart start;
    for (const Variable& variable : model.variables()) {
      const auto [low, high] = side_of(variable);
      start.x.push_back(low < high ? uniform(random, low, high) : low);
    }
    return start;
  };
}

StartSource screened_starts(StartSource source, int count, const Model* model) {
  return [source = std::move(source), count, model](std::uint64_t seed,
                                                    int index) -> std::optional<SearchStart> {
    std::optional<SearchStart> best;
    std::pair least{kInfinity, kInfinity};  // violation, objective
    for (int i = 0; i < count; ++i) {
      auto start = source(seed, index * count + i);
      if (!start) continue;
      const Model& own = start->model ? *start->model : *model;
      const auto objective = objective_of(own, start->x);
      if (!objective) continue;
      const std::pair value{violation_of(own, start->x), *objective};
      if (!(value < least)) continue;
      least = value;
      best = std::move(start);
    }
    return best;
  };
}

SearchResult search(const Model& model, const SearchOptions& options) {
  return search(model, uniform_starts(model), options);
}

SearchResult search(const Model& model, const StartSource& starts, const SearchOptions& options) {
  return ModelSearch(&model, starts, options).run();
}

SearchResult search(const StartSource& starts, const SearchOptions& options) {
  return ModelSearch(nullptr, starts, options).run();
}

}  // namespace cognate::synthesis
