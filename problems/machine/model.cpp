#include "problems/machine/model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/machine/machine.hpp"
#include "analysis/machine/reduction.hpp"
#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "problems/evaluation/load_breaks.hpp"
#include "problems/evaluation/whole_motion.hpp"
#include "problems/machine/gearing.hpp"
#include "problems/machine/load_travel.hpp"
#include "problems/machine/problem.hpp"
#include "problems/machine/vanishing_inertia.hpp"
#include "problems/mechanism/drive_angle.hpp"

namespace cognate::problems {
namespace {

/// Evaluated once at a position, whose torques may then be requested at several speeds. Allocates
/// nothing after it is made.
class ReducedMechanism {
 public:
  /// `strokes`: of the mechanism's loads, then of `loads`; may be empty where no load needs them.
  /// `travels`: of the body of each of `loads`.
  ReducedMechanism(const AnalysisProblem& problem, const std::vector<MachineLoad>& loads,
                   const AssemblyRanges& assembly_ranges, const std::vector<Stroke>& strokes,
                   const std::vector<LoadTravel>& travels);

  /// Stands at `phi`, from 0 to the length of the assembly ranges (which may begin
  /// elsewhere). Not numbers where the mechanism cannot be assembled, or stands at a dead point.
  machine::EquivalentInertia move_to(double phi);

  /// Of weights and loads.
  double torque(double omega, double time);

 private:
  struct FunctionLoad {
    MachineLoad load;
    LoadTravel travel;
    ActiveLoads active;
  };

  double value(const FunctionLoad& load, double omega, double time) const;

  FollowedMotion<2> motion_;
  std::vector<Inertia> inertias_;
  Vec2d gravity_;
  ActiveLoads active_;
  std::vector<FunctionLoad> functions_;
  double phi_ = 0, weights_ = 0;
};

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

/// Ranges of the drive no farther apart than this meet.
constexpr double kSlack = 1e-9;

double degrees_of(double phi) {
  const double degrees = phi * 360 / kTurn;
  return std::abs(degrees) < kSlack ? 0 : degrees;
}

std::string undetermined_in_words(const AssemblyRange& run) {
  const auto change = std::ranges::find(run.changes, false, &Change::determined);
  if (change == run.changes.end()) return {};
  return fmt::format(
      "the drive does not hold the mechanism at {:.6g}°, where two joints coincide and its "
      "position "
      "is not determined",
      degrees_of(in_period(change->drive, kTurn)));
}

/// Why the drive does not turn fully over `assembly_ranges`, a turn or more; empty where it does.
std::string gap_in_words(const AssemblyRanges& assembly_ranges) {
  if (assembly_ranges.runs.empty())
    return "the mechanism cannot be assembled at any angle of its drive";
  std::vector<AssemblyRange> runs = assembly_ranges.runs;
  const bool closes = runs.front().from <= assembly_ranges.start + kSlack &&
                      runs.back().to >= assembly_ranges.end - kSlack &&
                      runs.front().from_dyad < 0 && runs.back().to_dyad < 0;
  if (closes && runs.size() == 1) return undetermined_in_words(runs.front());
  if (closes) {
    runs.front().from = runs.back().from - kTurn;
    runs.pop_back();
  }
  std::string ranges;
  for (const AssemblyRange& run : runs) {
    ranges += fmt::format("{}from {:.6g}° to {:.6g}°", ranges.empty() ? "" : " and ",
                          degrees_of(run.from), degrees_of(run.to));
  }
  return fmt::format("the drive cannot turn fully: the mechanism can be assembled {}", ranges);
}

/// φ in [0, period) of the gaps of no width in assembly ranges that are a period long:
/// places between two ranges of the drive where a part of the mechanism is at infinity, and those
/// at which the drive does not hold it.
std::vector<double> walls(const AssemblyRanges& assembly_ranges) {
  std::vector<double> found;
  const double period = assembly_ranges.end - assembly_ranges.start;
  for (std::size_t i = 0; i < assembly_ranges.runs.size(); ++i) {
    const AssemblyRange& run = assembly_ranges.runs[i];
    const bool is_last = i + 1 == assembly_ranges.runs.size();
    const AssemblyRange& next = assembly_ranges.runs[is_last ? 0 : i + 1];
    const double gap = next.from + (is_last ? period : 0) - run.to;
    const bool ends = run.to_dyad >= 0 || next.from_dyad >= 0;
    if (ends && gap <= kSlack) found.push_back(in_period(run.to, period));
    for (const Change& change : run.changes) {
      if (!change.determined) found.push_back(in_period(change.drive, period));
    }
  }
  return found;
}

/// A part of the mechanism that is at infinity is so far away this near to that place that the
/// drive does not get there.
constexpr double kNearWall = 1e-6;

/// The mechanism's problem with the loads that are functions among its own, in the order of
/// strokes.
AnalysisProblem with_all_loads(const AnalysisProblem& problem,
                               const std::vector<MachineLoad>& loads) {
  AnalysisProblem all = problem;
  std::ranges::transform(loads, std::back_inserter(all.loads), &MachineLoad::rule);
  return all;
}

/// Where a load with `load` may jump or bend other than by its function: what depends on a body's
/// travel needs the sense of its motion.
LoadRule rule_of_breaks(const AnalysisProblem& all, const std::vector<MachineLoad>& loads,
                        std::size_t load) {
  LoadRule rule = all.loads[load];
  const std::size_t own = all.loads.size() - loads.size();
  if (load >= own && loads[load - own].of_travel) rule.sense = LoadSense::advance;
  return rule;
}

/// Whether all bodies stand after a turn as they did before; `two_turns` is the motion from where a
/// machine's course begins. Beside that place, since a change point may lie there.
bool repeats(const Mechanism<double>& mechanism, const AssemblyRanges& two_turns) {
  constexpr double kBeside = 0.01, kSame = 1e-6;
  FollowedMotion<0> first(mechanism, two_turns), second(mechanism, two_turns);
  if (!first.move_to(two_turns.start + kBeside)) return true;
  if (!second.move_to(two_turns.start + kTurn + kBeside)) return true;
  const auto stand_alike = [](const auto& a, const auto& b) {
    return squared_norm(a.direction - b.direction) < kSame;
  };
  return std::ranges::equal(first.bodies(), second.bodies(), stand_alike);
}

/// What a machine is made of, with the state of its mechanism.
struct Parts {
  std::optional<ReducedMechanism> mechanism;
  std::optional<MachineFunction> inertia, torque;
  MotorGearing gearing;
  MachineFunction motor;  ///< its torque; without a value where it is off
  double constant_inertia = 0;
  double brake = 0;
  double period = 0;
  std::vector<double> walls;
  double phi = 0;
  std::shared_ptr<std::uint64_t> evaluations;

