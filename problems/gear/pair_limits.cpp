#include "problems/gear/pair_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cognate::problems {
namespace {

using gear::PairGeometry;
using gear::SpurGear;
using gear::SpurPair;

/// Of gears that do not mesh, for which most demands have no meaning.
constexpr double kNoMesh = 1000;

}  // namespace

SpurPair section_of(const GearPairProblem& problem, const GearPairNumbers& numbers) {
  SpurPair pair;
  pair.centre_distance = numbers.centre_distance;
  for (std::size_t i = 0; i < 2; ++i) {
    SpurGear normal;
    normal.teeth = numbers.teeth[i];
    normal.module = numbers.module;
    normal.profile_shift = numbers.shift[i];
    normal.rack = problem.rack;
    normal.tip_reduction = problem.tip_reduction[i];
    pair.gears[i] = gear::transverse({normal, problem.helix, problem.face_width});
  }
  return pair;
}

bool can_mesh(const SpurPair& pair) {
  return pair.centre_distance > gear::sum_of_base_radii(pair.gears) &&
         std::ranges::all_of(pair.gears, [](const SpurGear& gear) {
           return gear::tooth_fault(gear) == gear::ToothFault::none;
         });
}

std::optional<PairGeometry> mesh_of(const SpurPair& pair) {
  return can_mesh(pair) ? std::optional(gear::geometry(pair)) : std::nullopt;
}

double GearLimit::violation() const {
  const double weight = kind == GearLimitKind::running ? 10 : 1;
  const double missing = (at_least ? bound - value : value - bound) / scale;
  if (std::isnan(missing) || missing == HUGE_VAL) return weight;
  return missing > 0 ? weight * missing / (1 + missing) : 0;
}

GearLimits::GearLimits(const GearPairProblem& problem, const GearPairNumbers& numbers,
                       const SpurPair& pair, const std::optional<PairGeometry>& mesh)
    : problem_(problem), numbers_(numbers), pair_(pair), mesh_(mesh) {
  const GearConstraints& c = problem_.constraints;
  add_bounds();
  if (!mesh_) {
    add_possibility();
    return;
  }
  at_least("contact_ratio_min", total_contact_ratio(problem_, numbers_.module, *mesh_),
           c.contact_ratio_min);
  add_backlash();
  add_gear(0);
  add_gear(1);
  if (c.sliding_max) at_most("sliding_max", greatest_sliding(*mesh_), *c.sliding_max);
}

void GearLimits::add_possibility() {
  constexpr const char* kTeeth[] = {"teeth.pinion", "teeth.wheel"};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto fault = gear::tooth_fault(pair_.gears[i]);
    if (fault == gear::ToothFault::none) continue;
    at_most(kTeeth[i], double(fault), 0, 1, GearLimitKind::running);
  }
  const double least = gear::sum_of_base_radii(pair_.gears);
  if (!(pair_.centre_distance > least)) {
    at_least("centre_distance", pair_.centre_distance, least, numbers_.module,
             GearLimitKind::running);
  }
}

void GearLimits::add_backlash() {
  at_least("backlash", mesh_->backlash, 0, numbers_.module, GearLimitKind::running);
  const bool is_tied =
      problem_.centre_distance && !(problem_.profile_shift[0] && problem_.profile_shift[1]);
  if (!is_tied) return;
  // Shifts within their bounds may not reach the centre distance; reported only then.
  const char* name = "mechanism.backlash";
  const double wanted = problem_.backlash.value_or(0);
  const double more = mesh_->backlash - wanted;
  const double slack = 1e-9 * numbers_.module;
  if (more > slack) at_most(name, mesh_->backlash, wanted, numbers_.module);
  if (more < -slack && wanted > 0) at_least(name, mesh_->backlash, wanted, numbers_.module);
}

void GearLimits::add_bounds() {
  const auto& shifts = problem_.profile_shift_bounds;
  constexpr const char* kShifts[] = {"bounds.profile_shift.pinion", "bounds.profile_shift.wheel"};
  for (std::size_t i = 0; i < 2; ++i) {
    if (problem_.profile_shift[i]) continue;
    at_least(kShifts[i], numbers_.shift[i], shifts.min);
    at_most(kShifts[i], numbers_.shift[i], shifts.max);
  }
  const auto& distances = problem_.centre_distance_bounds;
  if (!problem_.centre_distance) {
    const double scale = numbers_.module;
    if (distances.min > 0) {
      at_least("bounds.centre_distance", numbers_.centre_distance, distances.min, scale);
    }
    if (std::isfinite(distances.max)) {
      at_most("bounds.centre_distance", numbers_.centre_distance, distances.max, scale);
    }
  }
  if (problem_.ratio) {
    const double ratio = double(numbers_.teeth[1]) / numbers_.teeth[0];
    at_most("target.ratio_tolerance", std::abs(ratio / *problem_.ratio - 1),
            problem_.ratio_tolerance, 1, GearLimitKind::teeth);
  }
  if (problem_.constraints.hunting) {
    at_most("hunting", std::gcd(numbers_.teeth[0], numbers_.teeth[1]), 1, 1, GearLimitKind::teeth);
  }
}

void GearLimits::add_gear(std::size_t index) {
  struct Names {
    const char *tip, *undercut, *interference, *clearance;
  };
  constexpr Names kNames[] = {{"tip_thickness_min.pinion", "no_undercut.pinion",
                               "no_interference.pinion", "tip_clearance_min.pinion"},
                              {"tip_thickness_min.wheel", "no_undercut.wheel",
                               "no_interference.wheel", "tip_clearance_min.wheel"}};
  const Names& names = kNames[index];
  const GearConstraints& c = problem_.constraints;
  const SpurGear& own = pair_.gears[index];
  const double normal = std::cos(problem_.helix);
  const double module = numbers_.module;
  const double tip = gear::tip_radius(own);
  const double across = gear::helix_cosine(own, problem_.helix, tip) / module;
  const double thickness =
      tip >= gear::base_radius(own) ? gear::tooth_thickness(own, tip) * across : NAN;
  at_least(names.tip, thickness, c.tip_thickness_min);
  if (c.no_undercut) {
    at_least(names.undercut, numbers_.shift[index],
             gear::least_profile_shift(own.rack, own.teeth) / normal);
  }
  if (c.no_interference) {
    at_most(names.interference, mesh_->gears[index].interference / module, 0, 1,
            GearLimitKind::running);
  }
  at_least(names.clearance, mesh_->gears[index].tip_clearance / module,
           c.tip_clearance_min.value_or(0));
}

double GearLimits::violation() const {
  double sum = 0;
  for (const GearLimit& limit : all()) sum += limit.violation();
  return mesh_ ? sum : kNoMesh + sum;
}

double GearLimits::violation_of_teeth() const {
  double sum = 0;
  for (const GearLimit& limit : all()) {
    if (limit.kind == GearLimitKind::teeth) sum += limit.violation();
  }
  return sum;
}

double overlap_of(const GearPairProblem& problem, double module) {
  gear::HelicalGear gear{.helix = problem.helix, .face_width = problem.face_width};
  gear.normal.module = module;
  return gear::overlap_ratio(gear);
}

double total_contact_ratio(const GearPairProblem& problem, double module,
                           const PairGeometry& mesh) {
  return mesh.contact_ratio + overlap_of(problem, module);
}

double greatest_sliding(const PairGeometry& mesh) {
  double most = 0;
  for (const auto& own : mesh.gears) {
    most = std::max({most, std::abs(own.sliding_start), std::abs(own.sliding_end)});
  }
  return most;
}

}  // namespace cognate::problems
