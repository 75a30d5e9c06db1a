#include "problems/cam/notes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "problems/basics/degrees.hpp"
#include "problems/cam/exact.hpp"
#include "problems/cam/extremes.hpp"
#include "problems/cam/second_contact.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

/// As many jumps as a reader will read.
constexpr std::size_t kMostJumps = 8;

void add_jumps(const CamResult& result, std::vector<std::string>& notes) {
  for (const int order : {1, 2}) {
    std::vector<cam::Jump> all;
    std::ranges::copy_if(result.jumps, std::back_inserter(all),
                         [order](const cam::Jump& jump) { return jump.order == order; });
    if (all.empty()) continue;
    std::string list;
    for (std::size_t i = 0; i < std::min(all.size(), kMostJumps); ++i) {
      list += fmt::format("{}{:.6g}° (from {:.4g} to {:.4g})", i > 0 ? ", " : "",
                          degrees(all[i].angle), all[i].before + 0.0, all[i].after + 0.0);
    }
    if (all.size() > kMostJumps) list += fmt::format(" and {} more", all.size() - kMostJumps);
    notes.push_back(order == 1
                        ? fmt::format("The velocity jumps at {}: an infinite acceleration, and a "
                                      "corner of the cam.",
                                      list)
                        : fmt::format("The acceleration jumps at {}: an infinite jerk.", list));
  }
}

/// Where limits leave a stroke or the other side of one free, and that leans more than a limit of
/// the same stroke, or than every limit, allows.
void add_other_side(const CamProblem& problem, const CamDesign& design,
                    std::vector<std::string>& notes) {
  const CamConstraints& c = problem.constraints;
  if (c.pressure_angle_max) return;
  const CamExtremes extremes(design.cam);
  ValueAt greatest;
  double strictest = 0;
  const auto add = [&](cam::MotionPart stretch, const std::optional<double>& both,
                       const std::optional<double>& working, double most) {
    const auto here = extremes.pressure_angle(stretch);
    const double limit = both ? *both : working.value_or(most);
    const bool beyond = !both && here && limit > 0 && here->value > limit * (1 + 1e-9);
    if (beyond && here->value > greatest.value) greatest = *here, strictest = limit;
  };
  const auto most_of = [](const std::optional<double>& a, const std::optional<double>& b) {
    return std::max(a.value_or(0), b.value_or(0));
  };
  const double rise = most_of(c.pressure_angle_max_rise, c.pressure_angle_max_rise_working);
  const double fall = most_of(c.pressure_angle_max_return, c.pressure_angle_max_return_working);
  add(cam::MotionPart::rises, c.pressure_angle_max_rise, c.pressure_angle_max_rise_working, fall);
  add(cam::MotionPart::falls, c.pressure_angle_max_return, c.pressure_angle_max_return_working,
      rise);
  if (strictest == 0) return;
  notes.push_back(fmt::format(
      "At {:.6g}° the pressure angle is {:.4g}°, on the side that the limits of rise and return do "
      "not count, or where they do not reach; pressure_angle_deg_max limits both sides everywhere.",
      degrees(greatest.angle), degrees(greatest.value)));
}

void add_cusp(const CamProblem& problem, const CamDesign& design, std::vector<std::string>& notes) {
  if (problem.constraints.curvature_radius_min != 0.0) return;
  const auto convex = CamExtremes(design.cam).convex_radius();
  const double size = design.cam.system.follower.dimensions.base_radius;
  if (!convex || std::abs(convex->value) > 1e-6 * size) return;
  if (is_knife(problem.follower)) return;
  notes.push_back(
      fmt::format("The profile comes to a point at {:.6g}°; curvature_radius_min keeps it rounder.",
                  degrees(convex->angle)));
}

/// A motion that goes below its beginning.
void add_dip(const CamDesign& design, std::vector<std::string>& notes) {
  const auto& programme = design.cam.programme;
  if (programme.lowest() >= -kCheckTolerance * programme.highest()) return;
  const bool swings = is_oscillating(design.cam.system.follower.type);
  const double dip = -programme.lowest();
  notes.push_back(fmt::format(
      "The motion goes {:.6g}{} below its beginning, and so the follower below the base circle.",
      swings ? degrees(dip) : dip, swings ? "°" : ""));
}

/// Limits of the pressure angle that a given or bounded base radius is too small for.
void add_size_missing(const CamProblem& problem, const CamDesign& design,
                      std::vector<std::string>& notes) {
  const bool broken = std::ranges::any_of(design.constraints, [](const ConstraintCheck& check) {
    return !check.satisfied && check.name.starts_with("pressure_angle");
  });
  if (!broken) return;
  CamProblem freer = problem;
  freer.objective = CamObjective::size;
  freer.free_motion.clear();
  freer.length(CamDimension::base_radius).given.reset();
  for (const auto dimension : {CamDimension::offset, CamDimension::centre_distance}) {
    freer.length(dimension).given.reset();
    freer.length(dimension).bounds = {-HUGE_VAL, HUGE_VAL};
  }
  const auto exact = exact_cam(freer, design.cam.programme);
  if (!exact) return;
  const auto& has = design.cam.system.follower.dimensions;
  const auto& wants = exact->dimensions;
  if (!(has.base_radius < wants.base_radius)) return;
  const bool swings = is_oscillating(problem.follower);
  notes.push_back(fmt::format(
      "The limits of the pressure angle need a base radius of at least {:.6g} (with {} {:.6g}), "
      "proved by half planes; here it is {:.6g}.",
      wants.base_radius, swings ? "the centre distance" : "the offset",
      swings ? wants.centre_distance : wants.offset, has.base_radius));
}

}  // namespace

std::optional<std::string> motion_impossibility(const CamProblem& problem,
                                                const cam::MotionProgramme& programme) {
  if (problem.second.closure == cam::Closure::constant_breadth) {
    const BreadthFault fault = breadth_fault(programme);
    if (std::abs(fault.deviation) > kCheckTolerance * programme.highest()) {
      return fmt::format(
          "Two parallel contacts need s(δ) + s(δ + 180°) to be constant; from its value at 0° it "
          "differs by {:.6g} at {:.6g}°. The second half turn must be the first one upside down.",
          fault.deviation, degrees(fault.angle));
    }
  }
  if (problem.follower != cam::FollowerType::oscillating_flat) return std::nullopt;
  const double sign = sign_of(problem.side);
  const auto fastest =
      turn_extremes(programme, cam::MotionPart::whole,
                    [sign](const cam::FollowerMotion<double>& m) { return -sign * m.velocity; });
  if (fastest->greatest.value < 1) return std::nullopt;
  return fmt::format(
      "At {:.6g}° the face swings {:.6g} times as fast as the cam turns, along with it: no profile "
      "can push it so. It must stay below 1; a longer or lower {} helps.",
      degrees(fastest->greatest.place.angle), fastest->greatest.value,
      problem.side == cam::ArmSide::trailing ? "return" : "rise");
}

std::vector<std::string> cam_notes(const CamProblem& problem, const CamResult& result) {
  std::vector<std::string> notes;
  add_jumps(result, notes);
  if (result.designs.empty()) return notes;
  add_dip(result.designs.front(), notes);
  add_other_side(problem, result.designs.front(), notes);
  add_cusp(problem, result.designs.front(), notes);
  add_size_missing(problem, result.designs.front(), notes);
  return notes;
}

}  // namespace cognate::problems
