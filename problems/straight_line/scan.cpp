#include "problems/straight_line/scan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "analysis/coupler_curve/narrowest_strip.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"
#include "problems/straight_line/model.hpp"

namespace cognate::problems {
namespace {

constexpr std::size_t kScanSamples = 144, kScanLeastCells = 3;
/// What is wider, or shorter, than the best by this factor is not gone on from.
constexpr double kScanWorse = 4;
/// Segments whose ends are no more cells apart are neighbours.
constexpr std::size_t kNeighbours = 5;

struct ScannedPair {
  std::size_t from = 0, to = 0;
  double value = 0;  ///< less is better
};

class SegmentScan {
 public:
  SegmentScan(const StraightLineProblem& problem, const LinkageSegment& linkage, double loose)
      : problem_(problem),
        loose_(loose),
        linkage_(linkage),
        motion_(linkage.type, linkage.dimensions, sign(linkage.assembly)) {}

  void look_at(const CrankRange& range, bool closed) {
    sample(range, closed);
    limit_cells(range, closed);
    pairs_.clear();
    for (std::size_t from = 0; from < starts_; ++from) {
      if (is_for_length()) {
        add_of_length(from);
      } else {
        add_longest(from);
      }
    }
    keep_best_of_neighbours();
  }

  std::vector<LinkageSegment> take(std::size_t most) {
    std::ranges::stable_sort(found_, {}, [](const auto& one) { return one.first; });
    std::vector<LinkageSegment> segments;
    for (auto& [value, segment] : found_) {
      if (segments.size() == most || value > kScanWorse * found_.front().first) break;
      segments.push_back(segment);
    }
    return segments;
  }

 private:
  bool is_for_length() const { return problem_.goal->length.has_value(); }

  /// The curve; of a closed one twice, so that segments may pass its first sample.
  void sample(const CrankRange& range, bool closed) {
    angles_ = crowded(range.from, range.to, static_cast<int>(kScanSamples));
    starts_ = angles_.size();
    if (closed) {
      starts_ = kScanSamples;
      angles_.resize(2 * kScanSamples - 1);
      for (std::size_t i = 0; i < angles_.size(); ++i) {
        angles_[i] = range.from + kTurn * static_cast<double>(i) / kScanSamples;
      }
    }
    curve_.clear();
    is_sound_.clear();
    for (const double angle : angles_) {
      const CouplerPoint<double> point = motion_.at(angle);
      curve_.push_back(point.at);
      is_sound_.push_back(point.closes && within_limits(point.transmission_cosine));
    }
  }

  bool within_limits(double cosine) const {
    Range limits{kDeadPointMargin, kPi - kDeadPointMargin};
    if (const auto& asked = problem_.constraints.transmission_angle) {
      limits = {std::max(limits.min, asked->min), std::min(limits.max, asked->max)};
    }
    constexpr double kSlack = 1e-3;
    return cosine <= std::cos(limits.min) + kSlack && cosine >= std::cos(limits.max) - kSlack;
  }

  void limit_cells(const CrankRange& range, bool closed) {
    least_ = kScanLeastCells;
    const bool slides = linkage_.type == MechanismType::slider_crank;
    most_ = closed ? kScanSamples / (slides ? 2 : 1) - 1 : angles_.size() - 1;
    const auto& turn = problem_.segment.crank_range;
    if (!turn) return;
    const double step = (closed ? kTurn : range.to - range.from) / kScanSamples;
    const auto cells = [step](double angle) { return static_cast<std::size_t>(angle / step); };
    // Cells of an open curve are crowded to its ends, there are more of them in an angle.
    if (closed) least_ = std::max(least_, cells(turn->min));
    most_ = std::min(most_, (closed ? 1 : 2) * cells(turn->max) + 1);
    least_ = std::min(least_, most_);
  }

  double chord(std::size_t from, std::size_t to) const { return norm(curve_[to] - curve_[from]); }

