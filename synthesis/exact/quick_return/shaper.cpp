#include "synthesis/exact/quick_return/shaper.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/output_limits.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

/// Whether the ram follows the bar without turning back: with ψ the bar's angle from the upright
/// and β the rod's from the ram's line, dx/dψ is proportional to cos(ψ + β), of one sign where
/// |ψ + β| < 90°. β falls and rises with cos ψ, so the sum is greatest within the swing or at its
/// end; it is bounded by the sum of both greatest angles, and looked at closely only beyond that.
bool keeps_sense(const Shaper& shaper, double half_swing) {
  constexpr double right_angle = kRightAngle;
  if (half_swing + shaper.pressure < right_angle) return true;
  constexpr int steps = 256;
  for (int i = -steps; i <= steps; ++i) {
    const double psi = half_swing * i / steps;
    const double lean = std::asin((shaper.ram_height - shaper.bar * std::cos(psi)) / shaper.rod);
    if (std::abs(psi + lean) >= right_angle) return false;
  }
  return true;
}

}  // namespace

ShaperSolution shaper(const ShaperTask& task) {
  const ReturnAngle angle = return_angle(task.time_ratio);
  if (angle.half_sine == 0) return {ShaperOutcome::no_swing, {}};
  Shaper found;
  found.frame = task.frame ? *task.frame : *task.crank / angle.half_sine;
  found.crank = task.crank ? *task.crank : *task.frame * angle.half_sine;
  found.bar = 0.5 * task.stroke / angle.half_sine;

  const double quarter_sine = std::sin(0.25 * angle.angle);
  const double quarter_cosine = std::cos(0.25 * angle.angle);
  const double half_rise = found.bar * quarter_sine * quarter_sine;
  found.ram_height = task.ram_height.value_or(found.bar * quarter_cosine * quarter_cosine);
  const double off_middle =
      task.ram_height ? std::abs(*task.ram_height - found.bar * quarter_cosine * quarter_cosine)
                      : 0;
  const double greatest = half_rise + off_middle;
  found.rod = task.rod ? *task.rod : greatest / std::sin(*task.pressure);
  if (!(found.rod > greatest)) return {ShaperOutcome::short_rod, found};
  found.pressure = std::asin(greatest / found.rod);
  const bool sound = keeps_sense(found, 0.5 * angle.angle);
  return {sound ? ShaperOutcome::solved : ShaperOutcome::overshoot, found};
}

ShaperOutcome judge(Shaper& shaper, double half_swing) {
  // The end of the bar stands highest upright and lowest at the limits.
  const double over = std::abs(shaper.ram_height - shaper.bar);
  const double under = std::abs(shaper.ram_height - shaper.bar * std::cos(half_swing));
  const double greatest = std::max(over, under);
  if (!(shaper.rod > greatest)) return ShaperOutcome::short_rod;
  shaper.pressure = std::asin(greatest / shaper.rod);
  return keeps_sense(shaper, half_swing) ? ShaperOutcome::solved : ShaperOutcome::overshoot;
}

Mechanism<double> as_mechanism(const Shaper& shaper) {
  const Rpr<double> bar{.block = {1, {shaper.crank, 0}}, .pivot = {0, {0, 0}}};
  const Rrp<double> ram{.point = {3, {shaper.bar, 0}},
                        .length = shaper.rod,
                        .guide = {.through = {0, shaper.ram_height}, .direction = {-1, 0}}};
  return {Crank<double>{{0, shaper.frame}, shaper.crank}, {bar, ram}};
}

std::optional<RamMotion> simulate(const Shaper& shaper) {
  constexpr int ram = 5;
  const Mechanism<double> mechanism = as_mechanism(shaper);
  const AssemblyRanges assembly_ranges = follow(mechanism, 0, kTurn);
  const auto range = output_range(mechanism, assembly_ranges, travels(mechanism)[ram]);
  if (!range) return std::nullopt;
  const auto ratio = time_ratio(mechanism, assembly_ranges, *range);
  if (!ratio) return std::nullopt;
  return RamMotion{range->stroke(), *ratio, in_one_turn(range->greatest.drive),
                   in_one_turn(range->least.drive)};
}

}  // namespace cognate::synthesis
