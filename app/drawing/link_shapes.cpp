#include "app/drawing/link_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "problems/mechanism/driving_cylinder.hpp"
#include "problems/mechanism/joint_names.hpp"

namespace cognate::app {
namespace {

constexpr double kNowhere = -std::numeric_limits<double>::infinity();
constexpr int kGoldenSteps = 40;   // beyond them a maximum is flat to rounding
constexpr double kRoundUp = 1e-9;  // of a rail, for what golden section leaves

/// One block on its rail.
class Travel {
 public:
  Travel(const LinkShapes& shown, FollowedMotion<0>& motion, std::size_t bearer, const Rail& rail)
      : drive_(shown.poses.drive),
        motion_(motion),
        bearer_(bearer),
        traveller_(static_cast<std::size_t>(rail.traveller)),
        origin_(rail.from) {
    const Vec2d way = rail.to - rail.from;
    length_ = norm(way);
    if (length_ > 0) direction_ = (1 / length_) * way;
  }

  Rail stretched(const Rail& rail) {
    if (length_ == 0) return rail;
    const double beyond = std::max(0.0, farthest(1) - length_) + kRoundUp * length_;
    const double before = std::max(0.0, farthest(-1)) + kRoundUp * length_;
    return {rail.from - before * direction_, rail.to + beyond * direction_, rail.traveller};
  }

 private:
  /// How far the block comes along `side` times the direction of the rail.
  double farthest(double side) {
    const auto reach = [&](double drive) { return side * travelled(drive, side); };
    std::vector<double> at;
    for (const double drive : drive_) at.push_back(reach(drive));
    double greatest = *std::ranges::max_element(at);
    for (std::size_t k = 0; k < at.size(); ++k) {
      const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, at.size() - 1);
      if (at[k] == kNowhere || at[k] < at[before] || at[k] < at[after]) continue;
      const auto shortfall = [&](double drive) { return -reach(drive); };
      const auto peak = golden_section(shortfall, drive_[before], drive_[after], kGoldenSteps);
      greatest = std::max(greatest, -peak.least());
    }
    return greatest;
  }

  /// The block's place on the rail; so that it counts nowhere, −∞ times `side` where there is none.
  double travelled(double drive, double side) {
    if (!motion_.move_to(drive)) return side * kNowhere;
    const auto& bearer = motion_.bodies()[bearer_];
    const Vec2d way = motion_.bodies()[traveller_].origin[0] - bearer.origin[0];
    const double s = dot(conj(bearer.direction) * way - origin_, direction_);
    return std::isfinite(s) ? s : side * kNowhere;
  }

  const std::vector<double>& drive_;
  FollowedMotion<0>& motion_;
  std::size_t bearer_, traveller_;
  Vec2d origin_{}, direction_{1, 0};
  double length_ = 0;
};

/// Moves the ends of all rails of `shown`, which are places at samples, on to where the blocks turn
/// back between them: each rail is then no shorter than the stroke, and longer only by rounding.
/// `motion` is of the same linkage over the same drive.
void reach_slot_ends(LinkShapes& shown, FollowedMotion<0>& motion) {
  for (std::size_t i = 0; i < shown.links.size(); ++i) {
    BodyShape& shape = shown.links[i].shape;
    for (Rail& rail : shape.rails) {
      const Rail longer = Travel(shown, motion, i, rail).stretched(rail);
      std::ranges::replace(shape.outline, rail.from, longer.from);
      std::ranges::replace(shape.outline, rail.to, longer.to);
      rail = longer;
    }
  }
}

constexpr int kSamples = 721;

/// What is drawn of the drive, from its start: no more than two turns, after which every motion
/// repeats itself (that of an antiparallelogram takes two).
double shown_end(const LinkageScene& linkage) {
  const double start = linkage.problem.drive.start, end = linkage.problem.drive.end;
  if (is_driven_by_slider(linkage) || std::abs(end - start) <= 2 * kTurn) return end;
  return start + std::copysign(2 * kTurn, end - start);
}

class LinksMaker {
 public:
  explicit LinksMaker(const LinkageScene& linkage) : named_(linkage.problem.mechanism) {
    const double start = linkage.problem.drive.start, end = shown_end(linkage);
    shown_.poses = sample_poses(named_.mechanism, start, end, kSamples);
    const auto shapes = mechanism_shapes(named_, shown_.poses);
    for (std::size_t i = 0; i < shapes.bodies.size(); ++i) {
      shown_.links.push_back({named_.bodies[i], {}, shapes.bodies[i]});
    }
    FollowedMotion<0> motion(named_.mechanism, follow(named_.mechanism, start, end));
    reach_slot_ends(shown_, motion);
    if (problems::has_driving_cylinder(named_)) add_cylinder(motion.assembly_ranges());
  }

