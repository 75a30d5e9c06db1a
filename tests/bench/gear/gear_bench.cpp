/// Prints, as markdown, run time against error of what gears are computed and found with, each
/// beside the plain way in the same run: the involute and its inverse beside tangents and Newton's
/// method, the search over profile shifts beside grids, the cheap tests and stages of enumeration
/// beside a fine search of every choice of teeth.
///
/// Methods take turns, several times over; the least time of each counts.
#include <fmt/core.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "analysis/gear/involute.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/gear/pair_search.hpp"
#include "problems/gear/result.hpp"

namespace cognate::bench {
namespace {

using namespace problems;
using Quad = boost::multiprecision::cpp_bin_float_quad;

struct Method {
  std::string name;
  std::function<double()> error;
};

void print(const std::string& title, const std::vector<Method>& methods, int rounds) {
  std::vector<double> seconds(methods.size(), std::numeric_limits<double>::infinity());
  std::vector<double> errors(methods.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const auto begin = std::chrono::steady_clock::now();
      errors[i] = methods[i].error();
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
      seconds[i] = std::min(seconds[i], spent.count());
    }
  }
  fmt::print("\n{}\n\n| method | ms | times the first | error |\n|---|---|---|---|\n", title);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    fmt::print("| {} | {:.3f} | {:.2f} | {:.1e} |\n", methods[i].name, 1e3 * seconds[i],
               seconds[i] / seconds[0], errors[i]);
  }
}

/// A function over all arguments, its results kept for a look at their errors afterwards.
class Sampled {
 public:
  Sampled(std::vector<double> arguments, std::vector<Quad> right)
      : arguments_(std::move(arguments)), right_(std::move(right)), results_(arguments_.size()) {}

  template <class Function>
  void compute(Function&& f) {
    for (std::size_t i = 0; i < arguments_.size(); ++i) results_[i] = f(arguments_[i]);
  }

  /// The greatest relative error of what was computed last.
  double error() const {
    double worst = 0;
    for (std::size_t i = 0; i < results_.size(); ++i) {
      worst = std::max(worst, static_cast<double>(abs(results_[i] / right_[i] - 1)));
    }
    return worst;
  }

 private:
  std::vector<double> arguments_;
  std::vector<Quad> right_;
  std::vector<double> results_;
};

/// Errors are taken once, outside the time.
template <class Function>
Method timed(std::string name, Sampled& sampled, Function f, double& error) {
  sampled.compute(f);
  error = sampled.error();
  return {std::move(name), [&sampled, &error, f] {
            sampled.compute(f);
            return error;
          }};
}

double by_tangent(double angle) {
  return std::tan(angle) - angle;
}

/// Newton's method from ∛(3 inv), as textbooks have it.
double by_newton(double value) {
  double angle = std::min(std::cbrt(3 * value), 1.4);
  for (int i = 0; i < 50; ++i) {
    const double tangent = std::tan(angle);
    const double step = (tangent - angle - value) / (tangent * tangent);
    angle -= step;
    if (std::abs(step) <= 1e-15 * angle) break;
  }
  return angle;
}

void print_involutes() {
  constexpr int kCount = 100000;
  std::vector<double> angles, values;
  std::vector<Quad> involutes, right_angles;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 1e-3 * std::pow(1400.0, (i + 0.5) / kCount);
    const Quad exact = tan(Quad(angle)) - angle;
    angles.push_back(angle);
    involutes.push_back(exact);
    values.push_back(static_cast<double>(exact));
    // One step of Newton's method from what the value was rounded from.
    const Quad tangent = tan(Quad(angle));
    right_angles.push_back(angle - (exact - values.back()) / (tangent * tangent));
  }
  Sampled forward(angles, involutes), backward(values, right_angles);
  double errors[4];
  print("inv α of 100 000 angles from 0.001 to 1.4, error relative",
        {timed("involute", forward, gear::involute, errors[0]),
         timed("tan α − α", forward, by_tangent, errors[1])},
        9);
  print("α of 100 000 involutes, error relative",
        {timed("involute_angle", backward, gear::involute_angle, errors[2]),
         timed("Newton's method", backward, by_newton, errors[3])},
        9);
}

