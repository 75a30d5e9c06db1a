#include "problems/search/read_objectives.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "problems/basics/names.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kKey = "objectives";
constexpr int kFrontDesigns = 12;

/// Each once, with faults for what is no measure.
std::vector<DesignObjective> read_measures(TableReader& table) {
  std::vector<std::string_view> allowed;
  for (const auto& named : names<DesignObjective>()) allowed.push_back(named.name);
  const auto words = table.texts(kKey, {1, 2, "objectives"});
  std::vector<DesignObjective> measures;
  if (!words) return measures;
  for (std::size_t i = 0; i < words->size(); ++i) {
    const std::string& word = (*words)[i];
    const auto measure = from_string<DesignObjective>(word);
    if (!measure) {
      table.faults().add(table.where(kKey, i),
                         fmt::format("solve.objectives has {}; allowed are {}", in_quotes(word),
                                     quoted_list(allowed)));
    } else if (std::ranges::count(measures, *measure) > 0) {
      table.faults().add(
          table.where(kKey, i),
          fmt::format("solve.objectives has {} twice; expected each once", in_quotes(word)));
    } else {
      measures.push_back(*measure);
    }
  }
  return measures.size() == words->size() ? measures : std::vector<DesignObjective>{};
}

bool turns_fully(const Constraints& constraints) {
  return constraints.required_class == RequiredClass::crank_rocker ||
         constraints.required_class == RequiredClass::double_crank;
}

/// Whether the measure is one that the problem can have.
void check_measure(TableReader& table, const ObjectiveScope& scope, const Constraints& constraints,
                   DesignObjective measure) {
  if (measure == DesignObjective::size && !scope.has_sizes) {
    table.fault(
        kKey,
        "has \"size\", but a function is one of ratios of lengths; expected \"link_ratio\" or "
        "\"transmission_angle\"");
  }
  const bool over_turn = is_over_cycle(measure) ||
                         (measure == DesignObjective::transmission_angle && scope.needs_full_turn);
  if (over_turn && !turns_fully(constraints)) {
    table.fault(kKey,
                fmt::format("has \"{}\", which is taken over the full turn of the crank; expected "
                            "constraints.class = \"crank-rocker\" or \"double-crank\" as well",
                            to_string(measure)));
  }
}

/// What does not go with several objectives.
void check_company(TableReader& table, const ObjectiveScope& scope, bool front, Solve& solve) {
  const std::string_view refusal = scope.exact.empty() ? scope.refusal : scope.exact;
  if (!refusal.empty()) table.fault(kKey, refusal);
  if (solve.certify) {
    table.fault("certify",
                "is true with solve.objectives, but a certificate is about the error "
                "alone; leave one of them out");
  }
  if (solve.loss != synthesis::Loss::none) {
    table.fault("loss",
                "is given with solve.objectives, whose error is that of least squares or "
                "minimax; leave one of them out");
  }
  if (!can_solve(solve.solver, {.constraints = true})) {
    table.fault("solver", fmt::format("is \"{}\", which cannot keep within the bounds that several "
                                      "objectives need; every other solver can",
                                      to_string(solve.solver)));
  }
  if (front) read_front_designs(table, solve);
  if (!front && table.has("designs") && solve.designs != 1) {
    table.fault("designs",
                "is more than 1 with an objective that one design has best; remove it, or add "
                "\"error\" to the objectives for a front");
  }
}

}  // namespace

std::optional<ErrorLimit> read_error_limit(TableReader& constraints, ErrorMeasure measure) {
  std::optional<ErrorLimit> limit;
  for (const auto& [key, of] : names<ErrorMeasure>()) {
    if (of == measure) {
      const auto most = constraints.number(key, kErrorScale);
      if (most) limit = {of, is_angle(of) ? radians(*most) : *most};
    } else if (constraints.has(key)) {
      constraints.fault(
          key, fmt::format("is of another error than this problem's; expected constraints.{}",
                           to_string(measure)));
    }
  }
  return limit;
}

void read_front_designs(TableReader& table, Solve& solve) {
  constexpr std::string_view kDesigns = "designs";
  if (!table.has(kDesigns)) solve.designs = kFrontDesigns;
  if (solve.designs < 2) {
    table.fault(kDesigns, "is 1, but a front has two ends; expected at least 2");
  }
}

void read_objectives(TableReader& constraints_table, TableReader& solve_table,
                     const ObjectiveScope& scope, Constraints& constraints, Solve& solve) {
  if (const auto limit = read_error_limit(constraints_table, scope.error)) {
    if (!scope.exact.empty()) constraints_table.fault(to_string(scope.error), scope.exact);
    constraints.error = limit;
  }
  solve.objectives = read_measures(solve_table);
  const auto& all = solve.objectives;
  const bool with_error = std::ranges::count(all, DesignObjective::error) > 0;
  if (all.empty() || (with_error && all.size() == 1)) return;
  const bool front = with_error;
  check_company(solve_table, scope, front, solve);
  for (const DesignObjective measure : all) check_measure(solve_table, scope, constraints, measure);
  if (!with_error && all.size() > 1) {
    solve_table.fault(kKey, "are two without \"error\"; expected \"error\" and one other");
  } else if (!with_error && !constraints.error) {
    solve_table.fault(kKey, fmt::format("does without \"error\", which is then to be bounded; "
                                        "expected constraints.{}, or \"error\" as well",
                                        to_string(scope.error)));
  }
  if (!front && !solve_table.has("designs")) solve.designs = 1;
}

}  // namespace cognate::problems::reading
