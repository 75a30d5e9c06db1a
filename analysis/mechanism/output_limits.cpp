#include "analysis/mechanism/output_limits.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

#include "analysis/mechanism/run_places.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate {
namespace {

/// Parts of the scale of the drive: places closer than this are one.
constexpr double kSameLimit = 1e-7;
/// An output slower than this part of what it might be stands still.
constexpr double kStanding = 1e-11;
/// Parts of its size to which an output is a cubic between samples.
constexpr double kCubic = 1e-9;
/// Samples in an assembly range at most, beside those at its places: of narrow parts of the motion
/// each takes some hundred, down to rounding.
constexpr std::size_t kMostRefined = 10'000;

/// An output as a function of the state.
struct Output {
  std::function<double(const FollowedMotion<1>&)> value;
  std::function<double(const FollowedMotion<1>&)> rate;
  bool is_angle = false;
};

double size(std::span<const BodyMotion<double, 1>> bodies) {
  double size = 0;
  for (const auto& body : bodies) {
    size = std::max({size, std::abs(body.origin[0].x), std::abs(body.origin[0].y)});
  }
  return size;
}

/// Goes through the assembly ranges and collects what the output does.
class Collector {
 public:
  Collector(const Mechanism<double>& mechanism, const AssemblyRanges& assembly_ranges,
            const Output& output)
      : motion_(mechanism, assembly_ranges), output_(output) {}

  std::optional<OutputRange> collect() {
    if (output_.is_angle) size_ = 1;
    for (const AssemblyRange& run : motion_.assembly_ranges().runs) sample(run);
    if (samples_.empty()) return std::nullopt;
    for (const AssemblyRange& run : motion_.assembly_ranges().runs) find_limits(run);
    order_limits();
    return std::move(range_);
  }

 private:
  struct Sample {
    double drive = 0;
    double value = 0;
    double rate = 0;
    const AssemblyRange* run = nullptr;
  };

  double rate(double drive) {
    ++range_.evaluations;
    return motion_.move_to(drive) ? output_.rate(motion_)
                                  : std::numeric_limits<double>::quiet_NaN();
  }

  /// The output's value where the motion stands, an angle counted on from `reference`.
  double value_near(double reference) const { return counted(reference, output_.value(motion_)); }

  void sample(const AssemblyRange& run) {
    std::vector<Sample> found;
    for (const double drive : run_places(motion_.assembly_ranges(), run)) {
      const bool is_end = drive == run.from || drive == run.to;
      const auto next = at(run, drive);
      if (next) {
        found.push_back(*next);
      } else if (const auto limit = is_end ? limit_at_end(run, drive) : std::nullopt) {
        found.push_back(*limit);
      }
    }
    refine(found);
    for (const Sample& sample : found) add(sample);
  }

  std::optional<Sample> at(const AssemblyRange& run, double drive) {
    ++range_.evaluations;
    if (!motion_.move_to(drive)) return std::nullopt;
    if (!output_.is_angle) size_ = std::max(size_, size(motion_.bodies()));
    return Sample{drive, output_.value(motion_), output_.rate(motion_), &run};
  }

  /// At an end of `run` at which the position is not determined: the limit of the motion.
  std::optional<Sample> limit_at_end(const AssemblyRange& run, double end) {
    constexpr double kStep = 4e-6;  // beyond what FollowedMotion interpolates over
    const double step = (end == run.from ? 1 : -1) * kStep * motion_.assembly_ranges().scale;
    const auto near = at(run, end + step), far = at(run, end + 2 * step);
    if (!near || !far) return std::nullopt;
    const double rise = counted(near->value, far->value) - near->value;
    return Sample{end, near->value - rise, near->rate, &run};
  }

  /// `b` counted on from `a`.
  double counted(double a, double b) const {
    return output_.is_angle ? a + std::remainder(b - a, kTurn) : b;
  }

  /// A part of the drive between two samples, and by how much more than `kCubic` its middle lies
  /// beside the cubic through them.
  struct Gap {
    Sample from, middle, to;
    double excess = 0;
  };

