/// The family of quick-return crank-rockers, and the one that transmits best.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "synthesis/exact/quick_return/arc.hpp"

namespace cognate::synthesis {
namespace {

constexpr int kMostSteps = 200;  // bisection alone settles a double in fewer
/// A margin that rounding explains.
constexpr double kTouches = 1e-12;

/// A part of an arc, as values of q.
struct Part {
  double from = 0;
  double to = 0;
};

void narrow(Part& part, std::optional<double> one, std::optional<double> other) {
  if (!one || !other) return;
  part.from = std::max(part.from, std::min(*one, *other));
  part.to = std::min(part.to, std::max(*one, *other));
}

/// The part of the arc whose lengths lie within `bounds`; empty where from ≥ to.
Part part_within(const RockerArc& arc, const RockerBounds& bounds) {
  Part part{0, arc.end()};
  const double t = arc.angle().half_tangent();
  if (t == 0 && (arc.h() < bounds.crank.min || arc.h() > bounds.crank.max)) return {};
  narrow(part, arc.of_crank(bounds.crank.min), arc.of_crank(bounds.crank.max));
  narrow(part, arc.of_coupler(bounds.coupler.min), arc.of_coupler(bounds.coupler.max));
  const auto least = arc.of_frame(bounds.frame.min), most = arc.of_frame(bounds.frame.max);
  if (!least && (bounds.frame.min > arc.rocker() || bounds.frame.max < arc.rocker())) return {};
  narrow(part, least, most);
  return part;
}

/// q where r + r² + κ r³ = 1/sin²(θ/2): below it the transmission angle rises along the arc, beyond
/// it falls. Newton's steps within a bracket that halves where they leave it.
double stationary(const RockerArc& arc) {
  const double kappa = arc.kappa();
  const double s = arc.angle().half_sine;
  const auto excess = [&](double q) {
    const double r = 1 + q;
    return r * (1 + r * (1 + kappa * r)) - 1 / (s * s);
  };
  double low = 0, high = std::min(arc.end(), kappa >= 0 ? 1 / s : arc.end());
  double q = high;
  for (int i = 0; i < kMostSteps && low < high; ++i) {
    const double value = excess(q);
    (value < 0 ? low : high) = q;
    const double r = 1 + q;
    double next = q - value / (1 + r * (2 + 3 * kappa * r));
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == q || next == low || next == high) break;
    q = next;
  }
  return q;
}

/// A linkage of an arc, and by how much it satisfies link ratio and transmission angles: relative
/// to the ratio's limit, in radians; negative where it does not.
struct Member {
  double q = 0;
  double margin = 0;
  double transmission = 0;  ///< the least of μ and π − μ
};

Member member(const RockerArc& arc, const RockerBounds& bounds, double q) {
  const Lengths<double> links = lengths(arc.design(arc.at(q), -1).linkage);
  const auto [shortest, longest] =
      std::minmax({links.crank, links.coupler, links.rocker, links.frame});
  const TransmissionAngles angles = transmission_angles(links);
  const double margin =
      std::min({1 - longest / shortest / bounds.link_ratio_max,
                angles.min - bounds.transmission_min, bounds.transmission_max - angles.max});
  return {q, margin, angles.acute_min};
}

/// Looks for the best linkage of a part of an arc by h/l₂, which is finite however far the pivot.
class PartSearch {
 public:
  PartSearch(const RockerArc& arc, const RockerBounds& bounds, const Part& part)
      : arc_(arc), bounds_(bounds), from_(share(part.from)), to_(share(part.to)) {
    if (part.from > 0) add(from_);
    for (int i = 0; i < kSamples; ++i) add(from_ + (to_ - from_) * ((i + 0.5) / kSamples));
    if (part.to < arc.end()) add(to_);
  }

  /// That satisfies the bounds and satisfies `is_better` than all others that do; else the nearest.
  template <class Better>
  Member best(Better is_better) {
    add_peaks();
    Member best = members_.front();
    const auto take = [&](const Member& other) {
      const bool both = other.margin >= 0 && best.margin >= 0;
      if (both ? is_better(other, best) : other.margin > best.margin) best = other;
    };
    for (std::size_t i = 0; i < members_.size(); ++i) {
      take(members_[i]);
      if (i > 0 && keeps(i) != keeps(i - 1)) take(border(members_[i - 1], members_[i]));
    }
    return best;
  }

 private:
  static constexpr int kSamples = 256;

  static double share(double q) { return 1 / std::sqrt(1 + q); }
  bool keeps(std::size_t i) const { return members_[i].margin >= 0; }

  Member at(double w) const { return member(arc_, bounds_, (1 - w) * (1 + w) / (w * w)); }
  void add(double w) { members_.push_back(at(w)); }

  /// The highest margins between samples, where these all fail: a narrow part may lie there.
  void add_peaks() {
    std::vector<Member> all;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      all.push_back(members_[i]);
      const bool first = i == 0, last = i + 1 == members_.size();
      if (keeps(i) || (!first && members_[i - 1].margin > members_[i].margin) ||
          (!last && members_[i + 1].margin > members_[i].margin)) {
        continue;
      }
      const Member top =
          peak(first ? from_ : share(members_[i - 1].q), last ? to_ : share(members_[i + 1].q));
      all.insert(top.q < members_[i].q ? all.end() - 1 : all.end(), top);
    }
    members_ = std::move(all);
  }

