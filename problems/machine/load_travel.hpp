/// @file How far a loaded body has travelled, for expressions that name it.
#pragma once

#include <span>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/motion_state.hpp"
#include "analysis/mechanism/travel.hpp"

namespace cognate::problems {

/// A body's travel over assembly ranges, without leaps: of a body that slides its
/// displacement; of one that swings the angle by which it has turned counter-clockwise from the one
/// end of its swing, at which that is 0, to the other, however the mechanism lies in the plane. Of
/// one that turns fully the angle from the x axis, in [0, 2π), which begins anew with each turn.
class LoadTravel {
 public:
  LoadTravel(const Mechanism<double>& mechanism, const AssemblyRanges& assembly_ranges, int body);

  /// Of the mechanism's bodies where it stands.
  double travelled(std::span<const BodyMotion<double, 2>> bodies) const;
  double rate(std::span<const BodyMotion<double, 2>> bodies) const;

  bool begins_anew() const { return !travel_.slides && !swings_; }

 private:
  Travel travel_;
  bool swings_ = false;
  double least_ = 0, middle_ = 0;  ///< of its swing, from the x axis
};

}  // namespace cognate::problems
