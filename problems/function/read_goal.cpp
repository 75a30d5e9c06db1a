#include "problems/function/read_goal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/function/read_target.hpp"

namespace cognate::problems::reading {
namespace {

constexpr int kFewestPoints = 3;
constexpr int kMostPoints = 5;

// The tables that hold each key.
struct Goal {
  TableReader& precision_points;
  TableReader& at;
  TableReader& multiplicity;
  TableReader& spacing;
  TableReader& objective;
  TableReader& method;
  TableReader& samples;
  TableReader& sample_at;
};

Goal find_goal(TableReader& target, TableReader& solve) {
  return {holder("precision_points", target, solve), holder("at", target, solve),
          holder("multiplicity", target, solve),     holder("spacing", target, solve),
          holder("objective", target, solve),        holder("method", target, solve),
          holder("samples", target, solve),          holder("sample_at", target, solve)};
}

void read_objective(Goal& goal, FunctionProblem& problem) {
  constexpr std::string_view kMethods[] = {"exact"};
  const auto objective = goal.objective.choice<FunctionObjective>("objective");
  const auto method = goal.method.choice_of("method", kMethods);
  const bool points = goal.precision_points.has("precision_points") || goal.at.has("at");
  const bool exact = points || method || objective == FunctionObjective::exact;
  problem.objective =
      exact ? FunctionObjective::exact : objective.value_or(FunctionObjective::least_squares);
  if (exact && objective && *objective != FunctionObjective::exact) {
    goal.objective.fault(
        "objective", fmt::format("is \"{}\" beside precision points or method = \"exact\"; give "
                                 "one or the other",
                                 to_string(*objective)));
  }
}

// Abscissae: increasing and within the domain.
void check_abscissae(TableReader& table, std::string_view key, const std::vector<double>& xs,
                     const Range& domain) {
  for (std::size_t i = 0; i < xs.size(); ++i) {
    if (xs[i] < domain.min || xs[i] > domain.max) {
      table.faults().add(table.where(key, i),
                         fmt::format("entry {} of {} is {}; expected x from {} to {}", i + 1,
                                     table.name(key), xs[i], domain.min, domain.max));
    } else if (i > 0 && xs[i] <= xs[i - 1]) {
      table.faults().add(table.where(key, i),
                         fmt::format("entry {} of {} is {} after {}; expected increasing x", i + 1,
                                     table.name(key), xs[i], xs[i - 1]));
    }
  }
}

constexpr std::string_view kConditions =
    "expected 3 to 5 conditions, one for each point and one for each derivative";

// How closely each point is met: the output alone, or derivatives too.
void read_multiplicity(Goal& goal, const std::optional<std::vector<double>>& at,
                       const FunctionOfX& function, FunctionProblem& problem) {
  constexpr std::string_view kKey = "multiplicity";
  TableReader& table = goal.multiplicity;
  const auto given = table.numbers(kKey, kMultiplicity, {1, kMostPoints, "multiplicities"});
  if (!given) return;
  if (!goal.at.has("at")) {
    table.fault(kKey, "is given without at; expected at = [...] with one x for each");
    return;
  }
  if (!at) return;
  const double sum = std::accumulate(given->begin(), given->end(), 0.0);
  if (given->size() != at->size()) {
    table.fault(kKey, fmt::format("has {} entries for {} precision points; expected as many",
                                  given->size(), at->size()));
  } else if (sum < kFewestPoints || sum > kMostPoints) {
    table.fault(kKey, fmt::format("makes {} conditions; {}", sum, kConditions));
  } else if (!function.table.empty() && sum > static_cast<double>(given->size())) {
    table.fault(kKey,
                "requires derivatives, which a table does not have; give pairs with "
                "derivatives, or a function");
  } else {
    for (const double value : *given) problem.multiplicity.push_back(static_cast<int>(value));
  }
}

// Both ends of a whole turn are one position of the input link.
void check_turn(TableReader& table, const std::vector<double>& at, const FunctionOfX& function) {
  if (at.size() < 2) return;
  const double width = function.domain.max - function.domain.min;
  const double turn = function.input_range ? std::abs(*function.input_range) : width;
  const double sweep = (at.back() - at.front()) / width * turn;
  if (std::abs(sweep - kTurn) <= 1e-9) {
    table.fault("at",
                "puts its first and last point a whole turn of the input apart; expected precision "
                "points at different positions of the input");
  }
}

// Where `at` does not say it, precision points stand in Chebyshev's spacing or level the error.
void read_spacing(Goal& goal, FunctionProblem& problem) {
  constexpr std::string_view kKey = "spacing";
  problem.spacing = goal.spacing.choice<PointSpacing>(kKey).value_or(problem.spacing);
  if (goal.spacing.has(kKey) && goal.at.has("at")) {
    goal.spacing.fault(kKey, "is given beside at, which places the precision points; give one");
  } else if (goal.spacing.has(kKey) && problem.objective != FunctionObjective::exact) {
    goal.spacing.fault(kKey, "is for exact synthesis; expected precision_points = 3, 4 or 5");
  }
}

void read_precision_points(Goal& goal, const FunctionOfX& function, FunctionProblem& problem) {
  const auto count = goal.precision_points.integer("precision_points", kFewestPoints, kMostPoints);
  const std::size_t fewest = goal.multiplicity.has("multiplicity") ? 1 : kFewestPoints;
  const auto at = goal.at.numbers("at", kNumber, {fewest, kMostPoints, "precision points"});
  read_multiplicity(goal, at, function, problem);
  read_spacing(goal, problem);
  if (problem.objective != FunctionObjective::exact) return;
  if (at) {
    check_abscissae(goal.at, "at", *at, function.domain);
    check_turn(goal.at, *at, function);
    problem.at = *at;
  }
  if (!at && goal.at.has("at")) return;  // wrong, and said to be
  int given = at ? static_cast<int>(at->size()) : count.value_or(kFewestPoints);
  if (!problem.multiplicity.empty()) {
    given = std::accumulate(problem.multiplicity.begin(), problem.multiplicity.end(), 0);
  }
  if (count && given != *count) {
    goal.precision_points.fault("precision_points",
                                fmt::format("is {}, but at has {} entries; remove it or give as "
                                            "many",
                                            *count, given));
  }
  problem.precision_points = given;
}

std::vector<double> uniform(const Range& domain, int count) {
  std::vector<double> xs;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    // The ends themselves, without rounding.
    xs.push_back(i == count - 1 ? domain.max : domain.min + share * (domain.max - domain.min));
  }
  return xs;
}

void read_samples(Goal& goal, TableReader& target, const FunctionOfX& function,
                  FunctionProblem& problem) {
  const auto count = goal.samples.integer("samples", 3, 10000);
  const auto given = goal.sample_at.numbers("sample_at", kNumber, {.min = 3, .of = "samples"});
  if (goal.samples.has("samples") && goal.sample_at.has("sample_at")) {
    goal.samples.fault("samples", "is given beside sample_at; give one of them");
  }
  if (given) {
    check_abscissae(goal.sample_at, "sample_at", *given, function.domain);
    problem.sample_at = *given;
  } else if (count || function.table.empty()) {
    problem.sample_at = uniform(function.domain, count.value_or(kDefaultSamples));
  } else {
    for (const auto& row : function.table) problem.sample_at.push_back(row.first);
  }
  const auto bad = std::ranges::find_if(problem.sample_at, [&](double x) {
    return !(std::abs(function.y(x)) <= kGreatestMagnitude);
  });
  if (bad == problem.sample_at.end()) return;
  const std::string rest = fmt::format(
      "is {} at the sample x = {}; expected finite values of magnitude up "
      "to 1e100 at every sample",
      value_in_words(function.y(*bad)), *bad);
  target.fault(target_key(target), rest);
}

// Inputs a whole number of turns apart are one position of the input link.
bool same_input(double a, double b) {
  return std::abs(std::remainder(a - b, kTurn)) <= 1e-9;
}

void check_pair_inputs(TableReader& target, std::string_view key, const AnglePairs& pairs,
                       bool exact) {
  std::vector<std::size_t> order(pairs.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto reduced = [&](std::size_t i) { return std::remainder(pairs[i].first, kTurn); };
  std::ranges::stable_sort(order, {}, reduced);
  std::size_t distinct = order.size();
  for (std::size_t j = 0; j < order.size(); ++j) {
    // The neighbour on the circle of angles; the first one's, across its seam, is the last.
    const std::size_t a = order[j == 0 ? order.size() - 1 : j - 1];
    const std::size_t b = order[j];
    const bool no_seam = j == 0 && reduced(a) - reduced(b) < kPi;
    if (no_seam || !same_input(pairs[a].first, pairs[b].first)) continue;
    --distinct;
    if (!exact && same_input(pairs[a].second, pairs[b].second)) continue;
    target.faults().add(target.where(key, std::max(a, b)),
                        fmt::format("pair {} of target.{} has the input angle of pair {}; {}",
                                    std::max(a, b) + 1, key, std::min(a, b) + 1,
                                    exact ? "expected different input angles for exact synthesis"
                                          : "expected one output for each input"));
  }
  if (!exact && distinct < 3) {
    target.fault(key, fmt::format("has {} different input angles; expected at least 3", distinct));
  }
}

// Derivatives of the output by the input at each pair.
void read_derivatives(TableReader& target, std::string_view pairs_key, const AnglePairs& pairs,
                      FunctionProblem& problem) {
  constexpr std::string_view kKey = "derivatives";
  const auto given =
      target.lists(kKey, kNumber, "[[first, second, ...], ...] with one for each pair",
                   {1, 10000, "entries"}, kMostPoints - 1);
  if (!given) return;
  if (problem.objective != FunctionObjective::exact) {
    target.fault(kKey, "is for exact synthesis; give precision_points or objective = \"exact\"");
  } else if (given->size() != pairs.size()) {
    target.fault(kKey, fmt::format("has {} entries for the {} of target.{}; expected as many",
                                   given->size(), pairs.size(), pairs_key));
  } else {
    problem.derivatives = *given;
  }
}

void read_pairs_goal(Goal& goal, TableReader& target, const AnglePairs& pairs,
                     FunctionProblem& problem) {
  constexpr std::string_view kFor = "is for a function or a table; remove it for pairs";
  if (goal.at.has("at")) goal.at.fault("at", kFor);
  if (goal.multiplicity.has("multiplicity")) {
    goal.multiplicity.fault("multiplicity",
                            "is for a function; expected derivatives = [[...], ...] for pairs");
  }
  if (goal.spacing.has("spacing")) goal.spacing.fault("spacing", kFor);
  if (goal.samples.has("samples")) goal.samples.fault("samples", kFor);
  if (goal.sample_at.has("sample_at")) goal.sample_at.fault("sample_at", kFor);
  const std::string_view key = pairs_key(problem.type);
  const bool exact = problem.objective == FunctionObjective::exact;
  const auto count = goal.precision_points.integer("precision_points", kFewestPoints, kMostPoints);
  check_pair_inputs(target, key, pairs, exact);
  read_derivatives(target, key, pairs, problem);
  const bool faulty = target.has("derivatives") && problem.derivatives.empty();
  if (!exact || faulty) return;
  int given = static_cast<int>(std::min(pairs.size(), std::size_t{kMostPoints + 1}));
  for (const auto& list : problem.derivatives) given += static_cast<int>(list.size());
  if (count && *count != given) {
    goal.precision_points.fault(
        "precision_points",
        fmt::format("is {} for {} {}; remove it or give as many", *count,
                    problem.derivatives.empty() ? static_cast<int>(pairs.size()) : given,
                    problem.derivatives.empty() ? "pairs" : "pairs and derivatives"));
  } else if (given < kFewestPoints || given > kMostPoints) {
    target.fault(key,
                 fmt::format("requests exact synthesis with {} conditions; {}, or objective = "
                             "\"least-squares\"",
                             problem.derivatives.empty() ? static_cast<int>(pairs.size()) : given,
                             kConditions));
  }
  problem.precision_points = given;
}

}  // namespace

void read_function_goal(TableReader& target, TableReader& solve, FunctionProblem& problem) {
  Goal goal = find_goal(target, solve);
  read_objective(goal, problem);
  if (const auto* pairs = std::get_if<AnglePairs>(&problem.target)) {
    read_pairs_goal(goal, target, *pairs, problem);
    return;
  }
  if (target.has("derivatives")) {
    target.fault("derivatives", "is for pairs; expected multiplicity = [...] beside at here");
  }
  const auto& function = std::get<FunctionOfX>(problem.target);
  read_precision_points(goal, function, problem);
  read_samples(goal, target, function, problem);
}

void know_function_goal(TableReader& target, TableReader& solve) {
  find_goal(target, solve);
  target.know({"derivatives"});
}

}  // namespace cognate::problems::reading
