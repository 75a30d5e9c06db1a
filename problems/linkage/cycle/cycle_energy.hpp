/// @file The steady motion of a four-bar whose drive gives the same torque at every crank angle,
/// just so much that loads and weights over a whole turn are borne, without integration.
///
/// With J the inertia of links and flywheel at the crank, W what the drive, loads and weights have
/// done since some angle (forces, weights and torques that do not change do F·r, m g·r and M θ),
///
///     ½ J ω² = E₀ + W.
///
/// Speeds stay within [ω₁, ω₂] for some E₀ just if at no two angles ½ J ω₁² − W of the one exceeds
/// ½ J ω₂² − W of the other: the sector extremes of two functions of one angle, linear in J, decide
/// it (Wittenbauer's tangents to the curve of W over J). With ω₁,₂ = ω (1 ∓ δ/2) and mean speed ω,
/// ω₂² − ω₁² = 2 δ ω², so that the least flywheel for a fluctuation δ is
///
///     max (½ J ω₁² − W) + max (W − ½ J ω₂²)   over   δ ω².
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "problems/linkage/cycle/cycle_motion.hpp"
#include "problems/linkage/sector_extremes.hpp"

namespace cognate::problems {

/// Directions of half the crank's angle from the frame, in [0, π], at which the rocker turns back:
/// crank and coupler lie along a line from A to C, on top of or behind each other. Not numbers
/// where there are none.
struct TurningPoints {
  Vec2d outer, inner;
};

TurningPoints turning_points(const Lengths<double>& links, double assembly);

/// The crank's angle, in [0, 2π], whose half has the direction `half`.
double angle_of_half(const Vec2d& half);

/// What drive, loads and weights have done by the time the crank has reached an angle from that of
/// the frame, as a function of (LinkagePose<T>, CycleState<T>), up to a constant. The state must
/// have the links' angles.
class CycleWork {
 public:
  /// Keeps a reference to `operation`.
  CycleWork(const Operation& operation, const CycleTable& table);

  /// Whether it is known: a load of one stroke alone needs a rocker that has strokes.
  bool is_known() const;

  template <class T>
  T operator()(const LinkagePose<T>& of, const CycleState<T>& at) const {
    T work = as<T>(drive_) * at.crank.angle;
    const Vec2<T> gravity = in_frame(of, operation_.gravity);
    each_mass(of, at, operation_, [&](const MovingMass<T>& body) {
      work = work + body.mass * dot(gravity, body.centre.place);
    });
    auto stroke = strokes_.begin();
    for (const WorkingLoad& load : operation_.loads) {
      const T all = work_of(load, of, at);
      if (load.sense == LoadSense::always) {
        work = work + all;
      } else {
        work = work + within_stroke(*stroke++, all, acts(load, at, operation_.speed), at);
      }
    }
    return work;
  }

 private:
  /// In which a load acts: what it would have done by its beginning and end, if it always acted.
  struct Stroke {
    double from = 0, to = 0;  ///< crank angles in [0, 2π]
    DimensionJet at_from, at_to;
  };

  template <class T>
  static T as(const DimensionJet& number) {
    if constexpr (std::is_same_v<T, DimensionJet>) {
      return number;
    } else {
      return T(number.a);
    }
  }

  /// Of a load that always acts: F·r + M θ.
  template <class T>
  static T work_of(const WorkingLoad& load, const LinkagePose<T>& of, const CycleState<T>& at) {
    return dot(in_frame(of, load.force), turning_of(of, at, load.at).place) +
           T(load.torque) * turning_link(at, load.at.link).angle;
  }

  /// `all` counted in the stroke alone, from the crank angle 0 on; between strokes it stays. The
  /// middle of the stroke, or of what is between, decides which end is past.
  template <class T>
  static T within_stroke(const Stroke& stroke, const T& all, bool active, const CycleState<T>& at) {
    const T begun = as<T>(stroke.at_from);
    T whole = as<T>(stroke.at_to) - begun;
    const bool late = at.crank.angle > T(0.5 * (stroke.from + stroke.to));
    if (stroke.from < stroke.to) return active ? T(all - begun) : (late ? whole : T(0));
    if (!active) return whole;
    return late ? T(all - begun + whole) : T(all - begun);
  }

  Stroke stroke_of(const WorkingLoad& load, const CycleTable& table) const;

  const Operation& operation_;
  std::vector<Stroke> strokes_;  ///< of the loads that have one, in their order
  DimensionJet drive_{0.};       ///< the torque of the drive
};

/// ½ J ω |ω| − W, times a share that may be negative. The sign of the speed's bound goes on below
/// standstill, where its energy would be negative.
struct EnergyWithin {
  const Operation& operation;
  const CycleWork& work;
  double bound;  ///< on the speed
  double share;

  template <class T>
  T operator()(const LinkagePose<T>& of, const CycleState<T>& at) const {
    const T half_square(0.5 * bound * std::abs(bound));
    return T(share) * (half_square * equivalent_inertia(of, at, operation) - work(of, at));
  }
};

}  // namespace cognate::problems
