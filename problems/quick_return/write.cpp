/// A quick-return problem written down, and checked by reading what was written.
#include "problems/linkage/result.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/quick_return/problem.hpp"

namespace cognate::problems {
namespace reading {
namespace {

Written written(const QuickReturnProblem& problem) {
  TableWriter document = document_writer("quick-return", problem.title);
  TableWriter mechanism = given_writer(problem.given);
  mechanism.set_name("type", problem.type)
      .set_deg("swing_deg", problem.swing)
      .set("stroke", problem.stroke)
      .set("offset", problem.offset)
      .set("rod", problem.rod)
      .set("ram_height", problem.ram_height);
  if (problem.crank_pivot_line) {
    const auto& [a, b, c] = *problem.crank_pivot_line;
    mechanism.set("crank_pivot_line", std::array{a, b, c});
  }
  const bool four_bar = problem.type == QuickReturnType::four_bar;
  TableWriter constraints = four_bar ? constraints_writer(problem.constraints) : TableWriter{};
  constraints.set_deg("pressure_angle_deg_max", problem.pressure_angle_max);
  document.add("target", node(TableWriter{}.set("time_ratio", problem.time_ratio)))
      .add("mechanism", node(mechanism));
  if (four_bar) document.add("bounds", node(bounds_writer(problem.bounds)));
  document.add("constraints", node(constraints)).add("solve", node(solve_writer(problem.solve)));
  return {document.take(), {}};
}

tl::expected<QuickReturnProblem, std::vector<std::string>> checked(
    const QuickReturnProblem& problem) {
  const auto read = read_back<QuickReturnProblem>(written(problem));
  if (!read) return tl::unexpected(read.error());
  return problem;
}

}  // namespace
}  // namespace reading

tl::expected<QuickReturnProblem, std::vector<std::string>> KindTraits<QuickReturnProblem>::checked(
    const QuickReturnProblem& problem) {
  return reading::checked(problem);
}

std::vector<std::string> validate(const QuickReturnProblem& problem) {
  return faults_of(reading::checked(problem));
}

}  // namespace cognate::problems
