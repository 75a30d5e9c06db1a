#include "problems/path/found.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/linkage/defects.hpp"
#include "problems/path/crank_sense.hpp"
#include "problems/path/ordered_model.hpp"
#include "synthesis/optimise/loss.hpp"
#include "synthesis/optimise/polish.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {
namespace {

/// A sum of squares, in sizes of the path, below which its last digits may be worth a polish:
/// points are then met to a hundred thousandth.
constexpr double kNearlyMet = 1e-10;

/// Two points of one long valley: their costs agree to so much of themselves, their variables to
/// this.
constexpr double kSameCost = 1e-5, kSameValley = 0.03;

/// How many designs in one valley go on beside those of other valleys: a third, within limits.
constexpr std::size_t kFewestOfOneValley = 2, kMostOfOneValley = 8;

/// Whether two points that do not meet the target lie in one valley.
bool share_valley(const PathMinimum& a, const PathMinimum& b) {
  const double one = a.solution.objective, other = b.solution.objective;
  return one > kMetExactly && other > kMetExactly &&
         std::abs(one - other) <= kSameCost * std::min(one, other);
}

bool is_same(const PathMinimum& a, const PathMinimum& b, double tolerance) {
  if (share_valley(a, b)) tolerance = kSameValley;
  if (a.assembly != b.assembly || a.clockwise != b.clockwise) return false;
  if (turns_fully(a.confined_to) != turns_fully(b.confined_to)) return false;
  for (std::size_t i = 0; i < a.solution.x.size(); ++i) {
    const double difference = std::abs(a.solution.x[i] - b.solution.x[i]);
    if (difference > tolerance * (1 + std::abs(a.solution.x[i]))) return false;
  }
  return true;
}

/// Whether the crank passes the points of a solution as the problem has it, within one range and
/// the limits of its transmission angle.
bool keeps_order(const PathProblem& problem, const PathModel& model,
                 const synthesis::Solution& solution) {
  if (solution.stop == synthesis::Stop::no_value) return true;
  const bool in_order = problem.order == PointOrder::cyclic && problem.constraints.no_order_defect;
  const std::vector<double> angles = model.crank_angles(solution.x);
  const FourBar linkage = model.linkage(solution.x);
  const Defects defects =
      find_defects(linkage, angles, in_order ? Sequence::one_sense : Sequence::any);
  if (defects.circuit || defects.order) return false;
  const bool free_sense = problem.crank_sense == CrankSense::either || !leaves_sense_open(problem);
  if (!free_sense && !check_sense(problem.crank_sense, angles).satisfied) return false;
  const auto limits = model.transmission_on_the_way();
  if (!limits) return true;
  const Metrics metrics = design_metrics(linkage, angles, {problem.order, false});
  return metrics.transmission_min >= limits->min - kCheckTolerance &&
         metrics.transmission_max <= limits->max + kCheckTolerance;
}

/// The problem without the demand that all points lie on one circuit, for a solver that takes no
/// constraints. The demand is checked where its solution ends.
PathProblem unsound(const PathProblem& problem) {
  PathProblem all = problem;
  all.constraints.no_circuit_defect = all.constraints.no_order_defect = false;
  return all;
}

/// Linkages whose Grashof excess is below so much of their perimeter are near a change point.
constexpr double kNearChangePoint = 3e-4;

bool is_near_change_point(const Lengths<double>& links) {
  const auto [least, greatest] =
      std::minmax({links.crank, links.coupler, links.rocker, links.frame});
  const double sum = links.crank + links.coupler + links.rocker + links.frame;
  return std::abs(2 * (least + greatest) - sum) <= kNearChangePoint * sum;
}

double violation(const PathModel& model, std::span<const double> x) {
  std::vector<double> values(model.constraint_count());
  model.constraints(x, values, {});
  double most = 0;
  for (const double value : values) most = std::max(most, -value);
  return most;
}

}  // namespace

