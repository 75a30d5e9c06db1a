#include "problems/guidance/found.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "problems/guidance/design.hpp"
#include "problems/guidance/dyads.hpp"

namespace cognate::problems {
namespace {

bool is_close(const MotionMinimum& a, const MotionMinimum& b, double tolerance) {
  if (a.form.second != b.form.second || a.form.confined_to != b.form.confined_to) return false;
  if (a.form.sides != b.form.sides || a.form.stations != b.form.stations) return false;
  if (a.form.ends != b.form.ends || a.form.held != b.form.held) return false;
  if (a.form.closes_towards != b.form.closes_towards || a.form.closes_away != b.form.closes_away) {
    return false;
  }
  for (std::size_t i = 0; i < a.solution.x.size(); ++i) {
    const double difference = std::abs(a.solution.x[i] - b.solution.x[i]);
    if (difference > tolerance * (1 + std::abs(a.solution.x[i]))) return false;
  }
  return true;
}

}  // namespace

MotionMinimum begun(const MotionProblem& problem, const MotionStart& start) {
  MotionMinimum minimum{form_of(problem, start.pair), start.origin, {}};
  minimum.solution.x = MotionModel(problem, minimum.form).variables_of(start.pair);
  return minimum;
}

double design_violation(const MotionProblem& problem, const MotionMinimum& minimum) {
  const MotionModel model(problem, minimum.form);
  const auto reached = model.reached(minimum.solution.x);
  if (reached.empty()) return std::numeric_limits<double>::infinity();
  const DyadPair pair = model.pair(minimum.solution.x);
  double least = std::numeric_limits<double>::infinity();
  if (const auto judged = judge(problem, pair, reached)) least = judged->violation;
  if (least > 0 && pair.second.kind == synthesis::DyadKind::rr && roles_are_alike(problem)) {
    const auto judged = judge(problem, {pair.second, pair.first}, reached);
    if (judged) least = std::min(least, judged->violation);
  }
  return least;
}

bool is_better(const MotionMinimum& a, const MotionMinimum& b) {
  const bool a_feasible = a.solution.violation <= kMotionFeasibility;
  const bool b_feasible = b.solution.violation <= kMotionFeasibility;
  if (a_feasible != b_feasible) return a_feasible;
  if (!a_feasible) return a.solution.violation < b.solution.violation;
  return a.solution.objective < b.solution.objective;
}

bool is_worse(const MotionFound& refined, const MotionFound& before) {
  const bool sound = refined.violation == 0, was_sound = before.violation == 0;
  return sound != was_sound ? was_sound : is_better(before.minimum, refined.minimum);
}

bool MotionRules::precedes(const MotionFound& a, const MotionFound& b) {
  const bool a_sound = a.violation == 0, b_sound = b.violation == 0;
  return a_sound != b_sound ? a_sound : is_better(a.minimum, b.minimum);
}

bool MotionRules::is_same(const MotionFound& known, const MotionFound& other, double tolerance) {
  return is_close(known.minimum, other.minimum, tolerance);
}

double MotionRules::value(const MotionFound& found) {
  return found.violation > 0 ? std::numeric_limits<double>::infinity()
                             : found.minimum.solution.objective;
}

void MotionRules::keep(std::vector<MotionFound>& all, std::size_t most) {
  const auto sound =
      static_cast<std::size_t>(std::ranges::count(all, 0.0, &MotionFound::violation));
  const std::size_t unsound =
      std::max(std::min(most / 3, all.size() - sound), most - std::min(most, sound));
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(most - unsound);
  all.erase(begin, all.begin() + static_cast<std::ptrdiff_t>(sound));
  all.resize(most);
}

}  // namespace cognate::problems
