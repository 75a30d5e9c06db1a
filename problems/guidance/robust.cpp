#include "problems/guidance/robust.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/guidance/designs.hpp"
#include "problems/guidance/dimensions.hpp"
#include "problems/guidance/placed_motion.hpp"
#include "problems/guidance/scale.hpp"
#include "problems/guidance/toleranced_model.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/search/robust.hpp"

namespace cognate::problems {
namespace {

using namespace motion_dimensions;
using synthesis::Pose;

/// Designs from which robust ones are sought, of each search.
constexpr int kRobustStarts = 6;

constexpr std::array<std::string_view, TolerancedMotionModel::changes> kChangeNames{
    "crank", "coupler", "rocker", "frame", "coupler_point.u", "coupler_point.v"};

/// One search of a problem, and the same in the units of the model, nothing given.
struct MotionDrive {
  explicit MotionDrive(MotionProblem own)
      : problem(std::move(own)), scale(problem), open(scale.into(problem)) {
    open.fixed_pivots.clear();
    open.moving_pivots.clear();
    open.crank.reset();
    open.rocker.reset();
  }
  MotionDrive(const MotionDrive&) = delete;
  MotionDrive& operator=(const MotionDrive&) = delete;

  MotionProblem problem;
  MotionScale scale;  ///< refers to `problem`
  MotionProblem open;
};

std::vector<double> crank_angles_of(const DyadPair& pair, const std::vector<Pose>& reached) {
  std::vector<double> angles;
  for (const Pose& pose : reached) {
    angles.push_back(angle_of(to_frame(pose, pair.first.in_body) - pair.first.fixed));
  }
  return along_arc(pair, std::move(angles));
}

/// A design as a model in which all dimensions are variables, those that are given held by bounds.
class OpenedMotion {
 public:
  OpenedMotion(std::shared_ptr<const MotionDrive> drive, const DyadPair& scaled,
               std::span<const double> crank_angles)
      : drive_(std::move(drive)),
        form_(unpooled_form(drive_->open, scaled, crank_angles)),
        model_(std::make_shared<const TolerancedMotionModel>(drive_->open, form_)) {}

  const std::shared_ptr<const TolerancedMotionModel>& model() const { return model_; }

  bool place(std::vector<double>& x) const {
    auto placed = placed_cranks(drive_->open, form_, model_->without_changes(x));
    if (!placed) return false;
    x = model_->with_no_changes(*placed);
    return true;
  }

  /// Where the linkage stands, in the file's unit; it must close.
  HeldBody body(std::span<const double> x) const {
    const auto nominal = model_->without_changes(x);
    HeldBody made{drive_->scale.out_of(model_->nominal().pair(nominal)),
                  model_->nominal().reached(nominal)};
    for (Pose& pose : made.reached) pose = drive_->scale.out_of(pose);
    return made;
  }

 private:
  std::shared_ptr<const MotionDrive> drive_;
  MotionForm form_;
  std::shared_ptr<const TolerancedMotionModel> model_;
};

/// Which dimensions of the model the file gives.
std::array<bool, MotionModel::dimensions> given_dimensions(const MotionProblem& drive) {
  std::array<bool, MotionModel::dimensions> given{};
  const auto set = [&](int dimension, int count, bool is_given) {
    std::fill_n(given.begin() + dimension, count, is_given);
  };
  const auto has = [&](const std::vector<Vec2d>& pivots, DyadRole role) {
    return given_pivot(drive, pivots, role).has_value();
  };
  set(kMoving1, 2, has(drive.moving_pivots, DyadRole::first));
  set(kMoving2, 2, has(drive.moving_pivots, DyadRole::second));
  set(kFixed1, 2, has(drive.fixed_pivots, DyadRole::first));
  set(kFixed2, 2, has(drive.fixed_pivots, DyadRole::second));
  set(kLength1, 1, drive.crank.has_value());
  set(kLength2, 1, drive.rocker.has_value());
  return given;
}

/// Empty where no dimension has a tolerance, or a standard has none for it.
std::optional<RobustStart> start_of(const MotionDrive& drive, const RatedMotion& found,
                                    const DyadPair& scaled, std::span<const double> crank_angles,
                                    const OpenedMotion& opened) {
  const MotionProblem& problem = drive.problem;
  const auto toleranced =
      problems::toleranced(found.design.mechanism, *problem.tolerances, problem.length_unit);
  if (!toleranced) return std::nullopt;
  const TolerancedMotionModel& model = *opened.model();
  const MotionModel& nominal = model.nominal();
  RobustStart start;
  start.model = opened.model();
  start.x = model.with_no_changes(nominal.with_angles(nominal.variables_of(scaled), crank_angles));
  for (const synthesis::Variable& variable : model.variables()) {
    start.lower.push_back(variable.lower);
    start.upper.push_back(variable.upper);
  }
  const auto hold = [&](std::size_t variable) {
    start.lower[variable] = start.upper[variable] = start.x[variable];
  };
  const auto given = given_dimensions(problem);
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given.at(i)) hold(i);
  }
  for (std::size_t i = 0; i < kChangeNames.size(); ++i) {
    const std::size_t variable = model.variable_of(static_cast<TolerancedMotionModel::Change>(i));
    hold(variable);
    const auto known =
        std::ranges::find(toleranced->dimensions, kChangeNames.at(i), &TolerancedDimension::name);
    if (known == toleranced->dimensions.end()) continue;
    start.dimensions.push_back(*known);
    start.variables.push_back(
        {.variable = static_cast<int>(variable), .scale = drive.scale.size()});
  }
  return start.dimensions.empty() ? std::nullopt : std::optional(std::move(start));
}

