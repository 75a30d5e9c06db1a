#include "problems/linkage/sector_extremes.hpp"

#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {

CycleTable::CycleTable(const CycleDimensions& dimensions, CycleAngles angles)
    : angles_(angles), assembly_(sign(dimensions.assembly)), step_(std::tan(kPi / kAngles)) {
  const auto& [links, point, pivot, angle, assembly] = dimensions;
  plain_ = {links, point, pivot, {std::cos(angle), std::sin(angle)}};
  const auto jet = [](double value) { return OneJet(value); };
  one_ = {{jet(links.crank), jet(links.coupler), jet(links.rocker), jet(links.frame)},
          {jet(point.x), jet(point.y)},
          {jet(pivot.x), jet(pivot.y)},
          {jet(plain_.turn.x), jet(plain_.turn.y)}};
  full_ = {{{links.crank, 0}, {links.coupler, 1}, {links.rocker, 2}, {links.frame, 3}},
           {{point.x, 4}, {point.y, 5}},
           {{pivot.x, 6}, {pivot.y, 7}},
           {{plain_.turn.x, 8}, {plain_.turn.y, 8}}};
  full_.turn.x.v[8] = -plain_.turn.y;
  full_.turn.y.v[8] = plain_.turn.x;
  one_closure_ = Closure<OneJet>(one_.links);
  full_closure_ = Closure<FullJet>(full_.links);
  const Closure<double> closure(links);
  for (int k = 0; k < kAngles; ++k) {
    Sample& sample = states_.at(at(k));
    const auto direction = crank_direction(half_directions().at(at(k)));
    sample.state = turn_state(links, closure, direction, assembly_);
    sample.closes = std::isfinite(sample.state.rocker.bend);
  }
  if (angles_ == CycleAngles::all) follow_angles();
}

/// From each angle at which the linkage closes to the next; what is added in a whole turn is whole
/// turns.
void CycleTable::follow_angles() {
  const CycleState<double>* first = nullptr;
  const CycleState<double>* last = nullptr;
  for (int k = 0; k < kAngles; ++k) {
    Sample& sample = states_.at(at(k));
    if (!sample.closes) continue;
    CycleState<double>& state = sample.state;
    state.crank.angle = crank_angle(k, 0);
    if (last != nullptr) {
      state.coupler.angle = angle_near(last->coupler, 0, state.coupler.direction);
      state.rocker.angle = angle_near(last->rocker, 0, state.rocker.direction);
    } else {
      first = &state;
    }
    last = &state;
  }
  if (last == nullptr) return;
  const auto whole = [](const LinkTurning<double>& from, const LinkTurning<double>& to) {
    const double angle = angle_near(from, 0, to.direction) - to.angle;
    return std::round(angle / (kTurn));
  };
  turns_ = {1, whole(last->coupler, first->coupler), whole(last->rocker, first->rocker)};
}

const std::array<Vec2d, CycleTable::kAngles + 1>& CycleTable::half_directions() {
  static const auto all = [] {
    std::array<Vec2d, kAngles + 1> halves;
    for (int k = 0; k <= kAngles; ++k) {
      const double half = kPi * k / kAngles;
      halves.at(at(k)) = {std::cos(half), std::sin(half)};
    }
    return halves;
  }();
  return all;
}

}  // namespace cognate::problems
