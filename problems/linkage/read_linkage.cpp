#include "problems/linkage/read_linkage.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/linkage_keys.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

// Relative difference at which two ways of giving a dimension contradict each other: far above the
// rounding of decimal digits, far below any tolerance of a linkage.
constexpr double kSame = 1e-9;

std::optional<Range> read_length_range(TableReader& bounds, std::string_view key) {
  const auto range = bounds.range(key, kLengthLimit);
  if (range && range->max == 0) {
    bounds.fault(key, "is [0, 0]; lengths are positive, expected [min, max] with max > 0");
    return std::nullopt;
  }
  return range;
}

void read_fixed_pivots(TableReader& mechanism, Given& given) {
  constexpr std::string_view kKey = "fixed_pivots";
  if (mechanism.has(kKey) && (mechanism.has("pivot_a") || mechanism.has("pivot_d"))) {
    mechanism.fault(kKey, "is given beside a pivot; give fixed_pivots or pivot_a and pivot_d");
  }
  const auto pivots = mechanism.twos(kKey, kNumber, "[[xA, yA], [xD, yD]]", {2, 2, "pivots"});
  if (!pivots) return;
  given.pivot_a = Vec2d{pivots->front()[0], pivots->front()[1]};
  given.pivot_d = Vec2d{pivots->back()[0], pivots->back()[1]};
}

// |D − A| where both pivots are given.
std::optional<double> pivot_distance(const Given& given) {
  if (!given.pivot_a || !given.pivot_d) return std::nullopt;
  return std::hypot(given.pivot_d->x - given.pivot_a->x, given.pivot_d->y - given.pivot_a->y);
}

std::string_view pivots_key(TableReader& mechanism) {
  return mechanism.has("fixed_pivots") ? "fixed_pivots" : "pivot_d";
}

// Angles in radians, whole turns apart.
bool same_direction(double a, double b) {
  return std::abs(std::remainder(a - b, kTurn)) <= kSame;
}

void check_pivots(TableReader& mechanism, const Given& given) {
  const auto distance = pivot_distance(given);
  if (!distance) return;
  if (!is_positive_magnitude(*distance)) {
    mechanism.fault(pivots_key(mechanism),
                    fmt::format("is {} from the other pivot; the frame's length, |D - A|, is a "
                                "length from 1e-100 to 1e100",
                                *distance));
    return;
  }
  if (given.frame && std::abs(*distance - *given.frame) > kSame * *given.frame) {
    mechanism.fault("frame", fmt::format("is {}, but the pivots given are {} apart; remove "
                                         "frame or one of the pivots",
                                         *given.frame, *distance));
  }
  const double angle =
      std::atan2(given.pivot_d->y - given.pivot_a->y, given.pivot_d->x - given.pivot_a->x);
  if (given.frame_angle && !same_direction(angle, *given.frame_angle)) {
    mechanism.fault("frame_angle_deg",
                    fmt::format("contradicts the pivots given, whose direction is {} degrees; "
                                "remove frame_angle_deg or one of the pivots",
                                angle * 180 / kPi));
  }
}

void check_link_bounds(TableReader& mechanism, const Given& given, const Bounds& limits) {
  for (const LinkKey& link : kLinkKeys) {
    const auto& bounds = limits.*link.bounds;
    auto length = given.*link.given;
    std::string_view key = link.key;
    if (!length && link.given == &Given::frame && pivot_distance(given)) {
      length = pivot_distance(given);
      key = pivots_key(mechanism);
    }
    if (!length || !bounds || (*length >= bounds->min && *length <= bounds->max)) continue;
    mechanism.fault(
        key, fmt::format("makes the {} {}, outside its bounds; bounds.{} allows [{}, {}]", link.key,
                         *length, link.key, bounds->min, bounds->max));
  }
}

void check_place_bounds(TableReader& mechanism, const Given& given, const Bounds& limits) {
  for (const BoundedPlaceKey& place : kPlaceKeys) {
    const auto& point = given.*place.given;
    const auto& box = limits.*place.bounds;
    if (!point || !box || contains(*box, *point)) continue;
    const bool as_pair = mechanism.has("fixed_pivots") && place.given != &Given::coupler_point;
    mechanism.fault(
        as_pair ? "fixed_pivots" : place.key,
        fmt::format("puts {} outside its bounds; bounds.{} allows [{}, {}] to [{}, {}]", place.key,
                    place.key, box->min.x, box->min.y, box->max.x, box->max.y));
  }
}

