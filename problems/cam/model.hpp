/// @file A cam problem at finitely many positions, for the solvers.
#pragma once

#include <vector>

#include "problems/cam/limits.hpp"
#include "problems/cam/variables.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// A position that stays itself while lengths and motion vary: the share of a motion segment.
struct SegmentPlace {
  int segment = 0;
  double share = 0;
  bool operator==(const SegmentPlace&) const = default;
};

/// The positions at which one limit is looked at.
struct LimitPlaces {
  CamLimit limit;
  std::vector<SegmentPlace> places;
};

/// Two positions between whose contacts the width of a flat face lies.
struct FacePair {
  SegmentPlace greatest, least;
};

/// The positions of a CamModel.
struct CamPlaces {
  std::vector<LimitPlaces> limits;
  std::vector<FacePair> face;           ///< of `constraints.face_width_max`
  std::vector<SegmentPlace> objective;  ///< none for the size
};

/// The cam problem with its limits and its objective at the positions given alone: a relaxation of
/// it, whose solutions the caller holds against all positions. Derivatives are exact, by dual
/// numbers.
class CamModel final : public synthesis::Model {
 public:
  /// `objective_unit`: a typical value of an objective that is a force, a torque or a squared
  /// stress.
  CamModel(const CamVariables& variables, CamPlaces places, double objective_unit);

  std::span<const synthesis::Variable> variables() const override { return variables_.variables(); }
  int residual_count() const override;
  int constraint_count() const override;
  int equality_count() const override { return frees_angles_ ? 1 : 0; }
  synthesis::Objective objective() const override;
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;

 private:
  /// The motion at every place: of the limits, of the face's pairs, of the objective.
  template <class T>
  std::vector<cam::FollowerMotion<T>> motions(std::span<const T> x) const;
  template <class T>
  void evaluate_constraints(std::span<const T> x, std::span<T> c) const;
  template <class T>
  void evaluate_residuals(std::span<const T> x, std::span<T> r) const;
  template <class T>
  T angles_left(std::span<const T> x) const;
  /// What the shares of a segment leave of 1.
  template <class T>
  T share_left(std::size_t segment, std::span<const T> x) const;

  const CamVariables& variables_;
  CamPlaces places_;
  std::vector<SegmentPlace> all_;                   ///< of `places_`, in the order of `motions`
  std::vector<cam::FollowerMotion<double>> still_;  ///< there, where no motion is free
  std::size_t of_limits_ = 0;                       ///< how many of them are of limits
  bool frees_angles_ = false;
  std::vector<std::size_t> shared_;  ///< segments with free shares
  bool rolls_ = false;               ///< a roller must stay clear of the cam's centre
  int bounds_ = 0;                   ///< constraints that the bounds of the base radius become
  double objective_unit_ = 1;
};

}  // namespace cognate::problems
