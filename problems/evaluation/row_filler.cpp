#include "problems/evaluation/row_filler.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "analysis/coupler_curve/path_curvature.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/drive_rows.hpp"

namespace cognate::problems {
namespace {

double& value(ColumnPlan& plan, ColumnIndex column, std::size_t row) {
  return plan.columns[static_cast<std::size_t>(column)].values[row];
}

using Bodies = std::span<const Placement>;

double gap(Bodies bodies, const Attached<double>& a, const Attached<double>& b) {
  return norm(place(bodies, a) - place(bodies, b));
}

/// The distance of a body's origin from its guide.
double off_guide(Bodies bodies, int body, const Guide<double>& guide) {
  const Vec2d u = bodies[static_cast<std::size_t>(guide.body)].direction * guide.direction;
  const Vec2d along = place(bodies, {body, {}}) - place(bodies, {guide.body, guide.through});
  return std::abs(cross(u, along) - guide.offset);
}

double residual(const Crank<double>& crank, Bodies bodies) {
  return norm(bodies[1].origin - crank.pivot);
}

double residual(const DrivingSlider<double>& slider, Bodies bodies) {
  return off_guide(bodies, 1, slider.guide);
}

double residual(const FloatingLink<double>& link, Bodies bodies) {
  return std::max({off_guide(bodies, 2, link.first), off_guide(bodies, 3, link.second),
                   gap(bodies, {1, {}}, {2, {}}), gap(bodies, {1, {link.length, 0}}, {3, {}})});
}

double residual(const DrivingRod<double>&, Bodies bodies) {
  return off_guide(bodies, 1, {2, {}, {1, 0}, 0});
}

// The dyads, whose bodies are n and n + 1.

double residual(const Rrr<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, dyad.first, {n, {}}), gap(bodies, dyad.second, {n + 1, {}}),
                   gap(bodies, {n, {dyad.first_length, 0}}, {n + 1, {dyad.second_length, 0}})});
}

double residual(const Rrp<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, dyad.point, {n, {}}),
                   gap(bodies, {n, {dyad.length, 0}}, {n + 1, {}}),
                   off_guide(bodies, n + 1, dyad.guide)});
}

double residual(const Rpr<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, dyad.block, {n, {}}), gap(bodies, dyad.pivot, {n + 1, {}}),
                   off_guide(bodies, n, {n + 1, {}, {1, 0}, dyad.offset})});
}

double residual(const Prp<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, {n, {}}, {n + 1, {}}), off_guide(bodies, n, dyad.first),
                   off_guide(bodies, n + 1, dyad.second)});
}

double residual(const Rpp<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, dyad.point, {n, {}}),
                   off_guide(bodies, n, {n + 1, {}, dyad.slot, 0}),
                   off_guide(bodies, n + 1, dyad.guide)});
}

double residual(const Cylinder<double>& dyad, Bodies bodies, int n) {
  return std::max({gap(bodies, dyad.base, {n, {}}), gap(bodies, dyad.pivot, {n + 1, {}}),
                   gap(bodies, {1, {}}, {n + 1, {dyad.length, 0}})});
}

double residual(const GroupJoint& joint, Bodies bodies) {
  if (!joint.slides) return gap(bodies, joint.first, joint.second);
  const Vec2d u = bodies[static_cast<std::size_t>(joint.first.body)].direction * joint.along_first;
  return std::abs(cross(u, place(bodies, joint.second) - place(bodies, joint.first)));
}

double residual(const Group& group, Bodies bodies, int) {
  double greatest = 0;
  for (const GroupJoint& joint : group.joints) {
    greatest = std::max(greatest, residual(joint, bodies));
  }
  return greatest;
}

double residual(const GroupRest&, Bodies, int) {
  return 0;
}

/// ẋ = x′·q̇.
template <class Value>
Value velocity(const Value& x1, const DriveRate& rate) {
  return rate.speed * x1;
}

