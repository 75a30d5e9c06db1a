#include "problems/search/objectives.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

/// Puts the points of a search into a result, with their tables and what is to be said of them.
class FrontReport {
 public:
  FrontReport(const FrontProblem& problem, const ObjectiveTask& task)
      : problem_(problem), task_(task) {}

  Design design_of(const FrontPoint& point) const {
    Design design = point.design();
    const MeasureRule& rule = problem_.rule;
    if (rule.is_fact) {
      design.metrics.facts.push_back({std::string(rule.column), rule.shown(rule.value(design))});
    }
    if (task_.limit) check_error(*task_.limit, problem_.error(design), design);
    return design;
  }

  Family family(const std::vector<FrontPoint>& points) const {
    Family family{"Pareto front",
                  {{std::string(problem_.rule.column), {}}, {error_column(task_.error), {}}}};
    for (const FrontPoint& point : points) {
      family.columns[0].values.push_back(measure(point));
      family.columns[1].values.push_back(error(point));
    }
    return family;
  }

  std::string beginning(const FrontPoint& first) const {
    return fmt::format(
        "The front begins where {} is {:.7g}: up to there the target is met to rounding.", words(),
        measure(first));
  }

  std::string end(const std::vector<FrontPoint>& points, bool by_error) const {
    const FrontPoint& last = points.back();
    if (points.size() == 1) {
      return fmt::format("One design is best in both: {} is {:.7g}, the error {:.7g}.", words(),
                         measure(last), error(last));
    }
    const std::string at = fmt::format("The front ends where {} is {:.7g} and the error {:.7g}",
                                       words(), measure(last), error(last));
    if (task_.limit && by_error) {
      return fmt::format("{}: beyond it the error exceeds {}.", at, limit_words());
    }
    return at +
           ": beyond it, but for a millionth of the way, no design was found that meets every "
           "constraint.";
  }

  std::string best(const FrontPoint& point) const {
    return fmt::format(
        "The design is the one of best measure found within {}: {} is {:.9g}, the error {:.7g}.",
        limit_words(), words(), measure(point), error(point));
  }

 private:
  double measure(const FrontPoint& point) const {
    return problem_.rule.shown(problem_.rule.value(point.design()));
  }

  double error(const FrontPoint& point) const {
    return shown_error(task_.error, problem_.error(point.design()));
  }

  std::string words() const { return std::string(problem_.rule.words); }

  std::string limit_words() const {
    return fmt::format("{} = {:.7g}", to_string(task_.limit->of),
                       shown_error(task_.limit->of, task_.limit->max));
  }

  const FrontProblem& problem_;
  const ObjectiveTask& task_;
};

Status status(const Deadline& deadline) {
  if (deadline.interrupted()) return Status::interrupted;
  return deadline.reached() ? Status::time_limit : Status::solved;
}

/// The first search, where there is nothing to go on from: as it stands, the bound on the error
/// being one of the constraints.
Result without_front(Result first, const FrontReport& report, const ObjectiveTask& task) {
  for (Design& design : first.designs) design = report.design_of({.minima = {design}});
  const auto wanted = static_cast<std::size_t>(task.designs);
  if (first.designs.size() > wanted) first.designs.resize(wanted);
  if (first.status == Status::solved && task.limit) first.status = Status::infeasible;
  return first;
}

}  // namespace

std::optional<Measure> measure_of(const Solve& solve) {
  for (const Measure measure : solve.objectives) {
    if (measure != Measure::error) return measure;
  }
  return std::nullopt;
}

Result solve_front(const FrontProblem& problem, const ObjectiveTask& task, const Run& run,
                   const Deadline& deadline) {
  const FrontReport report(problem, task);
  Result result;
  FrontSearch search(problem, run, deadline, result.work);
  const double most = task.limit ? task.limit->max * (1 + kCheckTolerance) : kInfinity;
  Result first = search.begin();
  if (search.points().empty() || search.points().front().error > most) {
    return without_front(std::move(first), report, task);
  }
  FrontPoint last = search.points().front();
  const bool is_met = last.error == 0;
  const auto end = task.with_error ? LastPoint::before_an_upright_end : LastPoint::greatest_level;
  if (task.with_error && is_met) last = search.go_to(0, end);
  last = search.go_to(most, end);
  if (task.with_error) search.fill(task.designs);
  const auto& points = search.points();
  result.status = status(deadline);
  if (task.with_error) {
    for (const FrontPoint& point : points) result.designs.push_back(report.design_of(point));
    result.families = {report.family(points)};
    if (result.status == Status::solved) {
      if (is_met) result.notes.push_back(report.beginning(points.front()));
      result.notes.push_back(report.end(points, search.ended_by_error()));
    }
  } else {
    result.designs = {report.design_of(last)};
    if (result.status == Status::solved) result.notes.push_back(report.best(last));
  }
  result.facts = {{"problems_solved", static_cast<double>(search.searches())}};
  return result;
}

}  // namespace cognate::problems
