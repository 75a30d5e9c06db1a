#include "problems/evaluation/force_filler.hpp"

#include <algorithm>
#include <cmath>

#include "problems/evaluation/drive_rows.hpp"

namespace cognate::problems {
namespace {

double& value(ColumnPlan& plan, ColumnIndex column, std::size_t row) {
  return plan.columns[static_cast<std::size_t>(column)].values[row];
}

}  // namespace

ForceFiller::ForceFiller(const AnalysisProblem& problem, std::span<const Stroke> strokes)
    : problem_(problem),
      joints_(joints(problem.mechanism.mechanism)),
      loads_(problem.mechanism.mechanism, problem.loads, strokes),
      dynamics_(problem.mechanism.mechanism, problem.inertias, problem.gravity),
      forces_(dynamics_.forces()) {}

PowerCheck ForceFiller::fill(ColumnPlan& plan, int row,
                             std::span<const BodyMotion<double, 2>> bodies) {
  const ColumnIndex drive_column = plan.drive_force, shaking = plan.shaking;
  if (drive_column == kNone && shaking == kNone) return {};
  const auto at = static_cast<std::size_t>(row);
  const DriveRate& rate = problem_.drive.rate;
  const auto loads = loads_.at<2>(drive_at(problem_.drive, row), rate.speed, bodies);
  const double by_power = dynamics_.drive<2>(bodies, rate, loads);
  if (shaking == kNone) {
    value(plan, drive_column, at) = by_power;
    return {};
  }
  if (!dynamics_.solve<2>(bodies, rate, loads, forces_)) return {};
  write_reactions(plan, at, bodies);
  if (drive_column != kNone) value(plan, drive_column, at) = forces_.drive;
  return check(by_power, bodies);
}

void ForceFiller::write_reactions(ColumnPlan& plan, std::size_t row,
                                  std::span<const BodyMotion<double, 2>> bodies) const {
  for (const auto& [index, slides, first] : plan.joints) {
    const Reaction& reaction = forces_.reactions[static_cast<std::size_t>(index)];
    const Joint& joint = joints_.joints[static_cast<std::size_t>(index)];
    if (slides) {
      const auto& guide = bodies[static_cast<std::size_t>(joint.at.body)];
      value(plan, first, row) = cross(guide.direction * joint.direction, reaction.force);
      value(plan, first + 1, row) = reaction.moment;
    } else {
      value(plan, first, row) = reaction.force.x;
      value(plan, first + 1, row) = reaction.force.y;
    }
  }
  value(plan, plan.shaking, row) = forces_.shaking_force.x;
  value(plan, plan.shaking + 1, row) = forces_.shaking_force.y;
  value(plan, plan.shaking + 2, row) = forces_.shaking_moment;
}

PowerCheck ForceFiller::check(double by_power,
                              std::span<const BodyMotion<double, 2>> bodies) const {
  PowerCheck check{std::abs(forces_.drive - by_power),
                   std::max(std::abs(forces_.drive), std::abs(by_power))};
  for (std::size_t i = 0; i < joints_.joints.size(); ++i) {
    const Joint& joint = joints_.joints[i];
    const auto& body = bodies[static_cast<std::size_t>(joint.at.body)];
    const auto motion = point_motion<double, 2>(body, joint.at.at);
    check.scale = std::max(check.scale, norm(forces_.reactions[i].force) * norm(motion[1]));
  }
  return check;
}

}  // namespace cognate::problems