bool is_better(const PathFound& found, const PathFound& other) {
  if (found.strays != other.strays) return other.strays;
  const synthesis::Solution &a = found.minimum.solution, &b = other.minimum.solution;
  const bool a_feasible = a.violation <= kPathFeasibility;
  const bool b_feasible = b.violation <= kPathFeasibility;
  if (a_feasible != b_feasible) return a_feasible;
  return a_feasible ? a.objective < b.objective : a.violation < b.violation;
}

bool costs_less(const PathFound& a, const PathFound& b) {
  if (a.strays != b.strays) return b.strays;
  return a.cost < b.cost;
}

bool PathRules::is_same(const PathFound& known, const PathFound& other, double tolerance) {
  return problems::is_same(known.minimum, other.minimum, tolerance);
}

void PathRules::keep(std::vector<PathFound>& sorted, std::size_t most) const {
  const std::size_t of_one = std::clamp(most / 3, kFewestOfOneValley, kMostOfOneValley);
  std::vector<bool> spared(sorted.size());
  std::size_t kept = 0;
  for (std::size_t i = 0, best = 0; i < sorted.size() && kept < most; ++i) {
    if (!lie_in_one_valley(sorted[best], sorted[i])) best = i;
    spared[i] = i - best < of_one;
    kept += spared[i];
  }
  for (std::size_t i = 0; i < sorted.size() && kept < most; ++i) {
    kept += !spared[i];
    spared[i] = true;
  }
  std::size_t next = 0;
  std::erase_if(sorted, [&](const PathFound&) { return !spared[next++]; });
}

double PathRules::value(const PathFound& found) {
  const synthesis::Solution& solution = found.minimum.solution;
  return solution.violation <= kPathFeasibility ? solution.objective
                                                : std::numeric_limits<double>::infinity();
}

synthesis::Solution minimise(const PathProblem& problem, PathFound& found, synthesis::Solver solver,
                             const synthesis::Options& options) {
  const PathModel sound = model_of(problem, found.minimum);
  const bool knows_limits = can_solve(solver, sound);
  const PathModel model = knows_limits ? sound : model_of(unsound(problem), found.minimum);
  const auto solve = [&](const synthesis::Model& of) {
    const Solve& asked = problem.solve;
    synthesis::Solution solution = solve_by_loss(solver, of, asked.loss, asked.loss_scale, 2,
                                                 found.minimum.solution.x, options);
    found.evaluations += solution.evaluations;
    found.gradients += solution.gradients;
    found.iterations += static_cast<std::uint64_t>(solution.iterations);
    return solution;
  };
  const bool places = assigns_places(problem);
  if (!places || !found.binds) {
    // Where no point is out of order all crank angles are variables: that is the same, and quicker.
    synthesis::Solution solution = solve(model);
    if (!knows_limits) solution.violation = violation(sound, solution.x);
    if (!places || keeps_order(problem, model, solution)) return solution;
    found.binds = true;
  }
  const auto in_order = [&](const PathModel& of) {
    const OrderedPathModel ordered(problem, of, found.minimum.clockwise);
    synthesis::Solution solution = solve(ordered);
    auto whole = ordered.whole(solution.x);
    if (!whole) solution.stop = synthesis::Stop::no_value;
    solution.x = whole ? std::move(whole->x) : found.minimum.solution.x;
    return solution;
  };
  synthesis::Solution solution = in_order(model);
  const Lengths<double> links = lengths(model.linkage(solution.x));
  // A crank that has become fully rotatable must keep its transmission angle over the turn. And a
  // curve may end at a change point: a descent towards it crawls unless it knows of the border.
  const bool turns = model.transmission_on_the_way() && crank_rotates(links);
  const auto side =
      turns || is_near_change_point(links) ? open_class(problem.constraints, links) : std::nullopt;
  if (!side || found.minimum.confined_to == side) return solution;
  const auto confined_to = std::exchange(found.minimum.confined_to, side);
  const PathModel confined = model_of(problem, found.minimum);
  if (turns) solution.violation = std::max(solution.violation, violation(confined, solution.x));
  const PathMinimum start = std::exchange(
      found.minimum,
      {found.minimum.assembly, found.minimum.clockwise, side, solution, found.minimum.from_exact});
  const auto improves = [&](const synthesis::Solution& along) {
    return along.stop != synthesis::Stop::no_value && along.violation <= kPathFeasibility &&
           (along.objective < solution.objective || solution.violation > kPathFeasibility);
  };
  synthesis::Solution along = in_order(knows_limits ? confined : model);
  if (improves(along)) return along;
  found.minimum = start;
  found.minimum.confined_to = confined_to;
  // Where the crank has become fully rotatable and violates the limits, the descent is repeated
  // within the class that it began in.
  const bool lost = turns && solution.violation > kPathFeasibility;
  const auto own =
      lost ? open_class(problem.constraints, lengths(model.linkage(start.solution.x))) : side;
  if (!knows_limits || !own || own == side || own == confined_to) return solution;
  found.minimum.confined_to = own;
  along = in_order(model_of(problem, found.minimum));
  if (improves(along)) return along;
  found.minimum.confined_to = confined_to;
  return solution;
}

