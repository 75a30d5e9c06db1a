/// @file The four-bar in a page. `four_bar` takes a linkage, the other calls evaluate it.
#include "analysis/linkage/four_bar.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "analysis/linkage/defects.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "app/drawing/design_motion.hpp"
#include "app/report/kernel/nearest.hpp"
#include "app/report/kernel/numbers.hpp"

namespace cognate::page {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

FourBar linkage;

/// Writes numbers one after the other.
class Writer {
 public:
  void put(double value) { out_[count_++] = value; }
  void put(const Vec2d& v) {
    put(v.x);
    put(v.y);
  }
  int count() const { return static_cast<int>(count_); }

 private:
  std::span<double> out_ = numbers();
  std::size_t count_ = 0;
};

std::vector<double> taken(int from, int count) {
  const auto given = numbers().subspan(static_cast<std::size_t>(from));
  return {given.begin(), given.begin() + count};
}

/// The part of the crank's ranges that is used; empty: all of them.
std::optional<CrankRange> used_range(std::span<const double> crank_angles, const Defects& defects,
                                     bool travels) {
  const Lengths<double> links = lengths(linkage);
  const bool turns = crank_rotates(links) && !(travels && is_change_point(links));
  if (turns || defects.circuit || defects.branch) return std::nullopt;
  return range_between(linkage, crank_angles);
}

}  // namespace

/// Takes a linkage: A, D, crank, coupler, rocker, sign of the assembly, whether there is a coupler
/// point, and that. Returns whether its links can be assembled.
COGNATE_EXPORT(four_bar) int take_four_bar() {
  const auto n = numbers();
  linkage = {.pivot_a = {n[0], n[1]},
             .pivot_d = {n[2], n[3]},
             .crank = n[4],
             .coupler = n[5],
             .rocker = n[6],
             .assembly = n[7] < 0 ? Assembly::crossed : Assembly::open,
             .coupler_point = {}};
  if (n[8] != 0) linkage.coupler_point = Vec2d{n[9], n[10]};
  return can_assemble(lengths(linkage)) ? 1 : 0;
}

/// Takes `count` crank angles at which the linkage is used (radians from the x axis), and after
/// them `travel` more between which it moves; `sequence` is one of Sequence. Gives class, excess of
/// Grashof's sum, whether it is a change point, whether the crank turns fully, least, greatest and
/// least acute transmission angle over the motion used (as problems/linkage/verify.hpp has it),
/// time ratio, the three defects, and from where to where that motion goes (from A→D; NaN: all of
/// it).
COGNATE_EXPORT(four_bar_quantities) int four_bar_quantities(int count, int travel, int sequence) {
  const Lengths<double> links = lengths(linkage);
  const auto stations = taken(0, count);
  const auto used = taken(0, count + travel);
  const Defects defects = find_defects(linkage, stations, static_cast<Sequence>(sequence));
  const auto range = used_range(used, defects, travel > 0);
  const auto angles = range ? transmission_angles(links, *range) : transmission_angles(links);
  Writer out;
  out.put(static_cast<double>(mobility_class(links)));
  out.put(grashof_excess(links));
  out.put(is_change_point(links));
  out.put(crank_rotates(links));
  out.put(angles.min);
  out.put(angles.max);
  out.put(angles.acute_min);
  out.put(time_ratio(links).value_or(kNone));
  out.put(defects.circuit);
  out.put(defects.branch);
  out.put(defects.order);
  out.put(range ? Vec2d{range->from, range->to} : Vec2d{kNone, kNone});
  return out.count();
}

/// Takes `count` crank angles (radians from the x axis). Gives for each B, C, the coupler point,
/// the rocker's angle and the transmission angle; NaN where the linkage does not close.
COGNATE_EXPORT(four_bar_poses) int four_bar_poses(int count) {
  const auto cranks = taken(0, count);
  const Motion motion(linkage);
  Writer out;
  for (const double crank : cranks) {
    const auto pose = motion.at(crank);
    out.put(pose ? pose->b : Vec2d{kNone, kNone});
    out.put(pose ? pose->c : Vec2d{kNone, kNone});
    out.put(pose ? pose->coupler_point.value_or(Vec2d{kNone, kNone}) : Vec2d{kNone, kNone});
    out.put(pose ? pose->rocker_angle : kNone);
    out.put(pose ? pose->transmission_angle : kNone);
  }
  return out.count();
}

/// Takes `count` targets, six numbers each: x and y, the coupler's angle, its weight (see Target),
/// the crank angle at which it is met now, and whether that is prescribed. Gives for each the
/// crank angle nearest to it from there, and the nearest over the turn, or where it is prescribed
/// that angle twice; where there is none, the present one.
COGNATE_EXPORT(four_bar_nearest) int four_bar_nearest(int count) {
  const auto given = taken(0, 6 * count);
  const Motion motion(linkage);
  Writer out;
  for (int i = 0; i < count; ++i) {
    const auto row = std::span(given).subspan(6 * static_cast<std::size_t>(i), 6);
    const Target target{{row[0], row[1]}, row[2], row[3]};
    const bool prescribed = row[5] != 0;
    out.put(prescribed ? row[4] : nearest_from(motion, target, row[4]));
    out.put(prescribed ? row[4] : nearest(linkage, motion, target).value_or(row[4]));
  }
  return out.count();
}

/// Takes `count` crank angles at which the linkage is used. Gives whether the crank turns fully,
/// then the crank and rocker angles of at most `samples` positions of its motion as a report draws
/// them. Returns how many positions.
COGNATE_EXPORT(four_bar_motion) int four_bar_motion(int count, int samples) {
  const auto stations = taken(0, count);
  const app::DesignMotion motion = app::sample_motion(linkage, stations, samples);
  Writer out;
  out.put(motion.full_turn);
  for (const double angle : motion.crank) out.put(angle);
  for (const double angle : motion.rocker) out.put(angle);
  return static_cast<int>(motion.crank.size());
}

}  // namespace cognate::page
