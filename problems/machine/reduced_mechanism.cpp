#include "problems/machine/reduced_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "analysis/machine/reduction.hpp"

namespace cognate::problems {

ReducedMechanism::ReducedMechanism(const AnalysisProblem& problem,
                                   const std::vector<MachineLoad>& loads,
                                   const AssemblyRanges& assembly_ranges,
                                   const std::vector<Stroke>& strokes,
                                   const std::vector<LoadTravel>& travels)
    : motion_(problem.mechanism.mechanism, assembly_ranges),
      inertias_(problem.inertias),
      gravity_(problem.gravity),
      active_(problem.mechanism.mechanism, problem.loads, strokes) {
  const auto& mechanism = problem.mechanism.mechanism;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const std::size_t place = problem.loads.size() + i;
    const Stroke stroke = place < strokes.size() ? strokes[place] : Stroke{};
    functions_.push_back(
        {loads[i], travels[i], ActiveLoads(mechanism, {&loads[i].rule, 1}, {&stroke, 1})});
  }
}

machine::EquivalentInertia ReducedMechanism::move_to(double phi) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const AssemblyRanges& assembly_ranges = motion_.assembly_ranges();
  phi_ = phi;
  const double on_assembly_ranges =
      phi < assembly_ranges.start ? phi + (assembly_ranges.end - assembly_ranges.start) : phi;
  if (!motion_.move_to(std::min(on_assembly_ranges, assembly_ranges.end))) return {kNone, kNone};
  weights_ = machine::weight_torque(motion_.bodies(), inertias_, gravity_);
  const auto inertia = machine::equivalent_inertia(motion_.bodies(), inertias_);
  return std::isfinite(inertia.value) ? inertia : machine::EquivalentInertia{kNone, kNone};
}

double ReducedMechanism::value(const FunctionLoad& load, double omega, double time) const {
  if (!load.load.of_travel) return load.load.value.value(phi_, omega, time);
  return load.load.of_travel(phi_, omega, time, load.travel.travelled(motion_.bodies()),
                             load.travel.rate(motion_.bodies()) * omega);
}

double ReducedMechanism::torque(double omega, double time) {
  const auto bodies = motion_.bodies();
  double sum = weights_ + machine::load_torque(bodies, active_.at<2>(phi_, omega, bodies));
  for (FunctionLoad& load : functions_) {
    const std::span<const Load> active = load.active.at<2>(phi_, omega, bodies);
    if (!active.empty()) {
      sum += value(load, omega, time) * machine::load_torque(bodies, active);
    }
  }
  return sum;
}

}  // namespace cognate::problems