  bool is_in_wall() const {
    return std::ranges::any_of(walls, [&](double wall) {
      return std::abs(std::remainder(phi - wall, period)) < kNearWall;
    });
  }

  machine::EquivalentInertia move_to(double angle) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    phi = angle;
    ++*evaluations;
    if (is_in_wall()) return {kNone, kNone};
    machine::EquivalentInertia sum{constant_inertia, 0};
    if (mechanism) {
      const machine::EquivalentInertia of_bodies = mechanism->move_to(phi);
      sum.value += of_bodies.value;
      sum.slope += of_bodies.slope;
    }
    if (inertia) {
      sum.value += inertia->value(phi, 0, 0);
      if (inertia->slope) sum.slope += inertia->slope(phi);
    }
    return sum;
  }

  double motor_torque(double omega, double time, double load_torque) const {
    const double torque = motor.value ? motor.value(phi, gearing.ratio * omega, time) : 0;
    return gearing.torque_at_drive(torque, omega, load_torque);
  }

  machine::Torques torques(double omega, double time) {
    double load = omega > 0 ? -brake : omega < 0 ? brake : 0;
    if (torque) load += torque->value(phi, omega, time);
    if (mechanism) load += mechanism->torque(omega, time);
    return {motor_torque(omega, time, load), load};
  }
};

}  // namespace

MachineModel::MachineModel(const MachineProblem& problem, const Deadline& deadline)
    : problem_(problem), period_(kTurn) {
  if (problem.mechanism) prepare_mechanism(*problem.mechanism, deadline);
  const auto add = [&](const MachineFunction& function) {
    add_breaks(function.breaks);
    depends_on_time_ = depends_on_time_ || function.of_time;
  };
  if (problem.inertia) add(*problem.inertia);
  if (problem.torque) add(*problem.torque);
  if (problem.motor) add(problem.motor->torque);
  for (const MachineLoad& load : problem.loads) add(load.value);
  std::ranges::sort(breaks_);
}