  /// Between `a` and `b`; empty where rounding leaves no place or there is no position.
  std::optional<Gap> gap(const Sample& a, const Sample& b) {
    const double width = b.drive - a.drive;
    const double place = std::max(motion_.assembly_ranges().scale, std::abs(b.drive));
    if (!(width > kNoWidth * place)) return std::nullopt;
    if (!std::isfinite(a.rate) || !std::isfinite(b.rate)) return std::nullopt;
    const auto middle = at(*a.run, std::midpoint(a.drive, b.drive));
    if (!middle) return std::nullopt;
    const double here = counted(a.value, middle->value), end = counted(here, b.value);
    const double cubic = 0.5 * (a.value + end) + 0.125 * width * (a.rate - b.rate);
    const double rounding = kNoWidth * place * std::abs(middle->rate);
    return Gap{a, *middle, b, std::abs(here - cubic) - kCubic * size_ - rounding};
  }

  /// Adds to `samples` what lies between them until the cubic through two neighbours is the output
  /// to `kCubic`: next to a change point it may make half a turn within 1e-12 of the drive. The
  /// largest gap comes first, so that those which are left when there are too many, as next to a
  /// position that is all but undetermined, are no larger than the rounding of what is seen.
  void refine(std::vector<Sample>& samples) {
    std::vector<Gap> open;
    const std::size_t most = samples.size() + kMostRefined;
    const auto look = [&](const Sample& from, const Sample& to) {
      const auto next = gap(from, to);
      if (!next) return;
      samples.push_back(next->middle);
      if (!(next->excess > 0)) return;
      open.push_back(*next);
      std::ranges::push_heap(open, {}, &Gap::excess);
    };
    const std::vector<Sample> places = samples;
    for (std::size_t i = 1; i < places.size(); ++i) look(places[i - 1], places[i]);
    while (!open.empty() && samples.size() < most) {
      std::ranges::pop_heap(open, {}, &Gap::excess);
      const Gap largest = open.back();
      open.pop_back();
      look(largest.from, largest.middle);
      look(largest.middle, largest.to);
    }
    std::ranges::sort(samples, {}, &Sample::drive);
  }

  void add(Sample next) {
    if (!samples_.empty()) next.value = counted(samples_.back().value, next.value);
    include({next.drive, next.value});
    if (samples_.empty()) range_.first = {next.drive, next.value};
    range_.last = {next.drive, next.value};
    samples_.push_back(next);
    // Next to a dead point the output is as fast as one likes, and says nothing of the rest.
    if (std::abs(next.rate) * motion_.assembly_ranges().scale < 1e3) {
      fastest_ = std::max(fastest_, std::abs(next.rate));
    }
  }

  void include(const OutputValue& at) {
    if (samples_.empty() || at.value < range_.least.value) range_.least = at;
    if (samples_.empty() || at.value > range_.greatest.value) range_.greatest = at;
  }

  void add_limit(double drive, double reference) {
    for (const OutputValue& limit : range_.limits) {
      if (std::abs(limit.drive - drive) <= kSameLimit * motion_.assembly_ranges().scale) return;
    }
    if (!motion_.move_to(drive)) return;
    const OutputValue limit{drive, value_near(reference)};
    range_.limits.push_back(limit);
    include(limit);
  }

  void find_limits(const AssemblyRange& run) {
    const double slow = kStanding * std::max(fastest_, size_ / motion_.assembly_ranges().scale);
    const Sample* last = nullptr;
    for (const Sample& s : samples_) {
      if (s.run != &run || !std::isfinite(s.rate)) continue;
      if (std::abs(s.rate) <= slow) {
        if (turns_back_at_end(run, s.drive)) add_limit(s.drive, s.value);
        continue;
      }
      if (last != nullptr && last->rate * s.rate < 0) {
        const auto f = [this](double drive) { return rate(drive); };
        const auto bracket = bracket_zero(f, last->drive, last->rate, s.drive, s.rate);
        add_limit(better_end(f, bracket), s.value);
      }
      last = &s;
    }
  }

