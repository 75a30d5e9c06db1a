#include "analysis/mechanism/assembly_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "analysis/mechanism/assembly_probe.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate {
namespace {

constexpr int kCellsPerTurn = 720;
/// Parts of the scale of the drive: changes of several dyads closer than this are one; and a start
/// this close to a change is on it.
constexpr double kSamePlace = 1e-7;
/// Of the scale and the drive's coordinate: a dead point is known to this.
constexpr double kSameEnd = 8 * std::numeric_limits<double>::epsilon();
/// What rounding makes of a discriminant next to a change of a dyad before, which is known there to
/// half the digits.
constexpr double kRoundingAtChange = 1e-7;

bool is_slide(const Dyad<double>& dyad) {
  return std::holds_alternative<Prp<double>>(dyad) || std::holds_alternative<Rpp<double>>(dyad);
}

/// Cuts the path of the drive into runs, dyad by dyad.
class Follower {
 public:
  Follower(const Mechanism<double>& mechanism, double start, double end,
           const std::function<bool()>& stop)
      : mechanism_(mechanism), stop_(stop), probe_(mechanism) {
    assembly_ranges_.start = start;
    assembly_ranges_.end = end;
    const auto [low, high] = with_drawn_positions();
    const double length = high - low;
    const bool is_length = driven_by_length(mechanism.drive);
    if (is_length && length > 0) assembly_ranges_.scale = length / kTurn;
    // Beyond both ends, so that a change there has two sides; by a part of a cell, so that round
    // angles, where much happens, are not among the places looked at.
    const double beyond = 0.618 * assembly_ranges_.scale * kTurn / kCellsPerTurn;
    const double sense = end < start ? -1 : 1;
    assembly_ranges_.runs.push_back(
        {.from = low - beyond,
         .to = high + beyond,
         .anchor = start + sense * 2 * kSamePlace * assembly_ranges_.scale,
         .sides = sides(mechanism),
         .changes = {},
         .tracks = {}});
  }

  AssemblyRanges follow() {
    for (int i = 0; i < static_cast<int>(mechanism_.dyads.size()); ++i) {
      const Dyad<double>& dyad = mechanism_.dyads[static_cast<std::size_t>(i)];
      if (std::holds_alternative<GroupRest>(dyad)) continue;
      const auto* group = std::get_if<Group>(&dyad);
      std::vector<AssemblyRange> runs;
      for (const AssemblyRange& run : assembly_ranges_.runs) {
        group ? cut_group(run, i, *group, runs) : cut(run, i, runs);
      }
      assembly_ranges_.runs = std::move(runs);
    }
    clip();
    collect_points();
    return std::move(assembly_ranges_);
  }

 private:
  struct Sample {
    double drive = 0;
    Closeness closeness;
    bool is_least = false;  ///< where the discriminant has a minimum

    bool closes() const { return closeness.margin > -closeness.rounding; }
    bool touches() const { return is_least && std::abs(closeness.margin) <= closeness.rounding; }
  };

  /// Where the drive is while `group` is drawn: of those of a drive that turns, the nearest to the
  /// start.
  double drawn_position(const Group& group) const {
    if (driven_by_length(mechanism_.drive)) return group.drive;
    const double start = assembly_ranges_.start;
    return start + std::remainder(group.drive - start, kTurn);
  }

  /// The ends of the motion; with groups beyond them a turn, or as far as where they are drawn,
  /// from where the motion may come.
  std::pair<double, double> with_drawn_positions() const {
    auto [low, high] = std::minmax({assembly_ranges_.start, assembly_ranges_.end});
    if (!has_groups(mechanism_)) return {low, high};
    if (!driven_by_length(mechanism_.drive)) return {low - kTurn, high + kTurn};
    for (const Dyad<double>& dyad : mechanism_.dyads) {
      const auto* group = std::get_if<Group>(&dyad);
      if (!group) continue;
      low = std::min(low, group->drive);
      high = std::max(high, group->drive);
    }
    return {low, high};
  }

