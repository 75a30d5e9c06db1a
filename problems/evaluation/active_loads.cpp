#include "problems/evaluation/active_loads.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

constexpr double kSlack = 1e-12;
constexpr double kAtRest = 64 * std::numeric_limits<double>::epsilon();

/// Whether `angle` lies counter-clockwise between `from` and `to`, the ends included.
bool between_angles(double angle, double from, double to) {
  if (to - from >= kTurn - kSlack) return true;
  return in_one_turn(angle - from + kSlack) <= in_one_turn(to - from) + 2 * kSlack;
}

/// The greatest velocity, by the drive coordinate, that a travel of this kind may be compared with.
template <int Order>
double greatest_rate(bool slides, std::span<const BodyMotion<double, Order>> bodies) {
  double greatest = 0;
  for (const BodyMotion<double, Order>& body : bodies) {
    const double rate =
        slides ? std::hypot(body.origin[1].x, body.origin[1].y) : std::abs(body.turn[0]);
    greatest = std::max(greatest, rate);
  }
  return greatest;
}

/// +1 where the body advances, −1 where it retreats, 0 at rest.
template <int Order>
int sense(const Travel& travel, double speed, std::span<const BodyMotion<double, Order>> bodies) {
  const double rate = travel_rate(travel, bodies);
  if (speed == 0 || !(std::abs(rate) > kAtRest * greatest_rate(travel.slides, bodies))) return 0;
  return (rate > 0) == (speed > 0) ? 1 : -1;
}

/// How much of its stroke a body has behind it, from 0 to 1.
double fraction(const Travel& travel, const Stroke& stroke, double at) {
  const double length = stroke.greatest - stroke.least;
  const double covered = at - stroke.least;
  if (travel.slides) return covered / length;
  // An angle just short of the least is almost a turn beyond it, or a little before it.
  const double turned = in_one_turn(covered);
  return (turned > length && kTurn - turned < turned - length ? turned - kTurn : turned) / length;
}

}  // namespace

ActiveLoads::ActiveLoads(const Mechanism<double>& mechanism, std::span<const LoadRule> rules,
                         std::span<const Stroke> strokes)
    : drive_turns_(!driven_by_length(mechanism.drive)) {
  const std::vector<Travel> all = travels(mechanism);
  scheduled_.reserve(rules.size());
  active_.reserve(rules.size());
  for (std::size_t i = 0; i < rules.size(); ++i) {
    scheduled_.push_back({rules[i], all[static_cast<std::size_t>(rules[i].at.body)],
                          i < strokes.size() ? strokes[i] : Stroke{}});
  }
}

bool ActiveLoads::in_interval(const LoadRule& rule, double drive) const {
  if (!rule.between) return true;
  const auto [from, to] = *rule.between;
  if (drive_turns_) return between_angles(drive, from, to);
  const double slack = kSlack * std::max(std::abs(from), std::abs(to));
  return from - slack <= drive && drive <= to + slack;
}

template <int Order>
std::span<const Load> ActiveLoads::at(double drive, double speed,
                                      std::span<const BodyMotion<double, Order>> bodies) {
  active_.clear();
  for (const auto& [rule, travel, stroke] : scheduled_) {
    if (!in_interval(rule, drive)) continue;
    if (rule.sense != LoadSense::always) {
      const int wanted = rule.sense == LoadSense::advance ? 1 : -1;
      if (sense(travel, speed, bodies) != wanted) continue;
    }
    if (rule.within_stroke) {
      const double part = fraction(travel, stroke, travelled(travel, bodies));
      const auto [from, to] = *rule.within_stroke;
      if (!(from - kSlack <= part && part <= to + kSlack)) continue;
    }
    active_.push_back({rule.at, rule.force, rule.torque});
  }
  return active_;
}

template std::span<const Load> ActiveLoads::at<1>(double, double,
                                                  std::span<const BodyMotion<double, 1>>);
template std::span<const Load> ActiveLoads::at<2>(double, double,
                                                  std::span<const BodyMotion<double, 2>>);
template std::span<const Load> ActiveLoads::at<3>(double, double,
                                                  std::span<const BodyMotion<double, 3>>);

}  // namespace cognate::problems