  /// The highest margin between two places, by the golden section.
  Member peak(double low, double high) const {
    constexpr double kGolden = 0.6180339887498949;
    constexpr int kSteps = 60;
    Member left = at(high - kGolden * (high - low)), right = at(low + kGolden * (high - low));
    for (int i = 0; i < kSteps; ++i) {
      if (left.margin > right.margin) {
        high = share(right.q);
        right = left;
        left = at(high - kGolden * (high - low));
      } else {
        low = share(left.q);
        left = right;
        right = at(low + kGolden * (high - low));
      }
    }
    return left.margin > right.margin ? left : right;
  }

  /// The last linkage that satisfies the bounds between one that does and one that does not.
  Member border(Member one, Member other) const {
    if (one.margin < 0) std::swap(one, other);
    for (int i = 0; i < kMostSteps; ++i) {
      const double w = 0.5 * (share(one.q) + share(other.q));
      const Member middle = at(w);
      if (middle.q == one.q || middle.q == other.q) break;
      (middle.margin >= 0 ? one : other) = middle;
    }
    return one;
  }

  const RockerArc& arc_;
  const RockerBounds& bounds_;
  double from_, to_;
  std::vector<Member> members_;
};

bool transmits_better(const Member& a, const Member& b) {
  return a.transmission > b.transmission;
}

bool has_shorter_coupler(const Member& a, const Member& b) {
  return a.q < b.q;
}

/// K = 1: q up to which the link ratio, of which the crank h is the shortest link, is `ratio`.
double end_by_ratio(const RockerArc& arc, double ratio) {
  const double rocker = arc.rocker() / arc.h();
  return std::min((ratio - 1) * (ratio + 1), (ratio - rocker) * (ratio + rocker));
}

Member best_without_return(const RockerArc& arc, const RockerBounds& bounds, const Part& part,
                           double free_ratio) {
  const bool unlimited = std::isinf(part.to) && std::isinf(bounds.link_ratio_max);
  const double ratio = unlimited ? free_ratio : bounds.link_ratio_max;
  const Part usual{part.from, std::min(part.to, end_by_ratio(arc, ratio))};
  if (usual.from < usual.to) {
    const Member longest = member(arc, bounds, usual.to);
    if (longest.margin >= -kTouches) return longest;
    const Member best = PartSearch(arc, bounds, usual).best(transmits_better);
    if (best.margin >= 0) return best;
  }
  return PartSearch(arc, bounds, part).best(has_shorter_coupler);
}

Member best_member(const RockerArc& arc, const RockerBounds& bounds, const Part& part) {
  const Member top = member(arc, bounds, std::clamp(stationary(arc), part.from, part.to));
  return top.margin >= 0 ? top : PartSearch(arc, bounds, part).best(transmits_better);
}

}  // namespace

double free_link_ratio(const RockerTask& task) {
  return std::max(10.0, 3 / std::sin(0.5 * task.swing));
}

RockerSolutions best_rockers(const RockerTask& task, const RockerBounds& bounds) {
  RockerSolutions found;
  for (const PivotArc side : {PivotArc::near, PivotArc::far}) {
    if (task.time_ratio == 1 && side == PivotArc::far) break;
    const RockerArc arc(task, side);
    const Part part = part_within(arc, bounds);
    if (!(part.from < part.to)) continue;
    const Member best = arc.angle().half_sine > 0
                            ? best_member(arc, bounds, part)
                            : best_without_return(arc, bounds, part, free_link_ratio(task));
    RockerSolutions images;
    add_pair(arc, arc.at(best.q), RockerGiven::coupler, images);
    if (images.designs.empty()) continue;
    const bool better = !found.designs.empty() && images.designs[0].transmission.acute_min >
                                                      found.designs[0].transmission.acute_min;
    found.designs.insert(better ? found.designs.begin() : found.designs.end(),
                         images.designs.begin(), images.designs.end());
  }
  return found;
}

std::vector<RockerFamilyPoint> rocker_family(const RockerTask& task, PivotArc side,
                                             const RockerBounds& bounds, int count) {
  std::vector<RockerFamilyPoint> family;
  const RockerArc arc(task, side);
  const Part part = part_within(arc, bounds);
  if (!(part.from < part.to)) return family;
  const double from = 1 / std::sqrt(1 + part.from), to = 1 / std::sqrt(1 + part.to);
  for (int i = 0; i < count; ++i) {
    const double w = from + (to - from) * ((i + 0.5) / count);
    const QuickReturnRocker design = arc.design(arc.at((1 - w) * (1 + w) / (w * w)), -1);
    const Lengths<double> links = lengths(design.linkage);
    if (!(links.crank > 0)) continue;
    family.push_back({links, design.linkage.pivot_a, transmission_angles(links).acute_min});
  }
  return family;
}

}  // namespace cognate::synthesis
