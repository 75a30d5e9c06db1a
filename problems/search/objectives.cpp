#include "problems/search/objectives.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/verify.hpp"
#include "synthesis/search/pareto_front.hpp"

namespace cognate::problems {
namespace {

using synthesis::FrontDesign;
using synthesis::FrontPoint;

void add_work(const Work& done, Work& work) {
  work.candidates += done.candidates;
  work.positions += done.positions;
  work.velocities += done.velocities;
  work.accelerations += done.accelerations;
  work.gradients += done.gradients;
  work.solver_iterations += done.solver_iterations;
}

/// The designs of a front behind their numbers.
class FrontDesigns {
 public:
  FrontDesigns(const ObjectiveTask& task, const Deadline& deadline)
      : task_(task), rule_(rule_of(task.measure)), deadline_(deadline) {}

  synthesis::FrontProblem problem() {
    return {synthesis::measure_of_values(rule_.greatest_is_best, rule_.best), task_.met,
            [this](std::optional<double> bound, const std::vector<std::size_t>& known,
                   std::optional<std::uint64_t> seed) { return solve(bound, known, seed); }};
  }

  const Design& operator[](const FrontDesign& design) const { return all_[design.number]; }
  /// What the first search gave.
  Result first() && { return std::move(*first_); }
  const Work& work() const { return work_; }

 private:
  std::optional<std::vector<FrontDesign>> solve(std::optional<double> bound,
                                                const std::vector<std::size_t>& known,
                                                std::optional<std::uint64_t> seed) {
    DesignLimits limits = task_.limits;
    if (bound && !rule_.limit(limits, *bound)) return std::nullopt;
    std::vector<Design> begun;
    for (const std::size_t one : known) begun.push_back(all_[one]);
    Result found = task_.solve(limits, begun, seed);
    add_work(found.work, work_);
    const bool is_first = !first_;
    if (is_first) first_ = found;
    // The first is of use even where the time has ended.
    const bool sound =
        is_first ? !found.designs.empty() && all_satisfied(found.designs.front().constraints)
                 : !deadline_.reached() && found.status == Status::solved;
    std::vector<FrontDesign> designs;
    if (!sound) return designs;
    for (Design& design : found.designs) {
      designs.push_back({all_.size(), rule_.value(design), task_.error_of(design)});
      all_.push_back(std::move(design));
    }
    return designs;
  }

  const ObjectiveTask& task_;
  const ObjectiveRule& rule_;
  const Deadline& deadline_;
  Work work_;
  std::optional<Result> first_;
  std::vector<Design> all_;
};

/// Puts the points of a search into a result, with their tables and what is to be said of them.
class FrontReport {
 public:
  FrontReport(const ObjectiveTask& task, const FrontDesigns& designs)
      : task_(task), rule_(rule_of(task.measure)), designs_(designs) {}

  Design design_of(const FrontPoint& point) const { return design_of(designs_[point.design()]); }

  Design design_of(Design design) const {
    if (rule_.is_quantity) {
      design.metrics.quantities.push_back(
          {std::string(rule_.column), rule_.shown(rule_.value(design))});
    }
    check_own_limits(design);
    if (task_.limit) check_error(*task_.limit, task_.error_of(design), design);
    return design;
  }

  Family family(const std::vector<FrontPoint>& points) const {
    Family family{"Pareto front",
                  {{std::string(rule_.column), {}}, {error_column(task_.error), {}}}};
    for (const FrontPoint& point : points) {
      family.columns[0].values.push_back(measure(point));
      family.columns[1].values.push_back(error(point));
    }
    return family;
  }

  /// With the unit of an angle.
  std::string measured(const FrontPoint& point) const {
    const bool is_angle = rule_.column.find("_deg") != std::string_view::npos;
    return fmt::format("{:.7g}{}", measure(point), is_angle ? " degrees" : "");
  }

  std::string beginning(const FrontPoint& first) const {
    return fmt::format(
        "The front begins where {} is {}: up to there the target is met to rounding.", words(),
        measured(first));
  }

