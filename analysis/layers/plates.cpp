#include "analysis/layers/plates.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/joints.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/convex_hull.hpp"
#include "analysis/numbers/golden_section.hpp"

namespace cognate {
namespace {

constexpr double kOnePlace = 1e-9;  // of a size: what is nearer is one place
constexpr double kSameCorner = 1e-12;
constexpr int kWaySamples = 720;  // of a range
constexpr int kGoldenSteps = 40;  // beyond them an extreme is flat to rounding

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// A slide: what moves on it with its origin, and what carries it.
struct Slide {
  int slider = 0;
  int carrier = 0;
};

/// A turning joint in the axes of both of its bodies.
struct TurningJoint {
  int joint = 0;
  Attached<double> first{}, second{};
};

class PlatesMaker {
 public:
  PlatesMaker(const Mechanism<double>& mechanism, const AssemblyRanges& motion,
              std::span<const Attached<double>> points, const PlateSizes& sizes)
      : sizes_(sizes),
        points_(points),
        motion_(mechanism, motion),
        has_cylinder_(std::holds_alternative<DrivingRod<double>>(mechanism.drive)),
        corners_(index(body_count(mechanism))),
        rests_on_(corners_.size()),
        link_of_(corners_.size(), -1) {
    motion_.move_to(middle_of_longest());
    read_joints(joints(mechanism));
  }

  Plates make() {
    find_resting_blocks();
    collect_corners();
    for (std::size_t body = 1; body < corners_.size(); ++body) add_link(static_cast<int>(body));
    add_pins();
    for (const Slide& slide : slides_) {
      const int slider = link_of_[index(slide.slider)], carrier = link_of_[index(slide.carrier)];
      if (slider >= 0 && carrier >= 0) made_.slides.emplace_back(slider, carrier);
    }
    return std::move(made_);
  }

 private:
  double middle_of_longest() const {
    const auto& runs = motion_.assembly_ranges().runs;
    const auto longest = std::ranges::max_element(
        runs, {}, [](const AssemblyRange& run) { return run.to - run.from; });
    // Off the middle, where symmetric mechanisms may stand at a change point.
    return std::lerp(longest->from, longest->to, 0.4837);
  }

  Vec2d in_axes(int body, const Attached<double>& point) const {
    if (point.body == body) return point.at;
    const auto& axes = motion_.bodies()[index(body)];
    return conj(axes.direction) * (motion_.point(point)[0] - axes.origin[0]);
  }

  void read_joints(const JointList& list) {
    for (std::size_t i = 0; i < list.joints.size(); ++i) {
      const Joint& joint = list.joints[i];
      if (joint.type == JointType::prismatic) {
        const int slider = joint.at.body;
        slides_.push_back({slider, slider == joint.first ? joint.second : joint.first});
        continue;
      }
      turning_.push_back({static_cast<int>(i),
                          {joint.first, in_axes(joint.first, joint.at)},
                          {joint.second, in_axes(joint.second, joint.at)}});
      size_ = std::max({size_, norm(turning_.back().first.at), norm(turning_.back().second.at)});
    }
  }

  /// Blocks and sliders without a layer of their own rest on what carries their slide.
  void find_resting_blocks() {
    for (std::size_t body = 0; body < rests_on_.size(); ++body) {
      rests_on_[body] = static_cast<int>(body);
    }
    for (const Slide& slide : slides_) {
      const bool carries =
          std::ranges::find(slides_, slide.slider, &Slide::carrier) != slides_.end();
      if (!carries && turns_about_origin(slide.slider)) {
        rests_on_[index(slide.slider)] = slide.carrier;
      }
    }
    if (has_cylinder_) rests_on_[index(kDrivingRod)] = kDrivingCylinder;
  }

  bool turns_about_origin(int body) const {
    bool any = false;
    for (const TurningJoint& joint : turning_) {
      for (const Attached<double>& place : {joint.first, joint.second}) {
        if (place.body != body) continue;
        any = true;
        if (norm(place.at) > kOnePlace * size_) return false;
      }
    }
    return any;
  }

  void collect_corners() {
    const auto add = [&](const Attached<double>& place) {
      corners_[index(place.body)].push_back(place.at);
    };
    for (const TurningJoint& joint : turning_) {
      add(joint.first);
      add(joint.second);
    }
    for (const Attached<double>& point : points_) add(point);
    for (const Slide& slide : slides_) {
      add({slide.slider, {0, 0}});
      if (slide.carrier != 0 && !is_rod(slide.slider)) add_way(slide);
    }
  }