void MachineModel::prepare_mechanism(const AnalysisProblem& mechanism, const Deadline& deadline) {
  AnalysisProblem all = with_all_loads(mechanism, problem_.loads);
  all.drive.start = in_one_turn(problem_.run.start_phi);
  assembly_ranges_ = whole_motion(all, deadline);
  gap_ = gap_in_words(assembly_ranges_);
  if (turns() && !assembly_ranges_.runs.front().changes.empty()) {
    AssemblyRanges two_turns =
        follow_until(all, assembly_ranges_.start, assembly_ranges_.start + 2 * kTurn, deadline);
    if (!repeats(all.mechanism.mechanism, two_turns)) {
      period_ = 2 * kTurn;
      assembly_ranges_ = std::move(two_turns);
    }
  }
  strokes_ = load_strokes(all, deadline);
  for (std::size_t i = 0; i < all.loads.size(); ++i) {
    const Stroke stroke = i < strokes_.size() ? strokes_[i] : Stroke{};
    const LoadRule rule = rule_of_breaks(all, problem_.loads, i);
    const auto more = load_breaks(all.mechanism.mechanism, assembly_ranges_, rule, stroke);
    breaks_.insert(breaks_.end(), more.begin(), more.end());
  }
  for (const MachineLoad& load : problem_.loads) add_travel(all.mechanism.mechanism, load);
  walls_ = walls(assembly_ranges_);
  for (const double wall : walls_) {
    breaks_.insert(breaks_.end(), {wall - kNearWall, wall + kNearWall});
  }
  for (double& place : breaks_) place = in_period(place, period_);
}

void MachineModel::add_travel(const Mechanism<double>& mechanism, const MachineLoad& load) {
  const LoadTravel& travel = travels_.emplace_back(mechanism, assembly_ranges_, load.rule.at.body);
  if (!load.of_travel || !travel.begins_anew()) return;
  LoadRule whole_turn = load.rule;
  whole_turn.within_stroke = {0, 1};
  const auto begins = load_breaks(mechanism, assembly_ranges_, whole_turn, {0, kTurn});
  breaks_.insert(breaks_.end(), begins.begin(), begins.end());
}

void MachineModel::add_breaks(const std::vector<double>& of_a_turn) {
  for (double turn = 0; turn < period_; turn += kTurn) {
    for (const double place : of_a_turn) breaks_.push_back(turn + place);
  }
}

machine::Machine MachineModel::machine(const MachineParts& parts) const {
  auto all = std::make_shared<Parts>();
  if (problem_.mechanism) {
    all->mechanism.emplace(*problem_.mechanism, problem_.loads, assembly_ranges_, strokes_,
                           travels_);
  }
  all->inertia = problem_.inertia;
  all->torque = problem_.torque;
  all->constant_inertia = parts.flywheel;
  if (problem_.motor) {
    all->constant_inertia += motor_inertia(*problem_.motor);
    all->gearing = gearing_of(*problem_.motor);
    if (parts.motor) all->motor = problem_.motor->torque;
  }
  all->brake = parts.brake;
  all->period = period_;
  all->walls = walls_;
  all->evaluations = evaluations_;
  return {.move_to = [all](double phi) { return all->move_to(phi); },
          .torques = [all](double omega, double time) { return all->torques(omega, time); },
          .period = period_,
          .breaks = breaks_,
          .depends_on_time = depends_on_time_};
}

bool MachineModel::always_has_inertia(double flywheel) const {
  if (flywheel > 0 || problem_.inertia) return true;
  if (problem_.motor && motor_inertia(*problem_.motor) > 0) return true;
  // The drive turns with the angle that counts.
  return problem_.mechanism && problem_.mechanism->inertias.at(1).moment > 0;
}

std::optional<double> MachineModel::without_inertia(double flywheel) const {
  if (!turns() || always_has_inertia(flywheel)) return std::nullopt;
  return vanishing_inertia(machine({.flywheel = flywheel}));
}

bool MachineModel::depends_on_angle() const {
  const auto of_phi = [](const auto& function) { return function && function->of_phi; };
  return problem_.mechanism || of_phi(problem_.inertia) || of_phi(problem_.torque) ||
         (problem_.motor && problem_.motor->torque.of_phi);
}

}  // namespace cognate::problems
