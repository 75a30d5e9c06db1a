/// @file Random mechanisms of every drive and dyad, built from a position in which they close.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "analysis/mechanism/kinematics.hpp"

namespace cognate::test {

/// Draws mechanisms whose dyads depend on any body before them: points of moving links, guides on
/// moving sliders. Lengths are chosen so that every dyad closes near the drive position `start`,
/// well away from a dead point.
class ChainMaker {
 public:
  explicit ChainMaker(unsigned seed) : random_(seed) {}

  static constexpr double kStart = 0.7;

  /// `drive`: 0 crank, 1 driving slider, 2 floating link, 3 driving cylinder, which is the first
  /// dyad. Those after it by `types`, 0…4: RRR, RRP, RPR, PRP, RPP.
  Mechanism<double> make(int drive, const std::vector<int>& types) {
    mechanism_ = {};
    if (drive == 0) mechanism_.drive = Crank<double>{point(), size()};
    if (drive == 1) mechanism_.drive = DrivingSlider<double>{guide(0)};
    if (drive == 2) mechanism_.drive = floating_link();
    if (drive == 3) add_cylinder();
    for (const int type : types) add(type);
    return mechanism_;
  }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  double size() { return uniform(0.5, 2); }
  Vec2d point() { return {uniform(-3, 3), uniform(-3, 3)}; }
  Vec2d unit() {
    const double angle = uniform(-3.1, 3.1);
    return {std::cos(angle), std::sin(angle)};
  }
  Assembly assembly() { return uniform(0, 1) < 0.5 ? Assembly::open : Assembly::crossed; }
  int body() { return static_cast<int>(uniform(0, body_count(mechanism_) - 0.01)); }
  Attached<double> attached() { return {body(), point()}; }
  Guide<double> guide(int on) { return {on, point(), unit(), uniform(-1, 1)}; }

  FloatingLink<double> floating_link() {
    FloatingLink<double> link{guide(0), guide(0), size()};
    link.second.direction = link.first.direction * Vec2d{0.3, std::sqrt(1 - 0.09)};
    return link;
  }

  void add_cylinder() {
    const Vec2d base = point(), pivot = point();
    const double frame = std::sqrt(squared_norm(pivot - base));
    const double least = std::abs(frame - kStart), most = frame + kStart;
    const double link = least + uniform(0.2, 0.8) * (most - least);
    mechanism_.drive = DrivingRod<double>{};
    mechanism_.dyads = {Cylinder<double>{{0, base}, {0, pivot}, link, assembly()}};
  }

  /// The position of the mechanism so far.
  Vec2d position(const Attached<double>& at) const {
    MechanismMotion<0> motion(mechanism_);
    motion.move_to(kStart);
    return motion.point(at)[0];
  }
  Vec2d direction(const Guide<double>& at) const {
    MechanismMotion<0> motion(mechanism_);
    motion.move_to(kStart);
    return motion.bodies()[static_cast<std::size_t>(at.body)].direction * at.direction;
  }

  void add(int type) {
    if (type == 0) {
      const Attached<double> first = attached(), second = attached();
      const Vec2d d = position(second) - position(first);
      const double distance = std::sqrt(squared_norm(d));
      const double l1 = distance * uniform(0.5, 1.5) + 0.3;
      const double least = std::abs(distance - l1), most = distance + l1;
      const double l2 = least + uniform(0.2, 0.8) * (most - least);
      mechanism_.dyads.emplace_back(Rrr<double>{first, second, l1, l2, assembly()});
    } else if (type == 1) {
      const Attached<double> from = attached();
      const Guide<double> on = guide(body());
      const double h =
          cross(direction(on), position({on.body, on.through}) - position(from)) + on.offset;
      mechanism_.dyads.emplace_back(
          Rrp<double>{from, std::abs(h) * uniform(1.2, 2) + 0.3, on, assembly()});
    } else if (type == 2) {
      const Attached<double> block = attached(), pivot = attached();
      const double distance = std::sqrt(squared_norm(position(block) - position(pivot)));
      mechanism_.dyads.emplace_back(
          Rpr<double>{block, pivot, distance * uniform(-0.8, 0.8), assembly()});
    } else if (type == 3) {
      const Guide<double> first = guide(body());
      Guide<double> second = guide(body());
      while (std::abs(cross(direction(first), direction(second))) < 0.3) second = guide(body());
      mechanism_.dyads.emplace_back(Prp<double>{first, second});
    } else {
      Vec2d slot = unit();
      while (std::abs(slot.y) < 0.3) slot = unit();
      mechanism_.dyads.emplace_back(Rpp<double>{attached(), slot, guide(body())});
    }
  }

  std::mt19937 random_;
  Mechanism<double> mechanism_;
};

/// `mechanism` in another unit of length: its lengths, but not its directions, times `unit`.
inline Mechanism<double> scaled(Mechanism<double> mechanism, double unit) {
  const auto scale_point = [unit](Vec2d& point) { point = unit * point; };
  const auto scale_guide = [&](Guide<double>& guide) {
    scale_point(guide.through);
    guide.offset *= unit;
  };
  const auto scale = [&](auto& part) {
    if constexpr (requires { part.pivot.x; }) scale_point(part.pivot);
    if constexpr (requires { part.pivot.at; }) scale_point(part.pivot.at);
    if constexpr (requires { part.base.at; }) scale_point(part.base.at);
    if constexpr (requires { part.block.at; }) scale_point(part.block.at);
    if constexpr (requires { part.point.at; }) scale_point(part.point.at);
    if constexpr (requires { part.first.at; }) scale_point(part.first.at);
    if constexpr (requires { part.second.at; }) scale_point(part.second.at);
    if constexpr (requires { part.guide; }) scale_guide(part.guide);
    if constexpr (requires { part.first.through; }) scale_guide(part.first);
    if constexpr (requires { part.second.through; }) scale_guide(part.second);
    if constexpr (requires { part.length; }) part.length *= unit;
    if constexpr (requires { part.first_length; }) part.first_length *= unit;
    if constexpr (requires { part.second_length; }) part.second_length *= unit;
    if constexpr (requires { part.offset; }) part.offset *= unit;
  };
  std::visit(scale, mechanism.drive);
  for (Dyad<double>& dyad : mechanism.dyads) std::visit(scale, dyad);
  return mechanism;
}

}  // namespace cognate::test