/// 14 and 43 teeth between axes 87 apart, whose shifts are to slide alike.
GearPairProblem balanced_pair() {
  GearPairProblem problem;
  problem.rack.pressure_angle = kPi / 9;
  problem.teeth = {14, 43};
  problem.module = 3;
  problem.centre_distance = 87;
  problem.backlash = 0.1;
  problem.constraints.contact_ratio_min = 1.2;
  problem.constraints.tip_thickness_min = 0.3;
  return problem;
}

/// The least objective over equal steps of the pinion's shift.
double by_grid(const GearPairProblem& problem, int steps) {
  const GearPairSearch search(problem, {{14, 43}, 3});
  const auto& [least, greatest] = problem.profile_shift_bounds;
  const double sum = search.best(SearchDepth::rough)->numbers.shift[0] +
                     search.best(SearchDepth::rough)->numbers.shift[1];
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const double first = least + (greatest - least) * i / steps;
    const PairDesign found =
        search.at(first, sum - first, *problem.centre_distance, best, SearchDepth::fine);
    if (found.violation == 0) best = std::min(best, found.objective);
  }
  return best;
}

void print_search() {
  const GearPairProblem problem = balanced_pair();
  const GearPairSearch search(problem, {{14, 43}, 3});
  const double found = search.best(SearchDepth::fine)->objective;
  std::vector<Method> methods{
      {"search", [&] { return search.best(SearchDepth::fine)->objective / found - 1; }}};
  for (const int steps : {100, 1000, 10000, 100000}) {
    methods.push_back({fmt::format("grid of {} shifts", steps),
                       [&, steps] { return by_grid(problem, steps) / found - 1; }});
  }
  print("Shifts of 14/43 teeth that slide least, sliding over that of the search less 1", methods,
        5);
}

GearPairProblem enumerated(bool at_distance) {
  GearPairProblem problem;
  problem.rack.pressure_angle = kPi / 9;
  problem.constraints.contact_ratio_min = 1.3;
  problem.solve.designs = 1;
  if (at_distance) {
    problem.teeth_bounds = {{{15, 40}, {40, 140}}};
    problem.modules = {1.5, 2, 2.5, 3};
    problem.centre_distance = 112.5;
    problem.ratio = 3.55;
    problem.ratio_tolerance = 0.01;
  } else {
    problem.teeth_bounds = {{{12, 30}, {20, 60}}};
    problem.modules = {2};
  }
  return problem;
}

/// A fine search of every choice of teeth and module; whose best meets the ratio.
double every_choice(const GearPairProblem& problem) {
  double best = std::numeric_limits<double>::infinity();
  for (int first = problem.teeth_bounds[0][0]; first <= problem.teeth_bounds[0][1]; ++first) {
    for (int second = problem.teeth_bounds[1][0]; second <= problem.teeth_bounds[1][1]; ++second) {
      for (const double module : problem.modules) {
        const auto found =
            GearPairSearch(problem, {{first, second}, module}).best(SearchDepth::fine);
        if (found && found->violation == 0) best = std::min(best, found->objective);
      }
    }
  }
  return best;
}

void print_enumeration(const std::string& title, const GearPairProblem& problem, int rounds) {
  const auto by_stages = [&] {
    const auto& design = solve(problem, {.threads = 1}).designs.at(0);
    return GearPairSearch(problem, {{*design.settled.teeth[0], *design.settled.teeth[1]},
                                    *design.settled.module})
        .best(SearchDepth::fine)
        ->objective;
  };
  const double least = every_choice(problem);
  print(title + ", objective over the least less 1",
        {{"solve, one thread", [&] { return by_stages() / least - 1; }},
         {"a fine search of every choice", [&] { return every_choice(problem) / least - 1; }}},
        rounds);
}

}  // namespace
}  // namespace cognate::bench

int main() {
  using namespace cognate::bench;
  print_involutes();
  print_search();
  print_enumeration("10 504 choices of teeth and module at a given distance and ratio",
                    enumerated(true), 3);
  print_enumeration("779 choices of teeth, distance free", enumerated(false), 1);
}
