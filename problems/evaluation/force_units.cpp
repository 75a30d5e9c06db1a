#include "problems/evaluation/force_units.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

#include "problems/basics/unit_notes.hpp"

namespace cognate::problems {
namespace {

constexpr std::string_view kTorque = "_N_m", kPlace = "_at";

/// Whether `name` is that of a torque, not of where one is.
bool is_torque(std::string_view name) {
  const auto unit = name.find(kTorque);
  return unit != std::string_view::npos && name.find(kPlace, unit) == std::string_view::npos;
}

/// The greatest distance of a named point from the origin of the moving body that carries it.
double longest_link(const NamedMechanism& mechanism) {
  double longest = 0;
  for (const NamedPoint& point : mechanism.points) {
    if (point.at.body != 0) longest = std::max(longest, norm(point.at.at));
  }
  return longest;
}

}  // namespace

AnalysisProblem in_newtons(AnalysisProblem problem, double metres) {
  for (Inertia& inertia : problem.inertias) {
    inertia.mass *= metres;
    inertia.moment /= metres;
  }
  for (LoadRule& load : problem.loads) load.torque /= metres;
  return problem;
}

void to_newton_metres(AnalysisResult& result, double metres) {
  if (metres == 1) return;
  for (Column& column : result.columns) {
    if (!is_torque(column.name)) continue;
    for (double& value : column.values) value *= metres;
  }
  for (Quantity& quantity : result.quantities) {
    auto* const value = std::get_if<double>(&quantity.value);
    if (value && is_torque(quantity.name)) *value *= metres;
  }
}

std::vector<std::string> unit_notes(const AnalysisProblem& problem,
                                    std::optional<LengthUnit> unit) {
  const bool weighs = !problem.loads.empty() || norm(problem.gravity) > 0 ||
                      std::ranges::any_of(problem.inertias, [](const Inertia& inertia) {
                        return inertia.mass > 0 || inertia.moment > 0;
                      });
  if (!weighs) return {};
  return unit_notes({unit, problem.gravity, longest_link(problem.mechanism)});
}

LoadRule in_joules(LoadRule rule, double metres) {
  rule.force = metres * rule.force;
  return rule;
}

AnalysisProblem in_joules(AnalysisProblem problem, double metres) {
  for (Inertia& inertia : problem.inertias) inertia.mass *= metres * metres;
  for (LoadRule& load : problem.loads) load = in_joules(load, metres);
  return problem;
}

}  // namespace cognate::problems
