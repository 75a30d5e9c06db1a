#include "problems/read.hpp"

#include <fmt/core.h>

#include <utility>

#include "problems/task_document.hpp"
#include "problems/toml/file_text.hpp"

namespace cognate::problems {
namespace {

using Faults = std::vector<Fault>;
using Reading = reading::PlacedTask;

tl::expected<Reading, Faults> parse(std::string_view text,
                                    const std::filesystem::path& folder = {}) {
  return reading::read_text(text).and_then(
      [&](const reading::Table& document) { return reading::read_task(document, folder); });
}

tl::expected<Task, Faults> any_task(Reading read) {
  return std::move(read.task);
}

// What is asked for where nothing of this kind was wanted: a fault at the file's `kind`.
template <class Wanted>
tl::expected<Wanted, Faults> only(Reading read, std::string_view wanted) {
  if (auto* task = std::get_if<Wanted>(&read.task)) return std::move(*task);
  constexpr std::string_view kAsked[] = {
      "is that of a design problem, which 'cognate solve' solves",
      "is \"analysis\": there is nothing to solve, 'cognate analyze' evaluates this mechanism",
      ("is \"cam\": 'cognate solve' designs a cam, and evaluates one whose dimensions are all "
       "given"),
      "is \"gear\": there is nothing to solve, 'cognate analyze' evaluates this gear",
      ("is \"gear-pair\": 'cognate solve' finds what it leaves free, 'cognate analyze' evaluates a "
       "whole one"),
      "is \"machine\": there is nothing to solve, 'cognate analyze' runs this machine"};
  return tl::unexpected(
      Faults{{read.kind.line, read.kind.column,
              fmt::format("kind {}; {} is wanted", kAsked[read.task.index()], wanted)}});
}

tl::expected<Problem, Faults> only_problem(Reading read) {
  return only<Problem>(std::move(read), "a design problem");
}

tl::expected<AnalysisProblem, Faults> only_analysis(Reading read) {
  return only<AnalysisProblem>(std::move(read), "kind = \"analysis\" with a whole [mechanism]");
}

tl::expected<CamProblem, Faults> only_cam(Reading read) {
  return only<CamProblem>(std::move(read), "kind = \"cam\"");
}

tl::expected<GearProblem, Faults> only_gear(Reading read) {
  return only<GearProblem>(std::move(read), "kind = \"gear\"");
}

tl::expected<GearPairProblem, Faults> only_gear_pair(Reading read) {
  return only<GearPairProblem>(std::move(read), "kind = \"gear-pair\"");
}

tl::expected<MachineProblem, Faults> only_machine(Reading read) {
  return only<MachineProblem>(std::move(read), "kind = \"machine\"");
}

tl::expected<Reading, Faults> read(const std::filesystem::path& file) {
  std::error_code error;
  const auto folder = std::filesystem::absolute(file, error).parent_path();
  const auto text = reading::text_of(file);
  if (!text) return tl::unexpected(Faults{{1, 1, text.error()}});
  return parse(*text, folder);
}

}  // namespace

tl::expected<Task, Faults> parse_task(std::string_view text) {
  return parse(text).and_then(any_task);
}

tl::expected<Problem, Faults> parse_problem(std::string_view text) {
  return parse(text).and_then(only_problem);
}

tl::expected<AnalysisProblem, Faults> parse_analysis(std::string_view text) {
  return parse(text).and_then(only_analysis);
}

tl::expected<CamProblem, Faults> parse_cam(std::string_view text) {
  return parse(text).and_then(only_cam);
}

tl::expected<GearProblem, Faults> parse_gear(std::string_view text) {
  return parse(text).and_then(only_gear);
}

tl::expected<GearPairProblem, Faults> parse_gear_pair(std::string_view text) {
  return parse(text).and_then(only_gear_pair);
}

tl::expected<MachineProblem, Faults> parse_machine(std::string_view text) {
  return parse(text).and_then(only_machine);
}

tl::expected<Task, Faults> read_task(const std::filesystem::path& file) {
  return read(file).and_then(any_task);
}

tl::expected<Problem, Faults> read_problem(const std::filesystem::path& file) {
  return read(file).and_then(only_problem);
}

tl::expected<AnalysisProblem, Faults> read_analysis(const std::filesystem::path& file) {
  return read(file).and_then(only_analysis);
}

tl::expected<MachineProblem, Faults> read_machine(const std::filesystem::path& file) {
  return read(file).and_then(only_machine);
}

tl::expected<CamProblem, Faults> read_cam(const std::filesystem::path& file) {
  return read(file).and_then(only_cam);
}

tl::expected<GearProblem, Faults> read_gear(const std::filesystem::path& file) {
  return read(file).and_then(only_gear);
}

tl::expected<GearPairProblem, Faults> read_gear_pair(const std::filesystem::path& file) {
  return read(file).and_then(only_gear_pair);
}

}  // namespace cognate::problems
