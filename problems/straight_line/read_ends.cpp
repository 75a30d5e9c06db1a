#include "problems/straight_line/read_ends.hpp"

#include <fmt/core.h>

#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems::reading {
namespace {

/// Far above the rounding of decimal digits, far below any tolerance of a linkage.
constexpr double kSame = 1e-9;

constexpr std::string_view kEnds = "ends";

void check_length(TableReader& target, const StraightLineGoal& goal, double distance) {
  if (!goal.length || std::abs(*goal.length - distance) <= kSame * distance) return;
  target.fault("length",
               fmt::format("is {}, but the ends given are {} apart; remove length or ends",
                           *goal.length, distance));
}

void check_direction(TableReader& target, const StraightLineGoal& goal, const Vec2d& way) {
  const double angle = std::atan2(way.y, way.x);
  if (!goal.direction || std::abs(std::remainder(*goal.direction - angle, kPi)) <= kSame) return;
  target.fault("direction_deg",
               fmt::format("contradicts the ends given, whose direction is {} degrees; remove "
                           "direction_deg or ends",
                           angle * 180 / kPi));
}

}  // namespace

void read_ends(TableReader& target, StraightLineGoal& goal) {
  const auto ends = target.twos(kEnds, kQuantity, "[[x1, y1], [x2, y2]]", {2, 2, "ends"});
  if (!ends) return;
  const Vec2d first{ends->front()[0], ends->front()[1]}, last{ends->back()[0], ends->back()[1]};
  const Vec2d way = last - first;
  const double distance = std::hypot(way.x, way.y);
  if (!kLinkLength.accepts(distance)) {
    target.fault(kEnds, fmt::format("are {} apart; expected two places with {} between them",
                                    distance, kLinkLength.allowed));
    return;
  }
  check_length(target, goal, distance);
  check_direction(target, goal, way);
  goal.ends = {first, last};
  goal.length = distance;
  goal.direction.reset();
}

}  // namespace cognate::problems::reading
