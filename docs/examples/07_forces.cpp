// What a slider-crank needs to be driven against a force on its slider.
#include <algorithm>
#include <cognate/evaluation.hpp>
#include <cognate/units.hpp>
#include <cstdio>

using namespace cognate::literals;
namespace problems = cognate::problems;

int main() {
  problems::AnalysisProblem problem;
  problem.mechanism = problems::named(cognate::SliderCrank{.crank = 3, .coupler = 5});
  problem.drive = {.start = 90_deg, .end = 180_deg, .steps = 1};
  problem.output.torque = true;
  const auto body = std::ranges::find(problem.mechanism.bodies, "slider");
  problems::LoadRule load;
  load.at.body = static_cast<int>(body - problem.mechanism.bodies.begin());
  load.force = {10, 0};
  problem.loads.push_back(load);

  const problems::AnalysisResult result = analyse(problem, {});
  // Upright, the crank moves the slider by -3 for each radian: 10 N want a torque of 30 N m.
  const auto torque = std::ranges::find(result.columns, "torque_N_m", &problems::Column::name);
  std::printf("%s: %.3f N m\n", problems::to_string(result.status).data(), torque->values.front());
}

// solved: 30.000 N m
