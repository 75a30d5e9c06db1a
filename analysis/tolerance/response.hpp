/// @file What of a mechanism is judged when its dimensions change.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/mechanism/sliding_pairs.hpp"
#include "analysis/tolerance/affine_mechanism.hpp"

namespace cognate {

/// A position of the drive, with the sides of the dyads there: a motion that passes a change point
/// has others behind it.
struct Station {
  DrivePosition<double> drive;
  std::vector<double> sides;
};

/// The angle of a body's first axis, the displacement along a slide, the place of a point, the
/// transmission angle of a dyad (in [0, π]) or its discriminant, both as DyadClosure has them, how
/// far a point lies along a direction, or the direction from one point to another.
enum class ResponseType { angle, displacement, point, transmission, closure, along, direction };

/// One of these. A displacement is counted along the slide of the nominal mechanism, from the place
/// in the axes of its body at which that has it.
struct Response {
  ResponseType type = ResponseType::angle;
  std::size_t index = 0;  ///< of the body, the point of the MechanismWithPoints, or the dyad
  SlidingPair slide;      ///< of a displacement
  Vec2d direction{};      ///< unit vector, of `along`
  std::size_t to = 0;     ///< of a direction: the point to which it is, `index` being the other
};

/// Whether the response is an angle, given by a unit vector.
constexpr bool is_angular(ResponseType type) {
  return type == ResponseType::angle || type == ResponseType::transmission ||
         type == ResponseType::direction;
}

/// A changed mechanism over T and its state.
template <class T>
class ChangedMechanism {
 public:
  explicit ChangedMechanism(MechanismWithPoints<T> changed)
      : changed_(std::move(changed)),
        sides_(changed_.mechanism.dyads.size(), T(0)),
        bodies_(static_cast<std::size_t>(body_count(changed_.mechanism))),
        closures_(changed_.mechanism.dyads.size()) {}

  void move_to(const Station& station) {
    const auto& [direction, displacement] = station.drive;
    for (std::size_t i = 0; i < sides_.size(); ++i) sides_[i] = T(station.sides[i]);
    const DrivePosition<T> drive{{T(direction.x), T(direction.y)}, T(displacement)};
    evaluate<0>(changed_.mechanism, drive, std::span<const T>(sides_),
                std::span<BodyMotion<T, 0>>(bodies_), std::span<DyadClosure<T>>(closures_));
  }

  /// Of an angle or direction its unit vector, of a displacement (s, 0), of a point its place.
  Vec2<T> value(const Response& response) const {
    switch (response.type) {
      case ResponseType::angle:
        return bodies_[response.index].direction;
      case ResponseType::displacement:
        return displacement(response.slide);
      case ResponseType::point:
        return point(response.index);
      case ResponseType::along:
        return {dot(point(response.index), lifted(response.direction)), T(0)};
      case ResponseType::direction: {
        using std::sqrt;
        const Vec2<T> way = point(response.to) - point(response.index);
        const T length = sqrt(squared_norm(way));
        return {way.x / length, way.y / length};
      }
      case ResponseType::transmission: {
        const DyadClosure<T>& closure = closures_[response.index];
        return {closure.cosine, sides_[response.index] * closure.sine};
      }
      case ResponseType::closure:
        return {closures_[response.index].discriminant, T(0)};
    }
    return {};
  }

  std::span<const DyadClosure<T>> closures() const { return closures_; }

 private:
  Vec2<T> place(int body, const Vec2<T>& at) const {
    const BodyMotion<T, 0>& motion = bodies_[static_cast<std::size_t>(body)];
    return motion.origin[0] + motion.direction * at;
  }
  Vec2<T> point(std::size_t index) const {
    return place(changed_.points[index].body, changed_.points[index].at);
  }
  static Vec2<T> lifted(const Vec2d& v) { return {T(v.x), T(v.y)}; }

  Vec2<T> displacement(const SlidingPair& pair) const {
    const auto& guide = bodies_[static_cast<std::size_t>(pair.through.body)];
    const Vec2<T> along = guide.direction * lifted(pair.direction);
    const Vec2<T> from = place(pair.through.body, lifted(pair.through.at));
    return {dot(bodies_[static_cast<std::size_t>(pair.slider)].origin[0] - from, along), T(0)};
  }

  MechanismWithPoints<T> changed_;
  std::vector<T> sides_;
  std::vector<BodyMotion<T, 0>> bodies_;
  std::vector<DyadClosure<T>> closures_;
};

/// How far a response is from `reference`: of an angle (x, 0) in (−π, π], of the others the
/// difference.
inline Vec2d deviation(ResponseType type, const Vec2d& value, const Vec2d& reference) {
  if (!is_angular(type)) return value - reference;
  return {std::atan2(cross(reference, value), dot(reference, value)), 0};
}

/// The derivative of that by a dimension, by which the value changes as `by`: of an angle, whose
/// unit vector is `value`, value × by.
template <class T>
Vec2<T> deviation_rate(ResponseType type, const Vec2<T>& value, const Vec2<T>& by) {
  if (!is_angular(type)) return by;
  return {cross(value, by), T(0)};
}

}  // namespace cognate
