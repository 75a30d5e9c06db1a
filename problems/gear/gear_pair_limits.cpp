#include "problems/gear/gear_pair_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace cognate::problems {
namespace {

using gear::PairGeometry;
using gear::SpurGear;
using gear::SpurPair;

/// Of what is no number.
constexpr double kNoNumber = 1e9;

double sum_of_base_radii(const SpurPair& pair) {
  return gear::base_radius(pair.gears[0]) + gear::base_radius(pair.gears[1]);
}

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

std::optional<PairGeometry> mesh_of(const SpurPair& pair) {
  if (!(pair.centre_distance > sum_of_base_radii(pair))) return std::nullopt;
  for (const auto& gear : pair.gears) {
    if (gear::tooth_fault(gear) != gear::ToothFault::none) return std::nullopt;
  }
  return gear::geometry(pair);
}

double GearLimit::violation() const {
  if (std::isnan(value)) return kNoNumber;
  const double missing = (at_least ? bound - value : value - bound) / scale;
  return missing > 0 ? std::min(missing, kNoNumber) : 0;
}

GearLimits::GearLimits(const GearPairProblem& problem, const GearPairNumbers& numbers,
                       const SpurPair& pair, const std::optional<PairGeometry>& mesh)
    : problem_(problem), numbers_(numbers), pair_(pair), mesh_(mesh) {
  const GearConstraints& c = problem_.constraints;
  add_bounds();
  add_possibility();
  if (!mesh_) return;
  at_least("contact_ratio_min", total_contact_ratio(problem_, numbers_.module, *mesh_),
           c.contact_ratio_min);
  at_least("backlash", mesh_->backlash, 0, numbers_.module);
  add_gear(0);
  add_gear(1);
  if (c.sliding_max) at_most("sliding_max", greatest_sliding(*mesh_), *c.sliding_max);
}

void GearLimits::add_possibility() {
  constexpr const char* kTeeth[] = {"teeth.pinion", "teeth.wheel"};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto fault = gear::tooth_fault(pair_.gears[i]);
    if (fault != gear::ToothFault::none) at_most(kTeeth[i], double(fault), 0);
  }
  const double least = sum_of_base_radii(pair_);
  if (!(pair_.centre_distance > least)) {
    at_least("centre_distance", pair_.centre_distance, least, numbers_.module);
  }
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
            problem_.ratio_tolerance + 1e-12);
  }
  if (problem_.constraints.hunting) {
    at_most("hunting", std::gcd(numbers_.teeth[0], numbers_.teeth[1]), 1);
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
  const double thickness =
      tip >= gear::base_radius(own) ? gear::tooth_thickness(own, tip) / module : NAN;
  at_least(names.tip, thickness, c.tip_thickness_min);
  if (c.no_undercut) {
    at_least(names.undercut, numbers_.shift[index],
             gear::least_profile_shift(own.rack, own.teeth) / normal);
  }
  if (c.no_interference) {
    at_most(names.interference, mesh_->gears[index].interference, 0, module);
  }
  at_least(names.clearance, mesh_->gears[index].tip_clearance / module,
           c.tip_clearance_min.value_or(0));
}

double GearLimits::violation() const {
  double most = 0;
  for (const GearLimit& limit : all()) most = std::max(most, limit.violation());
  return most;
}

double total_contact_ratio(const GearPairProblem& problem, double module,
                           const PairGeometry& mesh) {
  const double overlap =
      problem.face_width * std::abs(std::sin(problem.helix)) / (std::numbers::pi * module);
  return mesh.contact_ratio + overlap;
}

double greatest_sliding(const PairGeometry& mesh) {
  double most = 0;
  for (const auto& own : mesh.gears) {
    most = std::max({most, std::abs(own.sliding_start), std::abs(own.sliding_end)});
  }
  return most;
}

}  // namespace cognate::problems