  Sample sample(const AssemblyRange& run, double drive, int dyad) {
    Sample sample{drive, probe_.closeness(run, drive, dyad)};
    for (const Change& change : run.changes) {
      if (std::abs(change.drive - drive) > kSamePlace * assembly_ranges_.scale) continue;
      sample.closeness.rounding = std::max(sample.closeness.rounding, kRoundingAtChange);
    }
    return sample;
  }

  /// Places over `run` and the minima between them.
  std::vector<Sample> samples(const AssemblyRange& run, int dyad) {
    std::vector<Sample> found;
    for (const double drive : crowded(run.from, run.to, assembly_ranges_.cells(run))) {
      if (stop_ && stop_()) break;
      const Sample next = sample(run, drive, dyad);
      if (!std::isfinite(next.closeness.margin) || !std::isfinite(next.closeness.rate)) continue;
      if (!found.empty() && found.back().closeness.rate < 0 && next.closeness.rate > 0) {
        const auto rate = [&](double at) { return probe_.closeness(run, at, dyad).rate; };
        const Sample& last = found.back();
        const auto bracket =
            bracket_zero(rate, last.drive, last.closeness.rate, next.drive, next.closeness.rate);
        found.push_back(sample(run, better_end(rate, bracket), dyad));
        found.back().is_least = true;
      }
      found.push_back(next);
    }
    return found;
  }

  /// Where the dyad ceases to close between two samples, on the side where it closes.
  double limit(const AssemblyRange& run, int dyad, const Sample& closed, const Sample& open) {
    const double at_closed = closed.closeness.margin, at_open = open.closeness.margin;
    if (at_closed <= 0) return closed.drive;
    if (at_open >= 0) return open.drive;
    const auto margin = [&](double at) { return probe_.closeness(run, at, dyad).margin; };
    const bool ascends = closed.drive > open.drive;
    const auto [low, high] =
        ascends ? bracket_zero(margin, open.drive, at_open, closed.drive, at_closed)
                : bracket_zero(margin, closed.drive, at_closed, open.drive, at_open);
    return ascends ? high : low;
  }

  Change change_at(const AssemblyRange& run, int dyad, double drive) {
    const Reach reach = probe_.dyad_reach(run, drive, dyad);
    const double size = std::isfinite(reach.most) ? reach.most : reach.extent;
    const bool determined = reach.distance > kSamePlace * size;
    for (const Change& other : run.changes) {
      if (std::abs(other.drive - drive) <= kSamePlace * assembly_ranges_.scale) drive = other.drive;
    }
    return {drive, dyad, determined};
  }

  /// Adds what `dyad` leaves of `run` to `runs`.
  void cut(const AssemblyRange& run, int dyad, std::vector<AssemblyRange>& runs) {
    const std::vector<Sample> all = samples(run, dyad);
    std::vector<Change> changes;
    bool is_open = false;
    AssemblyRange part;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Sample& here = all[i];
      if (here.closes() && !is_open) {
        is_open = true;
        changes.clear();
        part.from = i == 0 ? run.from : limit(run, dyad, here, all[i - 1]);
        part.from_dyad = i == 0 ? run.from_dyad : dyad;
      }
      if (here.touches() && !is_slide(mechanism_.dyads[static_cast<std::size_t>(dyad)])) {
        changes.push_back(change_at(run, dyad, here.drive));
      }
      if (is_open && (!here.closes() || i + 1 == all.size())) {
        part.to = here.closes() ? run.to : limit(run, dyad, all[i - 1], here);
        part.to_dyad = here.closes() ? run.to_dyad : dyad;
        is_open = false;
        runs.push_back(finished(run, part, changes));
      }
    }
  }

  /// Where in `run` the drive is as while `group` is drawn, in every turn, the nearest to the start
  /// first.
  std::vector<double> drawn_positions(const Group& group, const AssemblyRange& run) const {
    const double drawn = drawn_position(group);
    const double turn = driven_by_length(mechanism_.drive) ? HUGE_VAL : kTurn;
    std::vector<double> all{drawn};
    for (double at = drawn + turn; at <= run.to; at += turn) all.push_back(at);
    for (double at = drawn - turn; at >= run.from; at -= turn) all.push_back(at);
    std::erase_if(all, [&](double at) { return at < run.from || at > run.to; });
    return all;
  }