  NarrowestStrip strip_of(std::size_t from, std::size_t to) {
    room_.assign(curve_.begin() + static_cast<std::ptrdiff_t>(from),
                 curve_.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    return narrowest_(room_);
  }

  /// The last sample to which a segment from `from` may go; `from` where there is none.
  std::size_t last_from(std::size_t from) const {
    std::size_t last = from;
    if (!is_sound_[from]) return from;
    while (last + 1 < angles_.size() && last - from < most_ && is_sound_[last + 1]) ++last;
    return last;
  }

  /// Where the chord passes the length as one of the ends moves on; both together where the crank's
  /// turn is at its limit.
  void add_of_length(std::size_t from) {
    const std::size_t last = last_from(from);
    const double length = *problem_.goal->length;
    for (std::size_t to = from + least_; to <= last; ++to) {
      const double here = chord(from, to) - length;
      const auto passes = [&](std::size_t i, std::size_t j) {
        return (chord(i, j) - length) * here <= 0;
      };
      const std::size_t cells = to - from;
      const bool at_limit = cells == least_ || cells == most_;
      const bool is_one = (cells > least_ && passes(from, to - 1)) ||
                          (at_limit && from > 0 && is_sound_[from - 1] && passes(from - 1, to - 1));
      if (is_one) pairs_.push_back({from, to, strip_of(from, to).half_width});
    }
  }

  /// The longest from `from` on that is narrow enough: its width grows with it.
  void add_longest(std::size_t from) {
    const StraightLineGoal& goal = *problem_.goal;
    const auto is_narrow = [&](std::size_t to) {
      const double most =
          goal.deviation ? *goal.deviation : *goal.deviation_relative * chord(from, to);
      return strip_of(from, to).half_width <= loose_ * most;
    };
    std::size_t low = from + least_, high = last_from(from);
    if (high < low || !is_narrow(low)) return;
    while (low < high) {
      const std::size_t middle = (low + high + 1) / 2;
      if (is_narrow(middle)) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    const double length = chord(from, low);
    if (length > 0) pairs_.push_back({from, low, 1 / length});
  }

  void keep_best_of_neighbours() {
    std::ranges::stable_sort(pairs_, {}, &ScannedPair::value);
    std::vector<ScannedPair> kept;
    for (const ScannedPair& pair : pairs_) {
      const auto is_near = [&](const ScannedPair& other) {
        const auto apart = [this](std::size_t a, std::size_t b) {
          const std::size_t off = a > b ? a - b : b - a;
          return std::min(off % starts_, starts_ - off % starts_);
        };
        return apart(pair.from, other.from) <= kNeighbours &&
               apart(pair.to, other.to) <= kNeighbours;
      };
      if (std::ranges::any_of(kept, is_near)) continue;
      kept.push_back(pair);
      found_.emplace_back(pair.value, segment_of(pair));
      constexpr std::size_t kMost = 6;
      if (kept.size() == kMost) return;
    }
  }

  LinkageSegment segment_of(const ScannedPair& pair) {
    LinkageSegment segment = linkage_;
    const double from = angles_[pair.from], to = angles_[pair.to];
    segment.centre = 0.5 * (from + to);
    segment.reach = 0.5 * (to - from);
    NarrowestStrip strip = strip_of(pair.from, pair.to);
    const Vec2d ends = curve_[pair.to] - curve_[pair.from];
    if (dot(strip.direction, ends) < 0) strip.direction = -strip.direction;
    segment.line = std::atan2(strip.direction.y, strip.direction.x);
    segment.height = cross(strip.direction, strip.through);
    segment.length = problem_.goal->length.value_or(dot(strip.direction, ends));
    return segment;
  }

  const StraightLineProblem& problem_;
  double loose_;
  const LinkageSegment& linkage_;
  CouplerMotion<double> motion_;
  StripFinder narrowest_;
  std::vector<double> angles_;
  std::vector<Vec2d> curve_, room_;
  std::vector<bool> is_sound_;
  std::size_t starts_ = 0, least_ = 0, most_ = 0;
  std::vector<ScannedPair> pairs_;
  std::vector<std::pair<double, LinkageSegment>> found_;
};

}  // namespace

std::vector<LinkageSegment> scanned_segments(const StraightLineProblem& problem,
                                             const LinkageSegment& linkage, std::size_t most,
                                             double loose) {
  SegmentScan scan(problem, linkage, loose);
  const auto& [crank, coupler, third, frame] = linkage.dimensions.links;
  const auto look = [&](bool turns, const std::vector<CrankRange>& ranges) {
    for (const CrankRange& range : ranges) scan.look_at(range, turns);
  };
  if (linkage.type == MechanismType::slider_crank) {
    const SliderCrank slides{{}, crank, coupler, third, {1, 0}, linkage.assembly};
    look(crank_rotates(slides), crank_ranges(slides));
  } else {
    const Lengths<double> links{crank, coupler, third, frame};
    look(crank_rotates(links), crank_ranges(links));
  }
  return scan.take(most);
}

}  // namespace cognate::problems
