#include "problems/chain/front/read.hpp"

#include "problems/chain/read_design.hpp"
#include "problems/chain/read_made.hpp"
#include "problems/chain_function/given.hpp"
#include "problems/chain_function/verify.hpp"
#include "problems/function/read_goal.hpp"
#include "problems/function/read_target.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/search/read_objectives.hpp"

namespace cognate::problems {
namespace reading {
namespace {

constexpr std::string_view kType = "type", kOutput = "output";

/// The values of `mechanism.type` of a function, those of other kinds first.
std::vector<std::string_view> function_types() {
  std::vector<std::string_view> words{"four-bar"};
  for (const TopologyWord& topology : function_topology_words()) words.push_back(topology.word);
  words.push_back(kChainWord);
  return words;
}

/// Keys of `[target]` and `[solve]` that are for exact synthesis, which is for linkages whose loop
/// equation is linear in its unknowns.
constexpr std::string_view kExactKeys[] = {"precision_points", "at",      "multiplicity",
                                           "derivatives",      "spacing", "method"};

/// Whether a file asks for exact synthesis.
bool is_exact(TableReader& document) {
  for (const std::string_view table : {"target", "solve"}) {
    if (!document.has_table(table)) continue;
    TableReader reader = document.table(table);
    if (std::ranges::any_of(kExactKeys, [&](auto key) { return reader.contains(key); }))
      return true;
    if (reader.has_text("objective") && *reader.text("objective") == "exact") return true;
  }
  return false;
}

/// Faults what is for exact synthesis; returns whether there is such a thing.
bool refuse_exact(TableReader& target, TableReader& solve) {
  bool is_there = false;
  for (const std::string_view key : kExactKeys) {
    for (TableReader* table : {&target, &solve}) {
      if (!table->has(key)) continue;
      is_there = true;
      table->fault(key,
                   "is for exact synthesis of four-bars and slider-cranks; remove it: chains take "
                   "objective = \"least-squares\" or \"minimax\"");
    }
  }
  return is_there;
}

void read_goal(TableReader& target, TableReader& solve, ChainFunctionProblem& problem) {
  const auto type = slides(problem) ? MechanismType::slider_crank : MechanismType::four_bar;
  auto wanted = read_function_target(target, type);
  if (refuse_exact(target, solve) || !wanted) return know_function_goal(target, solve);
  FunctionProblem goal;
  goal.target = *std::move(wanted);
  read_function_goal(target, solve, goal);
  if (goal.objective == FunctionObjective::exact) {
    holder("objective", target, solve)
        .fault("objective",
               "is \"exact\", which four-bars and slider-cranks can be; expected "
               "\"least-squares\" or \"minimax\"");
  }
  problem.target = std::move(goal.target);
  problem.objective = goal.objective;
  problem.sample_at = std::move(goal.sample_at);
}

Wanted wanted_output(const ChainFunctionProblem& problem) {
  const auto& [from, to] = problem.output;
  if (slides(problem)) return {kOutput, {to}, true};
  return {kOutput, {from, to}};
}

void read_constraints(TableReader& table, ChainFunctionProblem& problem) {
  auto& limits = problem.constraints;
  limits.transmission_angle = read_chain_transmission(table).value_or(limits.transmission_angle);
  // The crank of a mechanism with a three-pin link turns fully.
  const bool turns = std::ranges::any_of(problem.topologies, has_three_pin_link);
  limits.over = table.choice<LimitSpan>("over").value_or(turns ? LimitSpan::turn : limits.over);
  limits.error = read_error_limit(table, error_measure(problem));
  refuse_four_bar_limits(table, "transmission_angle_deg, over and a limit of the error");
}

}  // namespace
}  // namespace reading

bool slides(const ChainFunctionProblem& problem) {
  return problem.output[0] == guide_name(problem.output[1]);
}

bool KindTraits<ChainFunctionProblem>::takes(reading::TableReader& document) {
  if (!document.has_table("mechanism")) return false;
  if (document.has_table("target") && document.table("target").contains("dwell")) return false;
  reading::TableReader mechanism = document.table("mechanism");
  if (!mechanism.has_text(reading::kType)) return false;
  const std::string type = *mechanism.text(reading::kType);
  if (type == kSliderCrankWord) return !reading::is_exact(document);
  return type == kChainWord || !from_string<MechanismType>(type);
}

ChainFunctionProblem KindTraits<ChainFunctionProblem>::read(
    reading::TableReader& document, const std::filesystem::path& /*folder*/) {
  using namespace reading;
  ChainFunctionProblem problem;
  LinkageTables tables(document);
  problem.mechanism = tables.mechanism.text(kType).value_or("");
  if (problem.mechanism != kChainWord && function_topologies(problem.mechanism).empty()) {
    fault_chain_type(document, tables.mechanism, function_types());
    return problem;
  }
  const auto known = function_topologies(problem.mechanism);
  problem.output = read_output(tables.target, problem.mechanism, known);
  read_goal(tables.target, tables.solve, problem);
  problem.topologies = read_topologies(document, tables, known, wanted_output(problem));
  read_constraints(tables.constraints, problem);
  read_chain_solve(tables.solve, problem.solve);
  problem.against = read_against(tables.solve,
                                 {.mechanism = problem.mechanism,
                                  .topologies = problem.topologies,
                                  .of_any_count = {},
                                  .has_sizes = slides(problem),
                                  .is_given = is_given(problem)},
                                 problem.solve);
  read_made(document, tables, slides(problem) ? "length" : "deg", problem.constraints.over,
            problem);
  for (TableReader* table :
       {&tables.target, &tables.mechanism, &tables.constraints, &tables.solve}) {
    table->finish();
  }
  problem.warnings = read_warnings(document);
  return problem;
}

}  // namespace cognate::problems
