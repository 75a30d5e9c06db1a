/// @file Positions of mechanisms of one loop by intersecting circles and lines. The drive's angle
/// counts from the frame's or the slide's direction and is a place: a quarter turn, and the tangent
/// of half the angle from it.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <optional>

#include "analysis/numbers/constants.hpp"
#include "tests/stress/ranges/single_loop.hpp"

namespace cognate::stress {

template <class Real>
struct Plane {
  Real x = 0, y = 0;
};

/// Quarter turns (any number) and tan of half the angle beyond, within a quarter's eighth.
template <class Real>
struct Place {
  int quarter = 0;
  Real t = 0;

  Plane<Real> direction() const {
    const Real square = t * t, c = (1 - square) / (1 + square), s = 2 * t / (1 + square);
    switch (((quarter % 4) + 4) % 4) {
      case 0:
        return {c, s};
      case 1:
        return {-s, c};
      case 2:
        return {-c, -s};
      default:
        return {s, -c};
    }
  }
  double degrees() const {
    return 90.0 * quarter + 2 * std::atan(static_cast<double>(t)) * 180 / kPi;
  }
  bool operator==(const Place&) const = default;

  /// The same place counted from quarter `other`, which is this one or a neighbour.
  Place from_quarter(int other) const {
    if (other == quarter) return *this;
    return other < quarter ? Place{other, (1 + t) / (1 - t)} : Place{other, (t - 1) / (1 + t)};
  }
};

/// Where the mechanism stands: the output's direction, or its displacement in `output.x`.
template <class Real>
struct Position {
  Plane<Real> output;
  Plane<Real> coupler;      ///< its direction, of a four-bar
  double transmission = 0;  ///< degrees, in [0, 180]
};

/// Dimensions with the sums equal that count as equal, and what follows from them.
template <class Real>
class LoopShape {
 public:
  explicit LoopShape(const SingleLoop& loop)
      : type_(loop.type),
        crank_(loop.crank),
        coupler_(loop.coupler),
        rocker_(loop.rocker),
        offset_(loop.offset) {
    using std::sqrt;
    const Real x(loop.frame_x), y(loop.frame_y);
    frame_ = loop.frame_y == 0 ? abs_of(x) : Real(sqrt(x * x + y * y));
    const double slot = loop.slot * kPi / 180;
    slot_ = {Real(std::cos(slot)), Real(std::sin(slot))};
    make_equal(loop);
  }

  /// Positive where the mechanism closes, negative where it does not, zero in between.
  Real gap(const Place<Real>& place) const {
    const Plane<Real> d = place.direction();
    switch (type_) {
      case LoopType::four_bar: {
        const Real square = diagonal(d), less = coupler_ - rocker_, more = coupler_ + rocker_;
        return std::min<Real>(square - less * less, more * more - square);
      }
      case LoopType::slider_crank:
      case LoopType::fixed_block: {
        const Real rise = offset_ - crank_ * d.y;
        return (coupler_ - rise) * (coupler_ + rise);
      }
      case LoopType::guide_bar:
      case LoopType::oscillating_block:
        return diagonal(d) - offset_ * offset_;
      case LoopType::tangent_generator:
        return abs_of(d.y);
      default:
        return 1;
    }
  }

  /// Empty where the position is not determined.
  std::optional<Position<Real>> at(const Place<Real>& place, int side) const {
    const Plane<Real> d = place.direction();
    switch (type_) {
      case LoopType::four_bar:
        return four_bar(d, side);
      case LoopType::slider_crank:
      case LoopType::fixed_block: {
        const Real rise = offset_ - crank_ * d.y,
                   root = root_of((coupler_ - rise) * (coupler_ + rise));
        const Real along = side > 0 ? root : Real(-root);
        return Position<Real>{{crank_ * d.x + along, offset_}, {}, angle(along, rise)};
      }
      case LoopType::guide_bar:
      case LoopType::oscillating_block:
        return bar(d, side);
      case LoopType::scotch_yoke:
        return Position<Real>{
            {crank_ * d.x + (offset_ - crank_ * d.y) * slot_.x / slot_.y, 0}, {}, 90};
      case LoopType::tangent_generator:
        if (d.y == 0) return std::nullopt;
        return Position<Real>{{offset_ * d.x / d.y, 0}, {}, 90};
      case LoopType::elliptic_trammel:
        return Position<Real>{{crank_ * d.y / slot_.y, 0}, {}, 90};
      case LoopType::oldham_coupling:
        return Position<Real>{d, {}, 90};
    }
    return std::nullopt;
  }