  std::string end(const std::vector<FrontPoint>& points, bool by_error) const {
    const FrontPoint& last = points.back();
    if (points.size() == 1) {
      return fmt::format("One design is best in both: {} is {}, the error {:.7g}.", words(),
                         measured(last), error(last));
    }
    const std::string at = fmt::format("The front ends where {} is {} and the error {:.7g}",
                                       words(), measured(last), error(last));
    if (task_.limit && by_error) {
      return fmt::format("{}: beyond it the error exceeds {}.", at, limit_words());
    }
    return at +
           ": beyond it, but for a millionth of the way, no design was found that meets every "
           "constraint.";
  }

  std::string best(const FrontPoint& point) const {
    return fmt::format(
        "The design is the one of best measure found within {}: {} is {}, the error {:.7g}.",
        limit_words(), words(), measured(point), error(point));
  }

 private:
  /// Checks the limits of the file in place of those that the search has narrowed.
  void check_own_limits(Design& design) const {
    const auto checks = [&](const DesignLimits& limits) {
      return check_constraints(limits.constraints, limits.bounds, {}, four_bar(design),
                               design.metrics);
    };
    DesignLimits narrowed = task_.limits;
    rule_.limit(narrowed, rule_.value(design));
    const auto own = checks(task_.limits), searched = checks(narrowed);
    std::vector<ConstraintCheck> kept;
    for (const ConstraintCheck& check : design.constraints) {
      const auto same = std::ranges::find(own, check.name, &ConstraintCheck::name);
      if (same != own.end()) {
        kept.push_back(*same);
      } else if (std::ranges::count(searched, check.name, &ConstraintCheck::name) == 0) {
        kept.push_back(check);
      }
    }
    design.constraints = std::move(kept);
  }

  double measure(const FrontPoint& point) const { return rule_.shown(point.design().value); }

  double error(const FrontPoint& point) const {
    return shown_error(task_.error, point.design().error);
  }

  std::string words() const { return std::string(rule_.words); }

  std::string limit_words() const {
    return fmt::format("{} = {:.7g}", to_string(task_.limit->of),
                       shown_error(task_.limit->of, task_.limit->max));
  }

  const ObjectiveTask& task_;
  const ObjectiveRule& rule_;
  const FrontDesigns& designs_;
};

Status status(const Deadline& deadline) {
  if (deadline.interrupted()) return Status::interrupted;
  return deadline.reached() ? Status::time_limit : Status::solved;
}

/// The first search, where there is nothing to go on from: as it stands, the bound on the error
/// being one of the constraints.
Result without_front(Result first, const FrontReport& report, const ObjectiveTask& task) {
  for (Design& design : first.designs) design = report.design_of(design);
  const auto wanted = static_cast<std::size_t>(task.designs);
  if (first.designs.size() > wanted) first.designs.resize(wanted);
  if (first.status == Status::solved && task.limit) first.status = Status::infeasible;
  return first;
}

}  // namespace

std::optional<DesignObjective> measure_of(const Solve& solve) {
  for (const DesignObjective measure : solve.objectives) {
    if (measure != DesignObjective::error) return measure;
  }
  return std::nullopt;
}

Result solve_front(const ObjectiveTask& task, const Run& run, const Deadline& deadline) {
  run.enter(Phase::front, kUnknownEnd);
  FrontDesigns designs(task, deadline);
  const FrontReport report(task, designs);
  const synthesis::FrontProblem problem = designs.problem();
  synthesis::FrontSearch search(problem, {run.seed, deadline, run.progress});
  const double most = task.limit ? task.limit->max * (1 + kCheckTolerance) : kInfinity;
  search.begin();
  if (search.points().empty() || search.points().front().error > most) {
    return without_front(std::move(designs).first(), report, task);
  }
  FrontPoint last = search.points().front();
  const bool is_met = last.error == 0;
  using synthesis::LastPoint;
  const auto end = task.with_error ? LastPoint::before_an_upright_end : LastPoint::greatest_level;
  if (task.with_error && is_met) last = search.go_to(0, end);
  last = search.go_to(most, end);
  if (task.with_error) search.fill(task.designs);
  const auto& points = search.points();
  Result result;
  result.work = designs.work();
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
  result.quantities = {{"problems_solved", static_cast<double>(search.searches())}};
  return result;
}

}  // namespace cognate::problems