void check_frame_angle_bounds(TableReader& mechanism, const Given& given, const Bounds& limits) {
  if (!given.frame_angle || !limits.frame_angle) return;
  const Range& range = *limits.frame_angle;
  const double above = *given.frame_angle - range.min;  // brought into [0, 2π) by whole turns
  const double excess = above - kTurn * std::floor(above / kTurn);
  const bool inside = excess <= range.max - range.min + kSame || kTurn - excess <= kSame;
  if (!inside) {
    mechanism.fault("frame_angle_deg",
                    "lies outside bounds.frame_angle_deg; expected an angle within it");
  }
}

}  // namespace

bool contains(const Box& box, Vec2d point) {
  return point.x >= box.min.x && point.x <= box.max.x && point.y >= box.min.y &&
         point.y <= box.max.y;
}

void read_mechanism_type(TableReader& mechanism) {
  constexpr std::string_view kKey = "type";
  constexpr std::string_view kFourBar = "four-bar";
  constexpr std::string_view kLater[] = {"slider-crank", "guide-bar", "chain"};
  const auto type = mechanism.text(kKey);
  if (!type || *type == kFourBar) return;
  if (std::ranges::find(kLater, *type) != std::end(kLater)) {
    mechanism.fault(kKey, fmt::format("{} is not available in this version for this kind of "
                                      "problem; available is \"four-bar\"",
                                      in_quotes(*type)));
    return;
  }
  constexpr std::string_view kAvailable[] = {kFourBar};
  mechanism.choice_of(kKey, kAvailable);
}

void read_given_links(TableReader& mechanism, Given& given) {
  for (const LinkKey& link : kLinkKeys) given.*link.given = mechanism.number(link.key, kLength);
  given.assembly = mechanism.choice<Assembly>("assembly");
}

void read_given_places(TableReader& mechanism, Given& given) {
  for (const BoundedPlaceKey& place : kPlaceKeys) given.*place.given = mechanism.point(place.key);
  read_fixed_pivots(mechanism, given);
  const auto angle = mechanism.number("frame_angle_deg", kAngle);
  if (angle) given.frame_angle = radians(*angle);
}

void read_length_bounds(TableReader& bounds, Bounds& limits) {
  const auto common = read_length_range(bounds, "length");
  for (const LinkKey& link : kLinkKeys) {
    auto range = read_length_range(bounds, link.key);
    if (range && common) {
      const Range both{std::max(range->min, common->min), std::min(range->max, common->max)};
      if (both.min > both.max) {
        bounds.fault(link.key,
                     fmt::format("and bounds.length have no length in common; the {} must "
                                 "lie in both",
                                 link.key));
      } else {
        range = both;
      }
    }
    limits.*link.bounds = range ? range : common;
  }
}

void read_place_bounds(TableReader& bounds, Bounds& limits) {
  for (const BoundedPlaceKey& place : kPlaceKeys) limits.*place.bounds = bounds.box(place.key);
  const auto angles = bounds.range("frame_angle_deg", kAngle);
  if (angles) limits.frame_angle = Range{radians(angles->min), radians(angles->max)};
}

void check_given(TableReader& mechanism, const Given& given, const Bounds& limits) {
  check_pivots(mechanism, given);
  check_link_bounds(mechanism, given, limits);
  check_place_bounds(mechanism, given, limits);
  check_frame_angle_bounds(mechanism, given, limits);
}

LengthLimits length_limits(const Given& given, const Bounds& limits) {
  LengthLimits all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const LinkKey& link = kLinkKeys.at(i);
    auto length = given.*link.given;
    if (!length && link.given == &Given::frame) length = pivot_distance(given);
    const auto& bounds = limits.*link.bounds;
    all[i] = length ? Range{*length, *length} : bounds.value_or(Range{0, kInfinity});
  }
  return all;
}

}  // namespace cognate::problems::reading
