/// A quick-return problem written down, and checked by reading what was written.
#include "problems/layers/read.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/quick_return/problem.hpp"
#include "problems/quick_return/read_raster.hpp"
#include "problems/raster/read.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {

reading::Written KindTraits<QuickReturnProblem>::written(const QuickReturnProblem& problem) {
  using namespace reading;
  TableWriter mechanism = given_writer(problem.given, to_string(problem.type));
  mechanism.set_deg("swing_deg", problem.swing)
      .set("stroke", problem.stroke)
      .set("offset", problem.offset)
      .set("rod", problem.rod)
      .set("ram_height", problem.ram_height);
  if (problem.crank_pivot_line) {
    const auto& [a, b, c] = *problem.crank_pivot_line;
    mechanism.set("crank_pivot_line", std::array{a, b, c});
  }
  if (problem.limit_angle) {
    const auto& [limit, angle] = *problem.limit_angle;
    mechanism.set_deg(limit_angle_key(limit), std::optional(angle));
  }
  const bool four_bar = problem.type == QuickReturnType::four_bar;
  TableWriter constraints = four_bar ? constraints_writer(problem.constraints) : TableWriter{};
  constraints.set_deg("pressure_angle_deg_max", problem.pressure_angle_max);
  write_design_layers(problem.layers, constraints);
  TableWriter document = document_writer(kWord, problem.title, problem.length_unit);
  document.set("target", TableWriter{}.set("time_ratio", problem.time_ratio))
      .set("mechanism", mechanism);
  if (four_bar) {
    document.set("bounds", bounds_writer(problem.bounds));
  } else if (problem.raster) {
    write_return_bounds(document, problem);
  }
  document.set("constraints", constraints)
      .set("solve", solve_writer(problem.solve))
      .set("warnings", warnings_writer(problem.warnings));
  const bool turns =
      problem.type == QuickReturnType::four_bar || problem.type == QuickReturnType::guide_bar;
  document.append(raster_table(problem.raster));
  document.append(layers_table(problem.layers)).append(tolerance_table(problem.tolerances, turns));
  return {document.take(), {}};
}

tl::expected<QuickReturnProblem, std::vector<std::string>> KindTraits<QuickReturnProblem>::checked(
    const QuickReturnProblem& problem) {
  return reading::read_back(problem).map([&](const auto&) { return problem; });
}

}  // namespace cognate::problems
