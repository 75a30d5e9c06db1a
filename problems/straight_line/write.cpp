/// A straight-line problem written down, and checked by reading what was written.
#include <cmath>

#include "problems/layers/read.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/raster/read.hpp"
#include "problems/straight_line/keys.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

/// The name of a value; empty where it is none.
template <class Enum, std::size_t Size>
std::string_view name_in(const std::array<std::string_view, Size>& names, Enum value) {
  const auto index = static_cast<std::size_t>(value);
  return index < Size ? names.at(index) : std::string_view{};
}

TableWriter slider_crank_writer(const Given& given, const std::optional<double>& offset,
                                const std::optional<double>& direction) {
  TableWriter table;
  return table.set("type", "slider-crank")
      .set("pivot", given.pivot_a)
      .set("crank", given.crank)
      .set("coupler", given.coupler)
      .set("offset", offset)
      .set_deg("direction_deg", direction)
      .set("coupler_point", given.coupler_point)
      .set_name("assembly", given.assembly);
}

/// What the ends say, length and direction, is left out where it is the same.
TableWriter goal_writer(StraightLineGoal goal) {
  constexpr double kSame = 1e-12;
  if (goal.ends && goal.length) {
    const double distance = norm(goal.ends->back() - goal.ends->front());
    if (std::abs(*goal.length - distance) <= kSame * distance) goal.length.reset();
  }
  TableWriter table;
  table.set("ends", goal.ends);
  return write_keys(goal, kGoalKeys, table);
}

TableWriter exact_mechanism(const StraightLineProblem& problem) {
  if (problem.slider) {
    return slider_crank_writer(problem.given, problem.slider->offset, problem.slider->direction)
        .set_deg("crank_deg", problem.crank_angle);
  }
  TableWriter table = given_writer(problem.given);
  table.set("cranks", name_in(kCrankArrangements, problem.cranks));
  if (problem.cranks == CrankArrangement::parallel) {
    table.set("sides", name_in(kCrankSides, problem.sides))
        .set_deg("coupler_angle_deg", problem.coupler_angle);
  }
  return table.set_deg("crank_deg", problem.crank_angle);
}

TableWriter searched_mechanism(const StraightLineProblem& problem) {
  if (problem.type != MechanismType::slider_crank) {
    return given_writer(problem.given, to_string(problem.type));
  }
  return slider_crank_writer(problem.given, problem.slider_offset, problem.given.frame_angle);
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<StraightLineProblem>::written(const StraightLineProblem& problem) {
  using namespace reading;
  TableWriter document = document_writer(kWord, problem.title, problem.length_unit);
  TableWriter constraints = constraints_writer(problem.constraints);
  write_design_layers(problem.layers, constraints);
  if (problem.goal) {
    write_keys(problem.segment, kSegmentKeys, constraints);
    document.set("target", goal_writer(*problem.goal))
        .set("mechanism", searched_mechanism(problem))
        .set("bounds", bounds_writer(problem.bounds))
        .set("constraints", constraints)
        .set("solve", solve_writer(problem.solve));
  } else {
    document.set("target", TableWriter{}.set("method", "exact").set("contact", problem.contact))
        .set("mechanism", exact_mechanism(problem))
        .set("constraints", constraints)
        .set("solve", TableWriter{}.set("designs", problem.solve.designs));
  }
  document.set("warnings", warnings_writer(problem.warnings));
  document.append(layers_table(problem.layers))
      .append(tolerance_table(problem.tolerances, false))
      .append(raster_table(problem.raster));
  return {document.take(), {}};
}

tl::expected<StraightLineProblem, std::vector<std::string>>
KindTraits<StraightLineProblem>::checked(const StraightLineProblem& problem) {
  return reading::read_back(problem).map([&](const auto&) { return problem; });
}

}  // namespace cognate::problems
