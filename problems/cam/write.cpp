/// A cam problem written down, and checked by reading what was written.
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/cam/keys.hpp"
#include "problems/cam/read_raster.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

using cam::MotionLaw;
using cam::MotionSegment;

/// The range in which a number of a segment is free; null where it is not.
const Range* free_range(const CamProblem& problem, std::size_t segment, MotionParameter parameter) {
  for (const FreeMotionParameter& free : problem.free_motion) {
    if (free.segment == segment && free.parameter == parameter) return &free.range;
  }
  return nullptr;
}

/// The angle, in degrees, of which the reader makes the share `at` of a segment.
double place_deg(double at, double over) {
  const double nearest = degrees(at * over);
  double low = nearest, high = nearest;
  for (int i = 0; i < 8; ++i) {  // rounding is a few units in the last place
    if (low * kDegree / over == at) return low;
    if (high * kDegree / over == at) return high;
    low = std::nextafter(low, 0.0);
    high = std::nextafter(high, 360.0);
  }
  return nearest;
}

/// A displacement in the file's unit.
Node displacement_node(double displacement, bool oscillating) {
  return oscillating ? node_deg(displacement) : node(displacement);
}

Array written_conditions(const MotionSegment& segment, bool oscillating) {
  const std::array<std::string_view, 4> keys{oscillating ? "displacement_deg" : "displacement",
                                             "velocity", "acceleration", "jerk"};
  Array rows;
  for (const auto& [at, order, value] : segment.conditions) {
    TableWriter row;
    row.set("at_deg", place_deg(at, segment.over));
    const auto index = static_cast<std::size_t>(order);
    if (index < keys.size()) {
      row.add(keys.at(index), displacement_node(value, oscillating && order == 0));
    }
    rows.push_back(node(row));
  }
  return rows;
}

void write_spline(const MotionSegment& segment, bool oscillating, TableWriter& table) {
  Array points;
  for (const auto& [at, displacement] : segment.points) {
    points.push_back(node(
        Array{node(place_deg(at, segment.over)), displacement_node(displacement, oscillating)}));
  }
  table.set("points", points).set("degree", segment.degree);
  const cam::SplineEnds& ends = segment.ends;
  if (ends.periodic) {
    table.set("periodic", true);
    return;
  }
  table.set("velocity", std::array{ends.velocity_begin, ends.velocity_end});
  if (segment.degree != 5) return;
  table.set("acceleration", std::array{ends.acceleration_begin, ends.acceleration_end});
}

TableWriter segment_writer(const CamProblem& problem, std::size_t index) {
  const MotionSegment& segment = problem.motion[index];
  const bool oscillating = is_oscillating(problem.follower);
  TableWriter table;
  table.set_name("law", segment.law);
  const Range* over = free_range(problem, index, MotionParameter::over);
  table.add("over_deg", over ? node_deg(*over) : node_deg(segment.over));
  if (segment.law != MotionLaw::dwell || segment.rise != 0) {
    table.add(oscillating ? "rise_deg" : "rise", displacement_node(segment.rise, oscillating));
  }
  if (segment.law == MotionLaw::universal) {
    const auto share = [&](MotionParameter parameter, double value) {
      const Range* range = free_range(problem, index, parameter);
      table.add(to_string(parameter), range ? node(*range) : node(value));
    };
    share(MotionParameter::sine, segment.shape.sine);
    share(MotionParameter::constant, segment.shape.constant);
    share(MotionParameter::cosine, segment.shape.cosine);
  }
  if (segment.law == MotionLaw::polynomial) {
    table.set("conditions", written_conditions(segment, oscillating));
  }
  if (segment.law == MotionLaw::spline) write_spline(segment, oscillating, table);
  return table;
}

/// Zeros are written where forces are known of, and left out where nothing presses.
void write_force(TableWriter& table, std::string_view key, double value, bool known) {
  if (known || value != 0) table.set(key, value);
}

TableWriter written_follower(const CamProblem& problem) {
  const bool oscillating = is_oscillating(problem.follower);
  TableWriter table;
  table.set_name("type", problem.follower);
  if (oscillating) table.set_name("side", problem.side);
  table.set_name("closure", problem.second.closure)
      .set("breadth", problem.second.breadth)
      .set_deg("arms_deg", problem.second.arms_angle);
  const cam::Operation& operation = problem.operation;
  write_force(table, oscillating ? "inertia" : "mass", operation.inertia, false);
  write_force(table, "spring_rate", operation.spring_rate, problem.has_operation);
  // A form closed follower has the preload 0, whether anything else presses it or not.
  const bool formal = problem.second.closure != cam::Closure::force && problem.preload == 0.0;
  if (problem.has_operation || !formal) table.set("preload", problem.preload);
  write_force(table, "load", operation.load, problem.has_operation);
  return table;
}