  /// Both ends of the way of a slider on the link that carries it, found as closely as an extreme
  /// can be.
  void add_way(const Slide& slide) {
    const Vec2d along = conj(motion_.bodies()[index(slide.carrier)].direction) *
                        motion_.bodies()[index(slide.slider)].direction;
    const Vec2d here = in_axes(slide.carrier, {slide.slider, {0, 0}});
    const double now = dot(here, along);
    double least = now, greatest = now;
    const double anchor = middle_of_longest();
    for (const double side : {1.0, -1.0}) {
      const auto shortfall = [&](double drive) {
        if (!motion_.move_to(drive)) return kInfinity;
        const double s = dot(in_axes(slide.carrier, {slide.slider, {0, 0}}), along);
        return std::isfinite(s) ? -side * s : kInfinity;
      };
      const double farthest = -least_of(shortfall);
      if (side > 0) greatest = std::max(greatest, farthest);
      if (side < 0) least = std::min(least, -farthest);
    }
    motion_.move_to(anchor);
    const double slack = kOnePlace * (greatest - least);
    for (const double s : {least - slack, greatest + slack}) {
      corners_[index(slide.carrier)].push_back(here + (s - now) * along);
    }
  }

  template <class Function>
  double least_of(const Function& function) const {
    double least = kInfinity;
    const std::vector<AssemblyRange> runs = motion_.assembly_ranges().runs;
    for (const AssemblyRange& run : runs) {
      std::vector<double> drives, values;
      for (int k = 0; k <= kWaySamples; ++k) {
        drives.push_back(k == kWaySamples ? run.to
                                          : std::lerp(run.from, run.to, 1.0 * k / kWaySamples));
        values.push_back(function(drives.back()));
        least = std::min(least, values.back());
      }
      for (std::size_t k = 0; k < drives.size(); ++k) {
        const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, drives.size() - 1);
        if (!(values[k] <= values[before] && values[k] <= values[after])) continue;
        const auto valley = golden_section(function, drives[before], drives[after], kGoldenSteps);
        least = std::min(least, valley.least());
      }
    }
    return least;
  }

  bool is_rod(int body) const { return has_cylinder_ && body == kDrivingRod; }

  void add_link(int body) {
    if (rests_on_[index(body)] != body) return;
    std::vector<Vec2d>& corners = corners_[index(body)];
    if (corners.empty()) return;
    double reach = 0;
    for (const Vec2d& corner : corners) reach = std::max(reach, norm(corner));
    link_of_[index(body)] = static_cast<int>(made_.links.size());
    made_.links.push_back({body, convex_hull(std::move(corners), kSameCorner * reach),
                           0.5 * sizes_.widths[index(body)]});
    if (!has_cylinder_ || body != kDrivingCylinder) return;
    for (const Vec2d& corner : corners_[index(kDrivingRod)]) {
      made_.links.back().others.push_back({kDrivingRod, corner});
    }
  }

  bool is_one_pin(const TurningJoint& a, const TurningJoint& b) const {
    for (const Attached<double>& p : {a.first, a.second}) {
      for (const Attached<double>& q : {b.first, b.second}) {
        if (p.body == q.body && norm(p.at - q.at) <= kOnePlace * size_) return true;
      }
    }
    return false;
  }

  void add_pins() {
    std::vector<bool> done(turning_.size(), false);
    for (std::size_t i = 0; i < turning_.size(); ++i) {
      if (done[i]) continue;
      std::vector<std::size_t> joined{i};
      done[i] = true;
      for (std::size_t next = 0; next < joined.size(); ++next) {
        for (std::size_t k = i + 1; k < turning_.size(); ++k) {
          if (done[k] || !is_one_pin(turning_[joined[next]], turning_[k])) continue;
          done[k] = true;
          joined.push_back(k);
        }
      }
      add_pin(joined);
    }
  }

  void add_pin(const std::vector<std::size_t>& joined) {
    const TurningJoint& joint = turning_[joined.front()];
    PlatePin pin;
    pin.joint = joint.joint;
    pin.disc = {joint.first.body, {joint.first.at}, 0.5 * sizes_.pin_diameter};
    for (const std::size_t one : joined) {
      for (const int body : {turning_[one].first.body, turning_[one].second.body}) {
        const int link = link_of_[index(rests_on_[index(body)])];
        if (rests_on_[index(body)] == 0) pin.on_base = true;
        if (link >= 0) pin.links.push_back(link);
      }
    }
    std::ranges::sort(pin.links);
    const auto [first, last] = std::ranges::unique(pin.links);
    pin.links.erase(first, last);
    if (pin.links.size() + (pin.on_base ? 1 : 0) >= 2) made_.pins.push_back(std::move(pin));
  }

  const PlateSizes& sizes_;
  std::span<const Attached<double>> points_;
  mutable FollowedMotion<0> motion_;
  bool has_cylinder_;
  std::vector<std::vector<Vec2d>> corners_;  ///< of each body
  std::vector<int> rests_on_;                ///< the body itself where it has a layer
  std::vector<int> link_of_;                 ///< of each body; −1 without one
  std::vector<Slide> slides_;
  std::vector<TurningJoint> turning_;
  double size_ = 0;
  Plates made_;
};

}  // namespace

Plates plates(const Mechanism<double>& mechanism, const AssemblyRanges& motion,
              std::span<const Attached<double>> points, const PlateSizes& sizes) {
  return PlatesMaker(mechanism, motion, points, sizes).make();
}

}  // namespace cognate
