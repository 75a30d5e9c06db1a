#include "problems/cam/read_lengths.hpp"

#include <fmt/core.h>

#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/cam/read_follower.hpp"
#include "problems/cam/read_motion.hpp"
#include "problems/cam/rules.hpp"

namespace cognate::problems::reading {
namespace {

using cam::FollowerType;

bool is_used(CamDimension dimension, FollowerType type) {
  switch (dimension) {
    case CamDimension::base_radius:
      return true;
    case CamDimension::offset:
      return !is_oscillating(type);
    case CamDimension::roller_radius:
      return !is_flat(type);
    case CamDimension::centre_distance:
      return is_oscillating(type);
    case CamDimension::arm:
      return has_arm(type);
    case CamDimension::face_offset:
      return type == FollowerType::oscillating_flat;
  }
  return false;
}

// Whether it is a coordinate, of either sign, and no length.
bool is_signed(CamDimension dimension) {
  return dimension == CamDimension::offset || dimension == CamDimension::face_offset;
}

// Whether it may stand in [follower], being the follower's own.
bool is_followers(CamDimension dimension) {
  return dimension == CamDimension::roller_radius || dimension == CamDimension::arm ||
         dimension == CamDimension::face_offset;
}

TableReader& table_of(CamLengthTables& tables, CamDimension dimension) {
  return is_followers(dimension) ? holder(to_string(dimension), tables.follower, tables.mechanism)
                                 : tables.mechanism;
}

void refuse(TableReader& table, CamDimension dimension, FollowerType type) {
  const std::string_view key = to_string(dimension);
  if (!table.contains(key)) return;
  table.know({key});
  table.fault(key, fmt::format("is given, but {} has none; remove it", in_words(type)));
}

Range read_bounds(TableReader& bounds, CamDimension dimension) {
  const std::string_view key = to_string(dimension);
  if (is_signed(dimension)) {
    return bounds.range(key, kCamPlaceLimit).value_or(Range{-kInfinity, kInfinity});
  }
  const auto range = bounds.range(key, kCamLengthLimit);
  if (range && range->max == 0) {
    bounds.fault(key, "is [0, 0]; lengths are positive, expected [min, max] with max > 0");
  }
  return range.value_or(Range{0, kInfinity});
}

std::optional<double> read_given(TableReader& table, CamDimension dimension, FollowerType type) {
  const std::string_view key = to_string(dimension);
  if (dimension != CamDimension::roller_radius || !is_knife(type)) {
    return table.number(key, is_signed(dimension) ? kQuantity : kLinkLength);
  }
  const auto radius = table.number(key, kRadiusOrNone);
  if (radius.value_or(0) != 0) {
    table.fault(key, fmt::format("is {}, but a knife edge has none; expected 0, or type = "
                                 "\"{}-roller\"",
                                 *radius, is_oscillating(type) ? "oscillating" : "translating"));
  }
  return 0;
}

// What a file need not say: a flat face's line does not matter to it, that of two opposite rollers
// has one place, a face goes through its pivot unless its bounds say that it may be set off.
bool is_zero_by_default(TableReader& bounds, CamDimension dimension, const CamProblem& problem) {
  if (dimension == CamDimension::offset) {
    return problem.follower == FollowerType::translating_flat || has_opposite_roller(problem);
  }
  return dimension == CamDimension::face_offset && !bounds.has("face_offset");
}

void read_length(CamLengthTables& tables, CamDimension dimension, CamProblem& problem) {
  const std::string_view key = to_string(dimension);
  const FollowerType type = problem.follower;
  CamLength& length = problem.length(dimension);
  length.used = is_used(dimension, type);
  if (!length.used) {
    if (is_followers(dimension)) refuse(tables.follower, dimension, type);
    refuse(tables.mechanism, dimension, type);
    refuse(tables.bounds, dimension, type);
    return;
  }
  TableReader& table = table_of(tables, dimension);
  length.bounds = read_bounds(tables.bounds, dimension);
  length.given = read_given(table, dimension, type);
  if (!table.has(key) && is_zero_by_default(tables.bounds, dimension, problem)) length.given = 0;
  if (!length.given) return;
  const auto& [min, max] = length.bounds;
  if (*length.given >= min && *length.given <= max) return;
  table.fault(key, fmt::format("is {}, outside its bounds; {} allows [{}, {}]", *length.given,
                               tables.bounds.name(key), min, max));
}

void check_opposite_roller(CamLengthTables& tables, const CamProblem& problem) {
  const double offset = problem.length(CamDimension::offset).given.value_or(0);
  if (!has_opposite_roller(problem) || offset == 0) return;
  tables.mechanism.fault("offset",
                         fmt::format("is {}, but the second roller of closure = "
                                     "\"constant-breadth\" would stand at the other side of the "
                                     "cam's centre; expected 0",
                                     offset));
}

void check_offset(CamLengthTables& tables, const CamProblem& problem) {
  const auto& base = problem.length(CamDimension::base_radius).given;
  const auto& offset = problem.length(CamDimension::offset).given;
  if (!base || !offset || std::abs(*offset) < *base) return;
  tables.mechanism.fault(
      "offset", fmt::format("is {}, so that the follower's line passes the base circle "
                            "of radius {} without meeting it; expected less than {} of either "
                            "sign",
                            *offset, *base, *base));
}

void check_roller(CamLengthTables& tables, const CamProblem& problem) {
  const auto& base = problem.length(CamDimension::base_radius).given;
  const auto& roller = problem.length(CamDimension::roller_radius).given;
  if (!base || !roller || *roller < *base) return;
  table_of(tables, CamDimension::roller_radius)
      .fault("roller_radius",
             fmt::format("is {}, and base_radius, of the roller's centre, is {}, so that nothing "
                         "is left of the cam; expected less than {}",
                         *roller, *base, *base));
}

// `start`: the angle at the pivot between the arm or face and the cam's centre on the base circle.
void check_swing(CamLengthTables& tables, const CamProblem& problem, double start, double limit) {
  const double end = start + greatest_rise(problem.motion);
  if (end < limit) return;
  tables.mechanism.fault(
      "centre_distance",
      fmt::format(
          "and the other lengths put the follower at {:.6g} degrees from the line of centres on "
          "the base circle and at {:.6g} when it has risen; expected less than {}",
          degrees(start), degrees(end), degrees(limit)));
}

void check_arm(CamLengthTables& tables, const CamProblem& problem) {
  const auto& base = problem.length(CamDimension::base_radius).given;
  const auto& centre = problem.length(CamDimension::centre_distance).given;
  const auto& arm = problem.length(CamDimension::arm).given;
  if (!base || !centre || !arm) return;
  const double least = std::abs(*centre - *arm), most = *centre + *arm;
  if (*base <= least || *base >= most) {
    tables.mechanism.fault(
        "base_radius",
        fmt::format("is {}, but an arm of {} about a pivot {} from the cam's centre carries its "
                    "{} from {} to {} from there; expected a base radius between these",
                    *base, *arm, *centre, is_knife(problem.follower) ? "edge" : "roller", least,
                    most));
    return;
  }
  const double up = (*base - least) * (*base + least), down = (most - *base) * (most + *base);
  check_swing(tables, problem, 2 * std::atan2(std::sqrt(up), std::sqrt(down)), kPi);
}

void check_face(CamLengthTables& tables, const CamProblem& problem) {
  const auto& base = problem.length(CamDimension::base_radius).given;
  const auto& centre = problem.length(CamDimension::centre_distance).given;
  const auto& offset = problem.length(CamDimension::face_offset).given;
  if (!base || !centre || !offset) return;
  const double sine = (*base + *offset) / *centre;
  if (!(std::abs(sine) < 1)) {
    tables.mechanism.fault(
        "base_radius",
        fmt::format("is {} with a face_offset of {}, so that a face about a pivot {} from the "
                    "cam's centre cannot touch the base circle; expected a sum of less than {}",
                    *base, *offset, *centre, *centre));
    return;
  }
  check_swing(tables, problem, std::asin(sine), kRightAngle);
}

}  // namespace

void read_cam_lengths(CamLengthTables& tables, CamProblem& problem) {
  for (const auto& dimension : names<CamDimension>()) {
    read_length(tables, dimension.value, problem);
  }
  check_opposite_roller(tables, problem);
}

void check_cam_assembly(CamLengthTables& tables, const CamProblem& problem) {
  const FollowerType type = problem.follower;
  const double swing = is_oscillating(type) ? greatest_rise(problem.motion) : 0;
  if (swing >= kPi) {
    tables.follower.fault("type",
                          fmt::format("is \"{}\", which the motion swings by {:.6g} degrees; "
                                      "expected less than 180",
                                      to_string(type), degrees(swing)));
    return;
  }
  if (!is_oscillating(type) && !is_flat(type)) check_offset(tables, problem);
  if (!is_flat(type)) check_roller(tables, problem);
  if (has_arm(type)) check_arm(tables, problem);
  if (type == FollowerType::oscillating_flat) check_face(tables, problem);
}

}  // namespace cognate::problems::reading