  /// Adds the parts of `run` along which the group at `dyad` can be followed from where it is
  /// drawn. A range of more than a turn holds other places of the group in the turn after; the
  /// range from there begins where it ends.
  void cut_group(const AssemblyRange& run, int dyad, const Group& group,
                 std::vector<AssemblyRange>& runs) {
    std::vector<AssemblyRange> parts;
    for (const double drawn : drawn_positions(group, run)) {
      const auto holds = [&](const AssemblyRange& part) {
        return part.from <= drawn && drawn <= part.to;
      };
      if (std::ranges::any_of(parts, holds)) continue;
      auto track = track_group({mechanism_, run, assembly_ranges_.scale}, dyad, drawn, stop_);
      if (track) parts.push_back(tracked(run, dyad, std::move(*track), drawn, parts));
    }
    std::ranges::sort(parts, {}, &AssemblyRange::from);
    std::ranges::move(parts, std::back_inserter(runs));
  }

  /// The part of `run` along which the group at `dyad` is followed from `drawn`, as far as none of
  /// the `others` has it.
  AssemblyRange tracked(const AssemblyRange& run, int dyad, GroupTrack track, double drawn,
                        const std::vector<AssemblyRange>& others) const {
    AssemblyRange part;
    part.from = track.from();
    part.to = track.to();
    part.from_dyad = part.from > run.from ? dyad : run.from_dyad;
    part.to_dyad = part.to < run.to ? dyad : run.to_dyad;
    for (const AssemblyRange& other : others) {
      if (other.to < drawn && other.to > part.from) {
        part.from = other.to;
        part.from_dyad = -1;
      }
      if (other.from > drawn && other.from < part.to) {
        part.to = other.from;
        part.to_dyad = -1;
      }
    }
    AssemblyRange result = finished(run, part, {});
    result.tracks.push_back(std::make_shared<const GroupTrack>(std::move(track)));
    return result;
  }

  /// `part` of `run`, with the changes of the dyads before and its own.
  AssemblyRange finished(const AssemblyRange& run, const AssemblyRange& part,
                         const std::vector<Change>& changes) const {
    AssemblyRange result = part;
    const bool holds_anchor = part.from <= run.anchor && run.anchor <= part.to;
    const double entry = assembly_ranges_.end < assembly_ranges_.start ? part.to : part.from;
    result.anchor = holds_anchor ? run.anchor : entry;
    result.sides = sides_at(run, result.anchor);
    result.changes = changes;
    result.tracks = run.tracks;
    for (const Change& change : run.changes) {
      if (part.from <= change.drive && change.drive <= part.to) result.changes.push_back(change);
    }
    std::ranges::stable_sort(result.changes, {}, &Change::drive);
    return result;
  }

  /// Keeps what lies between the ends of the motion. A range that ends there but for rounding ends
  /// at its own dead point.
  void clip() {
    const double low = std::min(assembly_ranges_.start, assembly_ranges_.end);
    const double high = std::max(assembly_ranges_.start, assembly_ranges_.end);
    const double near = kSamePlace * assembly_ranges_.scale;
    std::vector<AssemblyRange> kept;
    for (AssemblyRange& run : assembly_ranges_.runs) {
      if (run.from < low - kSameEnd * (assembly_ranges_.scale + std::abs(low))) run.from_dyad = -1;
      if (run.to > high + kSameEnd * (assembly_ranges_.scale + std::abs(high))) run.to_dyad = -1;
      run.from = std::max(run.from, low);
      run.to = std::min(run.to, high);
      std::erase_if(run.changes, [&](const Change& change) {
        return change.drive < low - near || change.drive > high + near;
      });
      if (run.from <= run.to) kept.push_back(std::move(run));
    }
    assembly_ranges_.runs = std::move(kept);
  }

  void add_end(int dyad, double drive) {
    if (dyad < 0) return;
    const bool slides = is_slide(mechanism_.dyads[static_cast<std::size_t>(dyad)]);
    assembly_ranges_.points.push_back(
        {slides ? SpecialPositionKind::parallel_guides : SpecialPositionKind::dead_point, dyad,
         drive});
  }

