/// @file The global search over a model of one's own: many starts, the minima they lead to, and how
/// likely it is that others were missed.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "synthesis/optimise/model.hpp"
#include "synthesis/optimise/solver.hpp"
#include "synthesis/search/multi_start.hpp"
#include "synthesis/search/statistics.hpp"

namespace cognate::synthesis {

/// Where a descent begins.
struct SearchStart {
  std::vector<double> x;  ///< one entry for each variable of the model
  /// The model to descend in, where it depends on the start (an assembly, a class of linkages);
  /// empty: that of the search. Minima of different models are different ones.
  std::shared_ptr<const Model> model{};
};

/// A local minimum.
struct Minimum {
  Solution solution;
  std::shared_ptr<const Model> model{};  ///< that of its start
  int hits = 1;                          ///< how many starts led to it
};

/// Draws start number `index` (0, 1, …), the same for the same seed and index; empty where that
/// draw is no start. Called from many threads at once.
using StartSource = std::function<std::optional<SearchStart>(std::uint64_t seed, int index)>;

/// Random numbers of start number `index`, independent of those of the others.
std::mt19937_64 start_random(std::uint64_t seed, int index);

/// Points of the box of the model's bounds, each as likely. Where a bound is infinite, the box ends
/// ten scales beyond the other bound, or on either side of 0. `model` must outlive the source.
StartSource uniform_starts(const Model& model);

/// Of every `count` starts of `source` the one that violates constraints least, of several that
/// violate none the one of lowest objective.
/// `model`, for starts that bring none, must outlive the source; it may be null.
StartSource screened_starts(StartSource source, int count, const Model* model);

/// How a search is done. All defaults may stay as they are.
struct SearchOptions {
  /// When there are enough starts. Unless the number is given, at least 200 and at most 2000, until
  /// five led to the best minimum and it was found in the first third of them.
  StartRule rule{.most = 2000, .patience = 3, .met = 1e-24};
  std::vector<SearchStart> known{};  ///< to begin with in addition to the starts; they are no hits

  std::size_t designs = 10;  ///< minima to return at most
  /// Beyond these, so many explored minima are refined further.
  std::size_t reserve = 20;

  /// Solver and iterations for every start, and for the best minima.
  Solver solver = Solver::gauss_newton;
  int exploring_iterations = 100;
  Solver finisher = Solver::gauss_newton;
  int finishing_iterations = 2000;
  double tolerance = 1e-13;   ///< see `Options`, of the finisher
  double feasibility = 1e-9;  ///< largest violation of a constraint that counts as met

  /// Explored minima, and refined ones, whose variables differ by no more than this, relative to
  /// the variable's scale + |x|, are one.
  double same_fit = 1e-4, same_minimum = 1e-6;
  /// Other points that are the same design: mirror images, cognates, whole turns of an angle. A
  /// minimum near one of them is not another minimum.
  std::function<std::vector<std::vector<double>>(const Minimum& minimum)> images{};
  /// Whether two minima are one design, in place of those tests. `tolerance` is one of the above.
  std::function<bool(const Minimum& a, const Minimum& b, double tolerance)> is_same{};

  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: as many as the machine has; the result does not depend on it
  double time_limit = std::numeric_limits<double>::infinity();  ///< seconds
  const std::atomic<bool>* cancelled = nullptr;                 ///< ends the search once true
  /// Called now and then from one thread with the share done (0 … 1) and the least objective so far
  /// within limits.
  std::function<void(double share, double best)> progress{};
};

/// How a search ended: with a minimum within limits, with minima that violate some, with none at
/// all (no start has a value), or early. Ended early, it has what was found until then.
enum class SearchStatus { solved, infeasible, no_solution, time_limit, cancelled };

/// What a search found.
struct SearchResult {
  SearchStatus status = SearchStatus::no_solution;
  std::vector<Minimum> minima;  ///< different ones, best first, those within limits before others
  SearchStatistics statistics;
  SolverWork work;
};

/// Local minima of `model` under its constraints, from starts drawn evenly within its bounds. The
/// same options give the same result, unless time or cancellation end the search.
SearchResult search(const Model& model, const SearchOptions& options = {});

/// From starts of one's own. `model` is that of starts that bring none.
SearchResult search(const Model& model, const StartSource& starts,
                    const SearchOptions& options = {});

/// Where each start brings its model.
SearchResult search(const StartSource& starts, const SearchOptions& options = {});

}  // namespace cognate::synthesis