  LinkShapes make() {
    add_joints();
    add_points();
    return std::move(shown_);
  }

 private:
  void add_cylinder(const AssemblyRanges& motion) {
    if (motion.runs.empty()) return;
    CylinderLengths lengths{kInfinity, 0};
    for (const AssemblyRange& run : motion.runs) {
      lengths.least = std::min(lengths.least, run.from);
      lengths.greatest = std::max(lengths.greatest, run.to);
    }
    shown_.cylinder = lengths;
  }

  const BodyTrack& track(int link) const {
    return shown_.poses.bodies[static_cast<std::size_t>(link)];
  }

  bool is_placed(int link, std::size_t sample) const {
    return std::isfinite(track(link).x[sample]);
  }

  /// The place of another link's point in the axes of `link`; none where the two are never placed.
  std::optional<Vec2d> in_axes_of(int link, const Attached<double>& point) const {
    if (point.body == link) return point.at;
    for (std::size_t k = 0; k < shown_.poses.size(); ++k) {
      if (!is_placed(link, k) || !is_placed(point.body, k)) continue;
      const BodyTrack& body = track(link);
      const Vec2d direction{std::cos(body.angle[k]), std::sin(body.angle[k])};
      return conj(direction) *
             (place(track(point.body), k, point.at) - Vec2d{body.x[k], body.y[k]});
    }
    return std::nullopt;
  }

  void add_joints() {
    const auto list = joints(named_.mechanism).joints;
    const auto names = problems::joint_names(named_);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Joint& joint = list[i];
      shown_.joints.push_back({names[i], joint.type, joint.first, joint.second, joint.at});
      if (joint.type == JointType::prismatic) continue;
      for (const int link : {joint.first, joint.second}) {
        if (const auto at = in_axes_of(link, joint.at)) add_place(link, {names[i], *at, true});
      }
    }
  }

  void add_points() {
    for (const auto& point : named_.points) add_place(point.at.body, {point.name, point.at.at});
  }

  void add_place(int link, const LinkPlace& place) {
    auto& places = shown_.links[static_cast<std::size_t>(link)].places;
    const double tolerance = kOnePlace * (norm(place.at) + reach(places));
    const auto here = std::ranges::find_if(
        places, [&](const LinkPlace& other) { return norm(other.at - place.at) <= tolerance; });
    if (here == places.end()) places.push_back(place);
  }

  static double reach(const std::vector<LinkPlace>& places) {
    double most = 0;
    for (const auto& place : places) most = std::max(most, norm(place.at));
    return most;
  }

  const problems::NamedMechanism& named_;
  LinkShapes shown_;
};

}  // namespace

LinkShapes link_shapes(const LinkageScene& linkage) {
  return LinksMaker(linkage).make();
}

double size_of(const LinkShapes& shown) {
  Vec2d low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};
  for (std::size_t i = 0; i < shown.links.size(); ++i) {
    for (std::size_t k = 0; k < shown.poses.size(); ++k) {
      for (const auto& spot : shown.links[i].places) {
        const Vec2d at = place(shown.poses.bodies[i], k, spot.at);
        if (!std::isfinite(at.x) || !std::isfinite(at.y)) continue;
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
      }
    }
  }
  return low.x <= high.x ? 0.5 * std::max(high.x - low.x, high.y - low.y) : 0;
}

}  // namespace cognate::app
