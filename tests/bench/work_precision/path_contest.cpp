#include <limits>

#include "problems/linkage/verify.hpp"
#include "problems/path/model.hpp"
#include "problems/path/scale.hpp"
#include "problems/path/starts.hpp"
#include "tests/bench/work_precision/contest.hpp"

namespace cognate::bench {
namespace {

using problems::PathModel;
using problems::PathProblem;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr std::size_t kCandidates = 256;  ///< as the search screens
constexpr double kReach = 5;              ///< in sizes of the path

double judged(const PathProblem& problem, const FourBar& linkage, std::span<const double> angles) {
  const auto metrics = problems::design_metrics(
      linkage, angles, {problem.order, problem.timing == problems::Timing::prescribed});
  const auto checks = problems::check_constraints(problem.constraints, problem.bounds,
                                                  problem.given, linkage, metrics);
  if (!problems::all_satisfied(checks)) return kNone;
  return problems::path_error(linkage, problem.points, angles).sum_of_squares;
}

/// The problem in both units, shared by all attempts.
struct Path {
  PathProblem own;
  problems::PathScale scale;
  PathProblem scaled;
  problems::PathStarts starts;

  explicit Path(const PathProblem& problem)
      : own(problem), scale(problem), scaled(scale.into(problem)), starts(scaled) {}
};

std::optional<Attempt> draw(const std::shared_ptr<const Path>& path, Starts how,
                            std::mt19937_64& random) {
  std::shared_ptr<const PathModel> model;
  std::optional<std::vector<double>> x;
  if (how == Starts::screened) {
    const auto start = path->starts.draw(random, kCandidates);
    if (!start) return std::nullopt;
    model = std::make_shared<PathModel>(path->scaled, start->linkage.assembly, start->clockwise);
    x = model->variables_of(start->linkage, start->crank_angles);
  } else {
    const Assembly assembly = random() % 2 == 0 ? Assembly::open : Assembly::crossed;
    model = std::make_shared<PathModel>(path->scaled, assembly, random() % 2 == 0);
    x = random_point(*model, kReach, random);
    if (!x) return std::nullopt;
  }
  const auto error = [path, model](std::span<const double> at) {
    return judged(path->own, path->scale.out_of(model->linkage(at)), model->crank_angles(at));
  };
  return Attempt{model, std::move(*x), error};
}

}  // namespace

Contest path_contest(const PathProblem& problem, std::string name) {
  const auto path = std::make_shared<const Path>(problem);
  const bool timed = problem.timing == problems::Timing::prescribed;
  Contest contest;
  contest.name = std::move(name);
  contest.kind = timed ? "path, timed" : "path";
  contest.unit = path->scale.size * path->scale.size * double(problem.points.size());
  contest.begin = [path](Starts how) -> Draw {
    return [path, how](std::mt19937_64& random) { return draw(path, how, random); };
  };
  contest.solve = [problem](int starts, const problems::Run& run) {
    PathProblem asked = problem;
    asked.solve.starts = starts;
    const auto result = solve(asked, run);
    if (result.status != problems::Status::solved) return kNone;
    return result.designs.front().error.sum_of_squares;
  };
  return contest;
}

}  // namespace cognate::bench
