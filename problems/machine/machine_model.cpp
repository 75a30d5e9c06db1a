#include "problems/machine/machine_model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "analysis/angle.hpp"
#include "analysis/mechanism/followed_motion.hpp"
#include "problems/analysis/load_strokes.hpp"
#include "problems/analysis/whole_motion.hpp"
#include "problems/machine/load_breaks.hpp"
#include "problems/machine/reduced_mechanism.hpp"

namespace cognate::problems {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kDegrees = 180 / std::numbers::pi;

/// The mechanism's problem with the loads that are functions among its own, in the order of
/// strokes.
AnalysisProblem with_all_loads(const AnalysisProblem& problem,
                               const std::vector<MachineLoad>& loads) {
  AnalysisProblem all = problem;
  std::ranges::transform(loads, std::back_inserter(all.loads), &MachineLoad::rule);
  return all;
}

/// Where a load with `load` may jump or bend besides where its function says: what depends on a
/// body's travel is asked to tell one way from the other.
LoadRule rule_of_breaks(const AnalysisProblem& all, const std::vector<MachineLoad>& loads,
                        std::size_t load) {
  LoadRule rule = all.loads[load];
  const std::size_t own = all.loads.size() - loads.size();
  if (load >= own && loads[load - own].of_travel) rule.sense = LoadSense::advance;
  return rule;
}

/// Whether all bodies stand after a turn as they did before; `two_turns` is the motion from where a
/// machine's course begins. Beside that place, since a change point may lie there.
bool repeats(const Mechanism<double>& mechanism, const Course& two_turns) {
  constexpr double kBeside = 0.01, kSame = 1e-6;
  FollowedMotion<0> first(mechanism, two_turns), second(mechanism, two_turns);
  if (!first.move_to(two_turns.start + kBeside)) return true;
  if (!second.move_to(two_turns.start + kTurn + kBeside)) return true;
  const auto stand_alike = [](const auto& a, const auto& b) {
    return squared_norm(a.direction - b.direction) < kSame;
  };
  return std::ranges::equal(first.bodies(), second.bodies(), stand_alike);
}

/// Why the drive does not turn fully; empty where it does.
std::string gap_of(const Course& course) {
  if (course.runs.empty()) return "the mechanism cannot be assembled at any angle of its drive";
  constexpr double kSlack = 1e-9;
  std::vector<CourseRun> runs = course.runs;
  const bool closes =
      runs.front().from <= course.start + kSlack && runs.back().to >= course.end - kSlack;
  if (closes && runs.size() == 1) return {};
  if (closes) {
    runs.front().from = runs.back().from - kTurn;
    runs.pop_back();
  }
  std::string ranges;
  for (const CourseRun& run : runs) {
    ranges += fmt::format("{}from {:.6g}° to {:.6g}°", ranges.empty() ? "" : " and ",
                          run.from * kDegrees, run.to * kDegrees);
  }
  return fmt::format("the drive cannot turn fully: the mechanism can be assembled {}", ranges);
}

/// What a machine is made of, with the state of its mechanism.
struct Parts {
  std::optional<ReducedMechanism> mechanism;
  std::optional<MachineFunction> inertia, torque;
  std::optional<Motor> motor;
  double constant_inertia = 0;
  double brake = 0;
  double phi = 0;
  std::shared_ptr<std::uint64_t> evaluations;

  machine::EquivalentInertia move_to(double angle) {
    phi = angle;
    ++*evaluations;
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

  /// Gears take their share of the power, whichever way it flows.
  double motor_torque(double omega, double time) const {
    if (!motor) return 0;
    const double torque = motor->ratio * motor->torque.value(phi, motor->ratio * omega, time);
    const bool drives = (torque > 0) == (omega > 0);
    return drives ? torque * motor->efficiency : torque / motor->efficiency;
  }

  machine::Torques torques(double omega, double time) {
    double load = omega > 0 ? -brake : omega < 0 ? brake : 0;
    if (torque) load += torque->value(phi, omega, time);
    if (mechanism) load += mechanism->torque(omega, time);
    return {motor_torque(omega, time), load};
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
  course_ = whole_motion(all, deadline);
  gap_ = gap_of(course_);
  if (turns() && !course_.runs.front().changes.empty()) {
    Course two_turns = follow_until(all, course_.start, course_.start + 2 * kTurn, deadline);
    if (!repeats(all.mechanism.mechanism, two_turns)) {
      period_ = 2 * kTurn;
      course_ = std::move(two_turns);
    }
  }
  strokes_ = load_strokes(all, deadline);
  for (std::size_t i = 0; i < all.loads.size(); ++i) {
    const Stroke stroke = i < strokes_.size() ? strokes_[i] : Stroke{};
    const LoadRule rule = rule_of_breaks(all, problem_.loads, i);
    const auto more = load_breaks(all.mechanism.mechanism, course_, rule, stroke);
    breaks_.insert(breaks_.end(), more.begin(), more.end());
  }
  for (double& place : breaks_) {
    if (place >= period_) place -= period_;
  }
}

void MachineModel::add_breaks(const std::vector<double>& of_a_turn) {
  for (double turn = 0; turn < period_; turn += kTurn) {
    for (const double place : of_a_turn) breaks_.push_back(turn + place);
  }
}

machine::Machine MachineModel::machine(const MachineParts& parts) const {
  auto all = std::make_shared<Parts>();
  if (problem_.mechanism) {
    all->mechanism.emplace(*problem_.mechanism, problem_.loads, course_, strokes_);
  }
  all->inertia = problem_.inertia;
  all->torque = problem_.torque;
  all->constant_inertia = parts.flywheel;
  if (problem_.motor) {
    const Motor& motor = *problem_.motor;
    all->constant_inertia += motor.inertia * motor.ratio * motor.ratio;
    if (parts.motor) all->motor = motor;
  }
  all->brake = parts.brake;
  all->evaluations = evaluations_;
  return {.move_to = [all](double phi) { return all->move_to(phi); },
          .torques = [all](double omega, double time) { return all->torques(omega, time); },
          .period = period_,
          .breaks = breaks_,
          .depends_on_time = depends_on_time_};
}

std::optional<double> MachineModel::without_inertia(double flywheel) const {
  constexpr int kSamples = 360;
  constexpr double kNothing = 1e-9;
  if (!turns()) return std::nullopt;
  const machine::Machine whole = machine({.flywheel = flywheel});
  const auto inertia = [&](double phi) {
    return whole.move_to(phi - period_ * std::floor(phi / period_)).value;
  };
  const double step = period_ / kSamples;
  double least = inertia(0), greatest = least, at = 0;
  for (int i = 1; i < kSamples; ++i) {
    const double value = inertia(i * step);
    greatest = std::max(greatest, value);
    if (value >= least) continue;
    least = value;
    at = i * step;
  }
  at = boost::math::tools::brent_find_minima(inertia, at - step, at + step, 30).first;
  if (inertia(at) > kNothing * greatest) return std::nullopt;
  constexpr double kClose = 1e-6;
  return std::abs(std::remainder(at, kTurn)) < kClose ? 0 : in_one_turn(at);
}

}  // namespace cognate::problems