/// The nominal optimum and other minima, also those with good transmission angles, best first.
std::vector<RatedMotion> nominal_designs(const MotionProblem& problem, const Run& run,
                                         const Deadline& deadline, Result& result) {
  MotionDesigns designs(problem, MotionScale(problem).size());
  std::vector<MotionProblem> searches = drives_of(problem);
  const std::size_t drives = searches.size();
  if (const auto limits = with_good_transmission(problem.constraints)) {
    for (std::size_t i = 0; i < drives; ++i) {
      searches.push_back(searches[i]);
      searches.back().constraints = *limits;
    }
  }
  SearchStatistics statistics;
  for (std::size_t i = 0; i < searches.size(); ++i) {
    searches[i].solve.designs = std::max(searches[i].solve.designs, kRobustStarts);
    const auto part = [&](std::size_t done) {
      return kStartsDone * double(done) / double(searches.size());
    };
    const auto one = add_minima(searches[i], starts_of(searches[i], drives),
                                part_of(run, part(i), part(i + 1)), deadline, designs, result.work);
    if (i < drives) statistics = together(statistics, one);
  }
  result.quantities = quantities(statistics);
  return designs.any_feasible() ? std::move(designs.ranked()) : std::vector<RatedMotion>{};
}

/// From designs within their limits; `problem` must outlive it.
RobustTask robust_motion_task(const MotionProblem& problem,
                              const std::vector<RatedMotion>& nominal) {
  RobustTask task;
  task.share = *problem.solve.robust;
  task.distribution = problem.tolerances->distribution;
  task.components = 3;
  task.unit = MotionScale(problem).size();
  std::array<std::shared_ptr<const MotionDrive>, 2> drives;
  for (const bool first_is_driven : {true, false}) {
    MotionProblem own = problem;
    own.first_is_driven = first_is_driven;
    drives.at(first_is_driven ? 0 : 1) = std::make_shared<const MotionDrive>(std::move(own));
  }
  using Opened = std::map<const synthesis::Model*, std::shared_ptr<const OpenedMotion>>;
  auto opened = std::make_shared<Opened>();
  for (const RatedMotion& found : nominal) {
    const auto& drive = drives.at(found.first_is_driven ? 0 : 1);
    const DyadPair scaled = drive->scale.into(found.body.pair);
    const auto angles = crank_angles_of(found.body.pair, found.body.reached);
    auto one = std::make_shared<const OpenedMotion>(drive, scaled, angles);
    auto start = start_of(*drive, found, scaled, angles, *one);
    if (!start) {
      task.lacks_tolerances = true;
      continue;
    }
    opened->emplace(start->model.get(), std::move(one));
    task.starts.push_back(*std::move(start));
  }
  task.place = [opened](const RobustStart& start, std::vector<double>& x) {
    return opened->at(start.model.get())->place(x);
  };
  task.design = [&problem, opened](const RobustStart& start,
                                   const std::vector<double>& x) -> std::optional<Design> {
    const HeldBody body = opened->at(start.model.get())->body(x);
    if (body.reached.empty()) return std::nullopt;
    auto design = verified_design(problem, body, "robust");
    return design && all_satisfied(design->constraints) ? std::move(design) : std::nullopt;
  };
  task.error = [&problem](const Design& design) { return error_of(problem, design); };
  return task;
}

}  // namespace

Result solve_motion_robustly(const MotionProblem& problem, const Run& run,
                             const Deadline& deadline) {
  Result result;
  run.enter(Phase::search, kStartsDone);
  const auto nominal = nominal_designs(problem, run, deadline, result);
  const RobustTask task = robust_motion_task(problem, nominal);
  add_robust(task, robust_designs(task, part_of(run, kStartsDone, 1), deadline), false, result);
  if (deadline.reached()) {
    result.status = deadline.interrupted() ? Status::interrupted : Status::time_limit;
  } else {
    result.status = result.designs.empty() ? Status::no_solution : Status::solved;
  }
  result.work.skipped = skipped_evaluations(problem.constraints);
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
