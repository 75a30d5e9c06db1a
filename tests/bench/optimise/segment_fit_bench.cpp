/// Prints, as a Markdown table, how solvers bring starts of a search for straight lines to their
/// minima: the largest distance at 33 nodes, under limits of class, transmission and size.
/// `reached` counts starts that end within 1 % of the best that any solver reaches from the same
/// start; `time` is that of Gauss-Newton without curvature times the number, one thread, in this
/// run. Usage: segment_fit_bench [STARTS].
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/straight_line/model.hpp"
#include "problems/straight_line/starts.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {
namespace {

using synthesis::Solver;

constexpr int kCells = 32, kIterations = 300;
constexpr double kTolerance = 1e-9, kFeasible = 1e-8, kNear = 1.01;

struct Way {
  const char* name;
  Solver solver;
  bool learns = false;
  double seconds = 0;
  int reached = 0;
};

StraightLineProblem problem_of(RequiredClass required) {
  StraightLineProblem problem;
  problem.goal.emplace();
  problem.goal->length = 1;
  problem.constraints.required_class = required;
  problem.constraints.transmission_angle = Range{kPi / 6, 5 * kPi / 6};
  problem.constraints.link_ratio_max = 10;
  problem.segment.size_over_length_max = 2.5;
  return problem;
}

/// The largest distance that `way` reaches from `start`; infinite outside the limits.
double fit(const StraightLineProblem& problem, const LinkageSegment& start, Way& way) {
  const SegmentModel model(problem, start, segment_nodes(kCells));
  const std::vector<double> x = model.variables_of(start);
  const std::clock_t begin = std::clock();
  const auto solution = synthesis::solve(way.solver, model, x,
                                         {.tolerance = kTolerance,
                                          .feasibility = kFeasible,
                                          .max_iterations = kIterations,
                                          .learns_curvature = way.learns});
  way.seconds += double(std::clock() - begin) / CLOCKS_PER_SEC;
  const bool is_sound =
      solution.stop != synthesis::Stop::no_value && solution.violation <= kFeasible;
  return is_sound ? solution.objective : kInfinity;
}

int compare(const StraightLineProblem& problem, int starts, std::array<Way, 4>& ways) {
  SegmentStarts drawn(problem);
  int compared = 0;
  for (std::uint64_t index = 0; compared < starts; ++index) {
    const auto start = drawn.draw(1, index);
    if (!start) continue;
    std::array<double, 4> ends{};
    for (std::size_t i = 0; i < ways.size(); ++i) ends[i] = fit(problem, start->segment, ways[i]);
    const double best = std::ranges::min(ends);
    if (best == kInfinity) continue;
    for (std::size_t i = 0; i < ways.size(); ++i) ways[i].reached += ends[i] <= kNear * best;
    ++compared;
  }
  return compared;
}

}  // namespace
}  // namespace cognate::problems

int main(int count, char** words) {
  using namespace cognate::problems;
  const int starts = count > 1 ? std::max(1, std::atoi(words[1])) : 100;
  std::array<Way, 4> ways{Way{"Gauss-Newton", Solver::gauss_newton},
                          Way{"Gauss-Newton, curvature learnt", Solver::gauss_newton, true},
                          Way{"SLSQP", Solver::slsqp}, Way{"Ipopt", Solver::ipopt}};
  int compared = 0;
  for (const RequiredClass required :
       {RequiredClass::crank_rocker, RequiredClass::double_rocker, RequiredClass::triple_rocker}) {
    compared += compare(problem_of(required), starts, ways);
  }
  fmt::print("| solver | reached | time |\n|---|---|---|\n");
  for (const Way& way : ways) {
    fmt::print("| {} | {} of {} | {:.2f} |\n", way.name, way.reached, compared,
               way.seconds / ways[0].seconds);
  }
}