/// ẍ = x″·q̇² + x′·q̈.
template <class Value>
Value acceleration(const Value& x1, const Value& x2, const DriveRate& rate) {
  return (rate.speed * rate.speed) * x2 + rate.acceleration * x1;
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

Vec2d place(Bodies bodies, const Attached<double>& point) {
  const Placement& body = bodies[static_cast<std::size_t>(point.body)];
  return body.origin + body.direction * point.at;
}

double closure_residual(const Mechanism<double>& mechanism, Bodies bodies) {
  double greatest =
      std::visit([&](const auto& drive) { return residual(drive, bodies); }, mechanism.drive);
  int body = first_body(mechanism, 0);
  for (const auto& dyad : mechanism.dyads) {
    greatest = std::max(
        greatest,
        std::visit([&](const auto& group) { return residual(group, bodies, body); }, dyad));
    body += 2;
  }
  return greatest;
}

double extent(Bodies bodies) {
  double greatest = 0;
  for (const auto& body : bodies) greatest = std::max(greatest, norm(body.origin));
  return greatest;
}

template <int Order>
RowState RowFiller<Order>::fill(ColumnPlan& plan, int row) {
  plan_ = &plan;
  row_ = static_cast<std::size_t>(row);
  put(0, drive_value(problem_, row));
  const double drive = drive_at(problem_.drive, row);
  if (!motion_.move_to(drive)) return {.open_dyad = open_dyad(drive)};
  const bool dead = Order > 0 && motion_.drop_infinite_rates();
  write_bodies();
  write_slides();
  write_points();
  write_transmissions();
  RowState row_state = state();
  row_state.dead_point = dead;
  return row_state;
}

/// The first dyad that does not close there, or else the last one: where all do, it is the position
/// of one that is not determined.
template <int Order>
int RowFiller<Order>::open_dyad(double drive) {
  const bool knows_groups = place_described(drive);
  described_.move_to(drive);
  const auto closures = described_.closures();
  const auto& dyads = described_.mechanism().dyads;
  for (std::size_t i = 0; i < closures.size(); ++i) {
    const bool is_unknown = !knows_groups && std::holds_alternative<Group>(dyads[i]);
    if (is_unknown || !(closures[i].discriminant >= 0)) return static_cast<int>(i);
  }
  return static_cast<int>(closures.size()) - 1;
}

/// Puts the groups where a motion leads them; whether one does.
template <int Order>
bool RowFiller<Order>::place_described(double drive) {
  const auto leads_there = [&](const AssemblyRange& run) {
    return std::ranges::all_of(run.tracks, [&](const auto& track) {
      return track->from() <= drive && drive <= track->to();
    });
  };
  const auto& runs = motion_.assembly_ranges().runs;
  const auto run = std::ranges::find_if(runs, leads_there);
  if (run == runs.end()) return false;
  place_groups(*run, drive, described_.places());
  return true;
}

template <int Order>
RowState RowFiller<Order>::state() {
  placements_.clear();
  for (const auto& body : motion_.bodies()) placements_.push_back({body.origin[0], body.direction});
  return {.residual = closure_residual(problem_.mechanism.mechanism, placements_),
          .extent = extent(placements_)};
}

template <int Order>
void RowFiller<Order>::write_bodies() {
  for (const auto& [body, columns] : plan_->bodies) {
    const auto& motion = motion_.bodies()[static_cast<std::size_t>(body)];
    Values angle{std::atan2(motion.direction.y, motion.direction.x) * kDegreesInRadian};
    for (int k = 1; k <= Order; ++k) {
      angle[static_cast<std::size_t>(k)] = motion.turn[static_cast<std::size_t>(k - 1)];
    }
    put(columns, angle);
  }
}

template <int Order>
void RowFiller<Order>::write_slides() {
  for (const auto& [pair, columns] : plan_->slides) {
    put(columns, displacement<Order>(pair, motion_.bodies()));
  }
}

template <int Order>
void RowFiller<Order>::write_points() {
  for (const auto& point : plan_->points) {
    const auto r = motion_.point(point.at);
    put(point.coordinates, r);
    if constexpr (Order >= 2) {
      const auto bend = point.curvature != kNone ? curvature(r) : std::nullopt;
      if (bend) put(point.curvature, *bend);
    }
  }
}

template <int Order>
void RowFiller<Order>::write_transmissions() {
  for (const auto& [dyad, pressure, column] : plan_->transmissions) {
    const auto& closure = motion_.closures()[static_cast<std::size_t>(dyad)];
    const double sine = std::abs(closure.sine);
    put(column, kDegreesInRadian * (pressure ? std::atan2(closure.cosine, sine)
                                             : std::atan2(sine, closure.cosine)));
  }
}

template <int Order>
void RowFiller<Order>::put(const CoordinateColumns& columns, const Values& derivatives) {
  const DriveRate& rate = problem_.drive.rate;
  if (columns.position != kNone) put(columns.position, derivatives[0]);
  if constexpr (Order >= 1) {
    if (columns.velocity != kNone) put(columns.velocity, velocity(derivatives[1], rate));
  }
  if constexpr (Order >= 2) {
    if (columns.acceleration != kNone) {
      put(columns.acceleration, acceleration(derivatives[1], derivatives[2], rate));
    }
  }
}

template <int Order>
void RowFiller<Order>::put(const CoordinateColumns& columns,
                           const std::array<Vec2d, Order + 1>& derivatives) {
  Values x{}, y{};
  for (std::size_t k = 0; k < derivatives.size(); ++k) {
    x[k] = derivatives[k].x;
    y[k] = derivatives[k].y;
  }
  const auto next = [](ColumnIndex column) { return column == kNone ? kNone : column + 1; };
  put(columns, x);
  put({next(columns.position), next(columns.velocity), next(columns.acceleration)}, y);
}

template class RowFiller<0>;
template class RowFiller<1>;
template class RowFiller<2>;

}  // namespace cognate::problems
