/// @file What the searches of the page that one draws on have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "app/report/kernel/answer.hpp"
#include "problems/linkage/read_linkage.hpp"
#include "problems/linkage/result.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::page {

/// Longer lists are not drawn by hand.
inline constexpr std::size_t kMostTargets = 200;

/// A problem as the page asks it.
struct SketchQuestion {
  const problems::reading::Table& document;
  std::uint64_t seed = 1;
};

/// `known`, designs with which the search begins: rows of the fixed pivots, the lengths of crank,
/// coupler and rocker, the coupler point, 1 where the assembly is open, the guided body's angle in
/// the coupler in degrees, and the crank's angle at each of `targets` targets, in degrees.
std::vector<problems::Design> read_known(problems::reading::TableReader& document,
                                         std::size_t targets);

/// A search on the one thread of a page.
problems::Run run_of(const SketchQuestion& question, std::vector<problems::Design> known);

/// What a question's answer calls a design that is a four-bar: its dimensions as in a file.
nlohmann::ordered_json four_bar_of(const problems::Design& design);

/// The same of any kind of mechanism.
using MechanismOf = nlohmann::ordered_json (*)(const problems::Design& design);

/// {"designs": each with its errors and what is measured of it}.
nlohmann::ordered_json sketched(const std::vector<problems::Design>& designs,
                                MechanismOf mechanism_of);

/// Faults a target that is missing: there is nothing to search for.
void require_target(problems::reading::TableReader& target, std::string_view key);

/// The answer to a question. `read(tables, problem)` fills a problem from the tables and gives the
/// number of its targets, `solve(problem, run)` gives designs; `known(reader, targets)` are those
/// that the search begins with, and where the question says `known_alone` no others;
/// `mechanism_of` says what a design is.
template <class Problem, class Read, class Solve, class Known = decltype(&read_known)>
nlohmann::ordered_json answered(const SketchQuestion& question, const Read& read,
                                const Solve& solve, const Known& known = &read_known,
                                MechanismOf mechanism_of = &four_bar_of) {
  problems::reading::FaultList faults;
  problems::reading::TableReader reader(question.document, faults);
  reader.know({"kind"});
  problems::reading::LinkageTables tables(reader);
  Problem problem;
  const std::size_t targets = read(tables, problem);
  tables.finish();
  auto begun = known(reader, targets);
  if (reader.boolean("known_alone").value_or(false)) problem.solve.starts = 0;
  reader.finish();
  if (!faults.empty()) return faults_json(std::move(faults));
  return sketched(solve(problem, run_of(question, std::move(begun))), mechanism_of);
}

/// The answers: `designs`, perhaps none, or `faults`, a list of sentences.
nlohmann::ordered_json sketched_paths(const SketchQuestion& question);
nlohmann::ordered_json sketched_slider_cranks(const SketchQuestion& question);
nlohmann::ordered_json sketched_lines(const SketchQuestion& question);
nlohmann::ordered_json sketched_motions(const SketchQuestion& question);
nlohmann::ordered_json sketched_functions(const SketchQuestion& question);

/// The word in the place of a problem's kind for a question that searches for nothing: `values`,
/// those of an expression in x at equal steps over a domain, or `faults`.
inline constexpr std::string_view kFunctionValues = "function-values";
nlohmann::ordered_json function_values(const SketchQuestion& question);

}  // namespace cognate::page
