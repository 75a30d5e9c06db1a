/// @file Designs in a page: a problem of which all dimensions are given is read and evaluated by
/// the program's own reader and evaluator, and comes back as the design that its page is drawn
/// from.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/documents/result_json.hpp"
#include "app/report/design_drawing.hpp"
#include "app/report/function_trace.hpp"
#include "app/report/kernel/answer.hpp"
#include "app/report/kernel/document.hpp"
#include "app/report/kernel/numbers.hpp"
#include "app/report/kernel/problem_of.hpp"
#include "problems/chain/given.hpp"
#include "problems/chain_function/given.hpp"
#include "problems/chain_function/space.hpp"
#include "problems/dwell/given.hpp"
#include "problems/leg/given.hpp"
#include "problems/linkage/warnings.hpp"

namespace cognate::page {
namespace {

using nlohmann::ordered_json;
using problems::ChainFunctionProblem;
using problems::ChainPathProblem;
using problems::Design;
using problems::DwellProblem;
using problems::LegProblem;

/// The design of a problem of which all dimensions are given.
template <class Problem>
std::optional<Design> given(const Problem& problem) {
  return problems::given_design(problem);
}

std::optional<Design> given(const ChainFunctionProblem& problem) {
  return problems::given_design(problem, problems::function_samples(problem));
}

/// What a design has at its targets.
ordered_json reached_of(const ChainPathProblem& problem, const Design& design) {
  const problems::Topology& topology = problem.topologies.front();
  const auto& traced = topology.lines[static_cast<std::size_t>(topology.trace)].name;
  return app::reached_points(design, traced);
}

template <class Problem>
ordered_json reached_of(const Problem& /*problem*/, const Design& design) {
  return app::reached_points(design);
}

ordered_json reached_of(const ChainFunctionProblem& problem, const Design& design) {
  return {{"trace", app::trace_json(app::function_trace(problem, design), slides(problem))}};
}

std::optional<problems::TargetExtent> size_of(const ChainPathProblem& problem) {
  return problems::extent_of(problem.points);
}

template <class Problem>
std::optional<problems::TargetExtent> size_of(const Problem& /*problem*/) {
  return std::nullopt;
}

bool has_angles(const ChainPathProblem& /*problem*/) {
  return false;
}

bool has_angles(const LegProblem& /*problem*/) {
  return false;
}

template <class Problem>
bool has_angles(const Problem& problem) {
  return !slides(problem);
}

/// The entry that the design has in a result, and what is drawn of it; null where there is none.
template <class Problem>
ordered_json answer_of(const Problem& problem) {
  problems::Result result;
  if (auto design = given(problem)) result.designs.push_back(*std::move(design));
  if (result.designs.empty()) return nullptr;
  problems::add_warnings(size_of(problem), problem.warnings, result);
  const Design& design = result.designs.front();
  auto drawn = app::motion_of(design, app::fineness(1));
  drawn.update(reached_of(problem, design));
  return {{"entry", app::design_json(design, has_angles(problem))}, {"drawn", drawn}};
}

template <class Problem>
int answer_to(const problems::reading::Table& document) {
  problems::reading::FaultList faults;
  const auto problem = problem_of<Problem>(document, faults);
  if (!faults.empty()) return answer_with(faults_json(std::move(faults)));
  return answer_with(answer_of(problem));
}

}  // namespace

/// Evaluates the problem in the text and the block of numbers. The answer is its design, null where
/// the links cannot be assembled as they must be, or `faults`, a list of sentences.
COGNATE_EXPORT(design) int design_text() {
  problems::reading::FaultList none;
  const auto document = document_of(question());
  problems::reading::TableReader reader(document, none);
  const auto kind = reader.text("kind");
  if (kind == problems::KindTraits<ChainPathProblem>::kWord) {
    return answer_to<ChainPathProblem>(document);
  }
  if (kind == problems::KindTraits<LegProblem>::kWord) return answer_to<LegProblem>(document);
  const bool is_function = problems::KindTraits<ChainFunctionProblem>::takes(reader);
  return is_function ? answer_to<ChainFunctionProblem>(document)
                     : answer_to<DwellProblem>(document);
}

}  // namespace cognate::page