  /// Whether the motion starts or ends at `drive`, where the output stands, and would turn back
  /// beyond: next to a simple zero the rate goes with the distance.
  bool turns_back_at_end(const AssemblyRange& run, double drive) {
    const bool at_from = drive == run.from && run.from_dyad < 0;
    const bool at_to = drive == run.to && run.to_dyad < 0;
    if (!at_from && !at_to) return false;
    const double step =
        (at_from ? 1e-3 : -1e-3) * std::min(motion_.assembly_ranges().scale, run.to - run.from);
    const double ratio = rate(drive + 2 * step) / rate(drive + step);
    return std::abs(ratio - 2) < 0.2;
  }

  void order_limits() {
    const AssemblyRanges& assembly_ranges = motion_.assembly_ranges();
    std::vector<OutputValue>& limits = range_.limits;
    std::ranges::sort(limits, {}, &OutputValue::drive);
    if (assembly_ranges.end < assembly_ranges.start) std::ranges::reverse(limits);
    const bool turns = !driven_by_length(motion_.mechanism().drive);
    if (turns && limits.size() > 1 &&
        std::abs(std::abs(limits.back().drive - limits.front().drive) - kTurn) < kSameLimit) {
      limits.pop_back();
    }
  }

  FollowedMotion<1> motion_;
  const Output& output_;
  std::vector<Sample> samples_;
  double fastest_ = 0;
  double size_ = 0;  ///< 1 for an angle
  OutputRange range_;
};

/// Whether `limits` holds the place `at`, but for whole turns.
bool is_limit(const std::vector<OutputValue>& limits, const OutputValue& at) {
  return std::ranges::any_of(limits, [&](const OutputValue& limit) {
    return std::abs(std::remainder(limit.drive - at.drive, kTurn)) <= kSameLimit;
  });
}

}  // namespace

std::optional<OutputRange> output_range(const Mechanism<double>& mechanism,
                                        const AssemblyRanges& assembly_ranges,
                                        const Travel& travel) {
  const Output output{
      [&](const FollowedMotion<1>& motion) { return travelled(travel, motion.bodies()); },
      [&](const FollowedMotion<1>& motion) { return travel_rate(travel, motion.bodies()); },
      !travel.slides};
  return Collector(mechanism, assembly_ranges, output).collect();
}

std::optional<OutputRange> output_range(const Mechanism<double>& mechanism,
                                        const AssemblyRanges& assembly_ranges,
                                        const Attached<double>& point, const Vec2d& direction) {
  const Output output{
      [&](const FollowedMotion<1>& motion) { return dot(motion.point(point)[0], direction); },
      [&](const FollowedMotion<1>& motion) { return dot(motion.point(point)[1], direction); },
      false};
  return Collector(mechanism, assembly_ranges, output).collect();
}

std::optional<double> time_ratio(const Mechanism<double>& mechanism,
                                 const AssemblyRanges& assembly_ranges, const OutputRange& output) {
  const bool turns = !driven_by_length(mechanism.drive);
  const bool is_whole =
      assembly_ranges.runs.size() == 1 && assembly_ranges.points.empty() &&
      std::abs(assembly_ranges.end - assembly_ranges.start) >= kTurn * (1 - 1e-12);
  const auto comes_round = [&](const AssemblyRange& run) {
    return groups_stand_alike(mechanism, run, run.from, run, run.from + kTurn);
  };
  if (!turns || !is_whole || !comes_round(assembly_ranges.runs[0]) ||
      !is_limit(output.limits, output.least) || !is_limit(output.limits, output.greatest)) {
    return std::nullopt;
  }
  const double advance = in_one_turn(output.greatest.drive - output.least.drive);
  const double longer = std::max(advance, kTurn - advance);
  return longer / (kTurn - longer);
}

}  // namespace cognate