void polish(const PathProblem& problem, PathFound& found, const synthesis::Options& options) {
  synthesis::Solution& solution = found.minimum.solution;
  const bool places = assigns_places(problem);
  const bool none_local = places || problem.timing == Timing::prescribed;
  if (problem.solve.loss != synthesis::Loss::none || !none_local) return;
  if (!(solution.objective < kNearlyMet) || solution.violation > kPathFeasibility) return;
  const PathModel model = model_of(problem, found.minimum);
  const OrderedPathModel ordered(problem, model, found.minimum.clockwise);
  std::vector<double> start(solution.x.begin(), solution.x.begin() + model.global_count());
  const synthesis::Model& polished = places ? static_cast<const synthesis::Model&>(ordered) : model;
  const synthesis::Solution end = synthesis::polish(polished, std::move(start), options);
  found.evaluations += end.evaluations;
  found.gradients += end.gradients;
  if (end.stop == synthesis::Stop::no_value || !(end.objective < solution.objective)) return;
  const auto whole = places ? ordered.whole(end.x) : std::nullopt;
  if (places && !whole) return;
  solution.x = places ? whole->x : end.x;
  solution.objective = end.objective;
  solution.violation = end.violation;
}

void place_in_order(const PathProblem& problem, PathFound& found) {
  if (!found.valid || !assigns_places(problem)) return;
  const PathModel model = model_of(problem, found.minimum);
  const bool open = leaves_sense_open(problem);
  std::optional<OrderedPathModel::Whole> best;
  for (const bool clockwise : {false, true}) {
    const CrankSense sense = clockwise ? CrankSense::cw : CrankSense::ccw;
    const bool allowed = problem.crank_sense == CrankSense::either || problem.crank_sense == sense;
    if (open ? !allowed : clockwise != found.minimum.clockwise) continue;
    const OrderedPathModel ordered(problem, model, clockwise);
    auto whole = ordered.whole(found.minimum.solution.x);
    if (!whole || (best && best->places.cost <= whole->places.cost)) continue;
    found.minimum.clockwise = clockwise;
    best = std::move(whole);
  }
  found.strays = !best;
  if (!best) return;
  synthesis::Solution& solution = found.minimum.solution;
  found.binds = best->places.any_held() && best->places.cost > kMetExactly;
  found.cost += best->places.cost - solution.objective;
  solution.objective = best->places.cost;
  solution.x = std::move(best->x);
}

void count_work(std::span<PathFound> all, std::size_t points, Work& work) {
  for (PathFound& found : all) {
    work.positions += std::exchange(found.evaluations, 0) * points;
    work.gradients += std::exchange(found.gradients, 0) * points;
    work.solver_iterations += std::exchange(found.iterations, 0);
  }
}

}  // namespace cognate::problems