TableWriter written_constraints(const CamProblem& problem) {
  const CamConstraints& given = problem.constraints;
  TableWriter table;
  write_keys(given, kPressureAngleKeys, table)
      .set("curvature_radius_min", given.curvature_radius_min)
      .set("no_undercut", given.curvature_radius_min.has_value());
  write_keys(given, kProfileKeys, table);
  const bool may_separate = problem.has_operation && problem.second.closure == cam::Closure::force;
  if (may_separate) table.set("no_separation", given.no_separation);
  return table;
}

/// Whether bounds say more than that lengths are positive; that a face's offset has any says that
/// it is free.
bool says_anything(CamDimension dimension, const CamLength& length) {
  const auto& [min, max] = length.bounds;
  if (std::isnan(min) || std::isnan(max)) return true;
  const bool is_face_offset = dimension == CamDimension::face_offset;
  if (is_face_offset && length.used && !length.given) return true;
  const bool is_signed = is_face_offset || dimension == CamDimension::offset;
  return std::isfinite(max) || (is_signed ? std::isfinite(min) : min > 0);
}

/// Of a length that is given or that the follower does not have, bounds nobody gave.
bool are_untouched(const CamLength& length) {
  return (length.given || !length.used) && length.bounds.min == 0 && length.bounds.max == 0;
}

void write_lengths(const CamProblem& problem, TableWriter& document) {
  TableWriter mechanism, bounds;
  for (const auto& [key, dimension] : names<CamDimension>()) {
    const CamLength& length = problem.length(dimension);
    mechanism.set(key, length.given);
    if (says_anything(dimension, length) && !are_untouched(length)) {
      bounds.set(key, length.bounds);
    }
  }
  mechanism.set("rotation", problem.clockwise ? "cw" : "ccw");
  document.set("mechanism", mechanism).set("bounds", bounds);
}

/// Materials of which the sum of moduli could have been made.
ContactMaterials equivalent_materials(double modulus_sum) {
  constexpr double kPoisson = 0.3;
  const double elasticity = 2 * (1 - kPoisson * kPoisson) / modulus_sum;
  return {{elasticity, elasticity}, {kPoisson, kPoisson}};
}

void write_contact(const CamProblem& problem, TableWriter& document) {
  if (problem.operation.speed != 0) {
    document.set("drive", TableWriter{}.set("speed", problem.operation.speed));
  }
  if (!problem.materials && !problem.has_contact) return;
  const ContactMaterials materials =
      problem.materials.value_or(equivalent_materials(problem.operation.modulus_sum));
  document.set("contact", TableWriter{}
                              .set("width", problem.operation.width)
                              .set("elasticity", materials.elasticity)
                              .set("poisson", materials.poisson));
}

void check_free_motion(const CamProblem& problem, std::vector<std::string>& faults) {
  for (std::size_t i = 0; i < problem.free_motion.size(); ++i) {
    const std::size_t segment = problem.free_motion[i].segment;
    if (segment < problem.motion.size()) continue;
    faults.push_back(fmt::format("free_motion[{}] is of segment {}; expected one from 0 to {}",
                                 i + 1, segment, std::ssize(problem.motion) - 1));
  }
}

/// What the reader makes of what stands in the file.
void complete(const CamProblem& read, CamProblem& problem) {
  for (std::size_t i = 0; i < kCamDimensions; ++i) {
    CamLength& length = problem.lengths[i];
    const CamLength& known = read.lengths[i];
    length.used = known.used;
    if (!length.given) length.given = known.given;
    length.bounds = known.bounds;
  }
  problem.has_operation = read.has_operation;
  problem.has_contact = read.has_contact;
  if (problem.materials) problem.operation.modulus_sum = read.operation.modulus_sum;
  problem.operation.preload = read.operation.preload;
  if (!problem.preload) problem.preload = read.preload;
  // A free number of a segment that lies outside its range is none that was chosen.
  for (const auto& [segment, parameter, range] : read.free_motion) {
    if (parameter != MotionParameter::over) continue;
    double& over = problem.motion[segment].over;
    if (!(over >= range.min && over <= range.max)) over = read.motion[segment].over;
  }
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<CamProblem>::written(const CamProblem& problem) {
  using namespace reading;
  Written all;
  check_free_motion(problem, all.faults);
  Array motion;
  for (std::size_t i = 0; i < problem.motion.size(); ++i) {
    motion.push_back(node(segment_writer(problem, i)));
  }
  TableWriter document = document_writer(kWord, problem.title, problem.length_unit);
  document.set("follower", written_follower(problem)).set("motion", motion);
  write_lengths(problem, document);
  document.set("target", TableWriter{}.set_name("objective", problem.objective))
      .set("constraints", written_constraints(problem));
  write_contact(problem, document);
  all.document =
      document.set("solve", solve_writer(problem.solve))
          .append(tolerance_table(problem.tolerances, cam::is_oscillating(problem.follower)))
          .append(cam_raster_table(problem))
          .take();
  return all;
}

tl::expected<CamProblem, std::vector<std::string>> KindTraits<CamProblem>::checked(
    const CamProblem& problem) {
  return reading::read_back(problem).map([&](const CamProblem& read) {
    CamProblem whole = problem;
    reading::complete(read, whole);
    return whole;
  });
}

}  // namespace cognate::problems
