#include "app/drawing/link_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/numbers/constants.hpp"
#include "app/drawing/slot_ends.hpp"
#include "problems/mechanism/joint_names.hpp"

namespace cognate::app {
namespace {

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
  }

  LinkShapes make() {
    add_joints();
    add_points();
    return std::move(shown_);
  }

 private:
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