  void collect_points() {
    for (const AssemblyRange& run : assembly_ranges_.runs) {
      add_end(run.from_dyad, run.from);
      for (const Change& change : run.changes) {
        assembly_ranges_.points.push_back({change.determined ? SpecialPositionKind::change_point
                                                             : SpecialPositionKind::undetermined,
                                           change.dyad, change.drive});
      }
      add_end(run.to_dyad, run.to);
    }
    if (assembly_ranges_.end < assembly_ranges_.start)
      std::ranges::reverse(assembly_ranges_.points);
  }

  const Mechanism<double>& mechanism_;
  const std::function<bool()>& stop_;
  AssemblyProbe probe_;
  AssemblyRanges assembly_ranges_;
};

}  // namespace

void sides_at(const AssemblyRange& run, double drive, std::span<double> sides) {
  std::ranges::copy(run.sides, sides.begin());
  const double low = std::min(run.anchor, drive), high = std::max(run.anchor, drive);
  for (const Change& change : run.changes) {
    double& side = sides[static_cast<std::size_t>(change.dyad)];
    if (low < change.drive && change.drive < high) side = -side;
  }
}

void sides_or_none_at(const AssemblyRange& run, double drive, std::span<double> sides) {
  sides_at(run, drive, sides);
  if (run.from_dyad >= 0 && drive == run.from) sides[static_cast<std::size_t>(run.from_dyad)] = 0;
  if (run.to_dyad >= 0 && drive == run.to) sides[static_cast<std::size_t>(run.to_dyad)] = 0;
}

std::vector<double> sides_at(const AssemblyRange& run, double drive) {
  std::vector<double> sides(run.sides.size());
  sides_at(run, drive, sides);
  return sides;
}

bool groups_stand_alike(const Mechanism<double>& mechanism, const AssemblyRange& a, double at_a,
                        const AssemblyRange& b, double at_b) {
  constexpr double kAlike = 1e-5;  // two assemblies are farther apart than this
  std::vector<BodyMotion<double, 0>> first(static_cast<std::size_t>(body_count(mechanism)));
  std::vector<BodyMotion<double, 0>> second = first;
  place_groups(a, at_a, std::span(first));
  place_groups(b, at_b, std::span(second));
  double size = 0, apart = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    size = std::max(size, norm(first[i].origin[0]));
    apart = std::max(apart, norm(first[i].origin[0] - second[i].origin[0]));
    if (norm(first[i].direction - second[i].direction) > kAlike) return false;
  }
  return apart <= kAlike * size;
}

int AssemblyRanges::cells(const AssemblyRange& run) const {
  const double cells = kCellsPerTurn * (run.to - run.from) / (kTurn * scale);
  return static_cast<int>(std::fmin(std::fmax(cells, 24.0), 1e6));  // 24 for no number
}

const AssemblyRange* AssemblyRanges::range_at(double drive) const {
  // A last step may end a rounding beyond the end of the motion.
  const double slack = 1e-12 * scale;
  for (const AssemblyRange& run : runs) {
    const double from = run.from_dyad < 0 ? run.from - slack : run.from;
    const double to = run.to_dyad < 0 ? run.to + slack : run.to;
    if (from <= drive && drive <= to) return &run;
  }
  return nullptr;
}

AssemblyRanges follow(const Mechanism<double>& mechanism, double start, double end,
                      const std::function<bool()>& stop) {
  return Follower(mechanism, start, end, stop).follow();
}

std::vector<DriveRange> ranges_over_a_turn(const Mechanism<double>& mechanism) {
  const AssemblyRanges assembly_ranges = follow(mechanism, 0, kTurn);
  std::vector<DriveRange> ranges;
  for (const AssemblyRange& run : assembly_ranges.runs) ranges.push_back({run.from, run.to});
  if (ranges.size() > 1 && ranges.front().from == 0 && ranges.back().to == kTurn) {
    ranges.back().to += ranges.front().to;
    ranges.erase(ranges.begin());
  }
  return ranges;
}

}  // namespace cognate
