#include "app/drawing/mechanism_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "analysis/mechanism/joints.hpp"
#include "analysis/numbers/convex_hull.hpp"

namespace cognate::app {
namespace {

/// Relative to the extent of a mechanism: what is nearer counts as one place.
constexpr double kSamePlace = 1e-9;

Vec2d direction_of(const BodyTrack& body, std::size_t k) {
  return {std::cos(body.angle[k]), std::sin(body.angle[k])};
}

/// The point of the plane `p` in the axes of `body` at sample k.
Vec2d in_axes(const BodyTrack& body, std::size_t k, const Vec2d& p) {
  return conj(direction_of(body, k)) * (p - Vec2d{body.x[k], body.y[k]});
}

/// Collects shapes body by body. Points are carried from body to body at a sample in which all
/// are placed.
class ShapeBuilder {
 public:
  ShapeBuilder(const problems::NamedMechanism& named, const MechanismPoses& poses)
      : named_(named), poses_(poses), points_(poses.bodies.size()) {
    shapes_.bodies.resize(poses.bodies.size());
  }

  MechanismShapes build() {
    add_joints();
    add_named_points();
    std::visit([this](const auto& drive) { add_drive(drive); }, named_.mechanism.drive);
    for (std::size_t i = 0; i < named_.mechanism.dyads.size(); ++i) {
      const int n = first_body(named_.mechanism, static_cast<int>(i));
      std::visit([&](const auto& dyad) { add_dyad(dyad, n); }, named_.mechanism.dyads[i]);
    }
    for (std::size_t body = 1; body < points_.size(); ++body) {
      shapes_.bodies[body].outline = convex_hull(points_[body], kSamePlace * extent(points_[body]));
    }
    return shapes_;
  }

 private:
  static double extent(const std::vector<Vec2d>& points) {
    double size = 0;
    for (const Vec2d& point : points) size = std::max({size, std::abs(point.x), std::abs(point.y)});
    return size;
  }

  const BodyTrack& track(int body) const { return poses_.bodies[static_cast<std::size_t>(body)]; }
  BodyShape& shape(int body) { return shapes_.bodies[static_cast<std::size_t>(body)]; }
  void add_point(int body, const Vec2d& at) {
    points_[static_cast<std::size_t>(body)].push_back(at);
  }

  /// A sample in which both bodies are placed.
  std::optional<std::size_t> sample_of(int a, int b) const {
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      if (std::isfinite(track(a).x[k]) && std::isfinite(track(b).x[k])) return k;
    }
    return std::nullopt;
  }

  /// Turning joints are points of both bodies and pins; a sliding one is a point of its slider.
  void add_joints() {
    for (const Joint& joint : joints(named_.mechanism).joints) {
      add_point(joint.at.body, joint.at.at);
      if (joint.type == JointType::prismatic) continue;
      const int other = joint.at.body == joint.first ? joint.second : joint.first;
      if (const auto k = sample_of(joint.at.body, other)) {
        const Vec2d place_now = place(track(joint.at.body), *k, joint.at.at);
        add_point(other, in_axes(track(other), *k, place_now));
      }
      add_pin({joint.at, joint.first == 0 || joint.second == 0});
    }
  }

  void add_pin(const Pin& pin) {
    const auto same = [&](const Pin& other) {
      return other.at.body == pin.at.body &&
             squared_norm(other.at.at - pin.at.at) <= kSamePlace * squared_norm(pin.at.at);
    };
    if (std::ranges::none_of(shapes_.pins, same)) shapes_.pins.push_back(pin);
  }

  void add_named_points() {
    for (const auto& point : named_.points) add_point(point.at.body, point.at.at);
  }

  /// Body `traveller` moves with its origin along a line of body `bearer`, which reaches to both
  /// ends of its way.
  void add_rail(int bearer, const Vec2d& through, const Vec2d& direction, int traveller) {
    add_rail(bearer, through, direction, Attached<double>{traveller, {}});
  }

  /// The same for a body that moves with the point `moving`.
  void add_rail(int bearer, const Vec2d& through, const Vec2d& direction,
                const Attached<double>& moving) {
    const int traveller = moving.body;
    double least = 0, greatest = 0;
    bool any = false;
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      if (!std::isfinite(track(traveller).x[k]) || !std::isfinite(track(bearer).x[k])) continue;
      const Vec2d there = place(track(traveller), k, moving.at);
      const double s = dot(in_axes(track(bearer), k, there) - through, direction);
      least = any ? std::min(least, s) : s;
      greatest = any ? std::max(greatest, s) : s;
      any = true;
    }
    if (!any) return;
    const Rail rail{through + least * direction, through + greatest * direction, traveller};
    shape(bearer).rails.push_back(rail);
    add_point(bearer, rail.from);
    add_point(bearer, rail.to);
  }

  void add_guide(const Guide<double>& guide, int slider) {
    add_rail(guide.body, guide.through + guide.offset * perp(guide.direction), guide.direction,
             slider);
    shape(slider).block = true;
  }

  void add_drive(const Crank<double>&) {}
  void add_drive(const DrivingSlider<double>& slider) { add_guide(slider.guide, 1); }
  void add_drive(const FloatingLink<double>& link) {
    add_guide(link.first, 2);
    add_guide(link.second, 3);
  }

  /// The cylinder reaches almost to where the rod's pin comes nearest, the rod from its pin into
  /// the cylinder.
  void add_drive(const DrivingRod<double>&) {
    constexpr double kCylinder = 0.9, kWithin = 0.85, kRod = 0.95;
    std::optional<double> least, greatest;
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      if (!std::isfinite(track(1).x[k])) continue;
      least = std::min(least.value_or(poses_.drive[k]), poses_.drive[k]);
      greatest = std::max(greatest.value_or(poses_.drive[k]), poses_.drive[k]);
    }
    if (!least) return;
    add_point(2, {kCylinder * *least, 0});
    add_point(1, {-std::min(kRod * *least, *greatest - kWithin * *least), 0});
  }

  void add_dyad(const Rrr<double>&, int) {}
  void add_dyad(const Cylinder<double>&, int) {}
  void add_dyad(const Rrp<double>& dyad, int n) { add_guide(dyad.guide, n + 1); }
  void add_dyad(const Prp<double>& dyad, int n) {
    add_guide(dyad.first, n);
    add_guide(dyad.second, n + 1);
  }

  void add_dyad(const Rpr<double>& dyad, int n) {
    shape(n).block = true;
    add_rail(n + 1, {0, dyad.offset}, {1, 0}, n);
  }

  void add_dyad(const Rpp<double>& dyad, int n) {
    add_guide(dyad.guide, n + 1);
    shape(n).block = true;
    add_rail(n + 1, {0, 0}, dyad.slot, n);
  }

  void add_dyad(const Group& group, int) {
    for (const GroupJoint& joint : group.joints) {
      if (!joint.slides) continue;
      shape(joint.second.body).block = true;
      add_rail(joint.first.body, joint.first.at, joint.along_first, joint.second);
    }
  }
  void add_dyad(const GroupRest&, int) {}

  const problems::NamedMechanism& named_;
  const MechanismPoses& poses_;
  std::vector<std::vector<Vec2d>> points_;
  MechanismShapes shapes_;
};

}  // namespace

MechanismShapes mechanism_shapes(const problems::NamedMechanism& mechanism,
                                 const MechanismPoses& poses) {
  return ShapeBuilder(mechanism, poses).build();
}

}  // namespace cognate::app
