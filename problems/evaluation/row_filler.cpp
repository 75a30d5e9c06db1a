#include "problems/evaluation/row_filler.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/coupler_curve/path_curvature.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/drive_rows.hpp"

namespace cognate::problems {
namespace {

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
  described_.move_to(drive);
  const auto is_open = [](const auto& closure) { return !(closure.discriminant >= 0); };
  const auto closures = described_.closures();
  const auto found = std::ranges::find_if(closures, is_open);
  const auto last = static_cast<int>(closures.size()) - 1;
  return std::min(static_cast<int>(found - closures.begin()), last);
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