 private:
  static Real abs_of(const Real& x) { return x < 0 ? Real(-x) : x; }
  static Real root_of(const Real& square) {
    using std::sqrt;
    return square > 0 ? Real(sqrt(square)) : Real(0);
  }
  static double angle(const Real& sine, const Real& cosine) {
    const double degrees = 180 / kPi;
    return degrees * std::atan2(std::abs(static_cast<double>(sine)), static_cast<double>(cosine));
  }

  Real diagonal(const Plane<Real>& d) const {
    const Real x = frame_ - crank_ * d.x, y = crank_ * d.y;
    return x * x + y * y;
  }

  std::optional<Position<Real>> four_bar(const Plane<Real>& d, int side) const {
    const Real x = frame_ - crank_ * d.x, y = -crank_ * d.y, square = x * x + y * y;
    if (square == 0) return std::nullopt;
    const Real less = coupler_ - rocker_, more = coupler_ + rocker_;
    const Real root = root_of((square - less * less) * (more * more - square));
    const Real along = (square + less * more) / (2 * square);
    const Real across = (side > 0 ? root : Real(-root)) / (2 * square);
    const Plane<Real> coupler{along * x - across * y, along * y + across * x};
    const Plane<Real> rocker{coupler.x - x, coupler.y - y};
    const Real cosine = coupler_ * coupler_ + rocker_ * rocker_ - square;
    return Position<Real>{rocker, coupler, angle(root, cosine)};
  }

  std::optional<Position<Real>> bar(const Plane<Real>& d, int side) const {
    const Real x = crank_ * d.x - frame_, y = crank_ * d.y, square = x * x + y * y;
    if (square == 0) return std::nullopt;
    const Real root = root_of(square - offset_ * offset_);
    const Real s = side > 0 ? root : Real(-root);
    const Plane<Real> u{(x * s + y * offset_) / square, (y * s - x * offset_) / square};
    return Position<Real>{u, {}, angle(s, offset_)};
  }

  void make_equal(const SingleLoop& loop) {
    if (loop.tie == Tie::none) return;
    if (loop.type == LoopType::slider_crank || loop.type == LoopType::fixed_block) {
      (coupler_ > crank_ ? coupler_ : crank_) = std::min<Real>(coupler_, crank_) + abs_of(offset_);
      return;
    }
    if (loop.type != LoopType::four_bar) {
      (frame_ > crank_ ? frame_ : crank_) = std::min<Real>(frame_, crank_) + abs_of(offset_);
      return;
    }
    switch (loop.tie) {
      case Tie::single:
        frame_ = loop.equal_sum == 1   ? Real(crank_ + coupler_ - rocker_)
                 : loop.equal_sum == 2 ? Real(crank_ + rocker_ - coupler_)
                                       : Real(coupler_ + rocker_ - crank_);
        return;
      case Tie::parallelogram:
        rocker_ = crank_, frame_ = coupler_;
        return;
      case Tie::kite_b_on_d:
        frame_ = crank_, rocker_ = coupler_;
        return;
      case Tie::kite_c_on_a:
        coupler_ = crank_, rocker_ = frame_;
        return;
      default:
        coupler_ = rocker_ = frame_ = crank_;
    }
  }

  LoopType type_;
  Real crank_, coupler_, rocker_, offset_, frame_;
  Plane<Real> slot_;
};

}  // namespace cognate::stress
