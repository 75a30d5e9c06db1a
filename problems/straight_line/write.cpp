/// A straight-line problem written down, and checked by reading what was written.
#include "problems/linkage/result.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/straight_line/problem.hpp"

namespace cognate::problems {
namespace reading {
namespace {

/// The name of a value; empty where it is none.
template <class Enum, std::size_t n>
std::string_view name_in(const std::array<std::string_view, n>& names, Enum value) {
  const auto index = static_cast<std::size_t>(value);
  return index < n ? names.at(index) : std::string_view{};
}

TableWriter slider_crank_writer(const StraightLineProblem& problem) {
  const Given& given = problem.given;
  TableWriter table;
  return table.set("type", "slider-crank")
      .set("pivot", given.pivot_a)
      .set("crank", given.crank)
      .set("coupler", given.coupler)
      .set("coupler_point", given.coupler_point)
      .set_name("assembly", given.assembly);
}

TableWriter exact_mechanism(const StraightLineProblem& problem) {
  if (problem.slider) {
    return slider_crank_writer(problem)
        .set("offset", problem.slider->offset)
        .set_deg("direction_deg", problem.slider->direction)
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
    return given_writer(problem.given).set_name("type", problem.type);
  }
  return slider_crank_writer(problem)
      .set("offset", problem.slider_offset)
      .set_deg("direction_deg", problem.given.frame_angle);
}

TableWriter goal_writer(const StraightLineGoal& goal) {
  TableWriter table;
  return table.set("length", goal.length)
      .set("deviation", goal.deviation)
      .set("deviation_relative", goal.deviation_relative)
      .set_deg("direction_deg", goal.direction);
}

Written written(const StraightLineProblem& problem) {
  TableWriter document = document_writer("straight-line", problem.title);
  TableWriter constraints = constraints_writer(problem.constraints);
  if (problem.goal) {
    constraints.set_deg("crank_range_deg", problem.segment.crank_range)
        .set("size_over_length_max", problem.segment.size_over_length_max)
        .set("speed_variation_max", problem.segment.speed_variation_max);
    document.add("target", node(goal_writer(*problem.goal)))
        .add("mechanism", node(searched_mechanism(problem)))
        .add("bounds", node(bounds_writer(problem.bounds)))
        .add("constraints", node(constraints))
        .add("solve", node(solve_writer(problem.solve)));
  } else {
    document
        .add("target", node(TableWriter{}.set("method", "exact").set("contact", problem.contact)))
        .add("mechanism", node(exact_mechanism(problem)))
        .add("constraints", node(constraints))
        .add("solve", node(TableWriter{}.set("designs", problem.solve.designs)));
  }
  return {document.take(), {}};
}

tl::expected<StraightLineProblem, std::vector<std::string>> checked(
    const StraightLineProblem& problem) {
  const auto read = read_back<StraightLineProblem>(written(problem));
  if (!read) return tl::unexpected(read.error());
  return problem;
}

}  // namespace
}  // namespace reading

tl::expected<StraightLineProblem, std::vector<std::string>>
KindTraits<StraightLineProblem>::checked(const StraightLineProblem& problem) {
  return reading::checked(problem);
}

std::vector<std::string> validate(const StraightLineProblem& problem) {
  return faults_of(reading::checked(problem));
}

}  // namespace cognate::problems
