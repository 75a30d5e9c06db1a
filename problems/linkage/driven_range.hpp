/// @file The transmission angle over the range of a crank whose angles at the targets are
/// prescribed, as functions c ≥ 0.
#pragma once

#include <array>
#include <span>

#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

/// What those depend on, in the order of the slopes: four lengths, and the crank's angle from the
/// frame where increments count from.
struct DrivenCrank {
  Lengths<double> links;
  double offset = 0;
};
using DrivenSlopes = std::array<double, 5>;

/// By four lengths and by both ends of a way.
using WaySlopes = std::array<double, 6>;

/// Of a crank that is driven from one angle to another: cos μ_min − cos μ where the diagonal B–D is
/// the shortest on the way, cos μ − cos μ_max where it is the longest. Without a limit of the
/// transmission angle 0° and 180° take its place: beyond them the linkage does not close, so that
/// all targets lie on one circuit.
///
/// At the shortest diagonal θ is the angle on the way nearest to 0, at the longest that nearest to
/// π: an end of the way, where both functions are smooth, or the direction itself.
class DrivenRange {
 public:
  static constexpr int kLimits = 2;

  /// Without limits.
  DrivenRange() = default;
  /// `increments`: the least and the greatest. Empty where neither the transmission angle, nor
  /// circuit, nor order is limited.
  DrivenRange(const Constraints& constraints, const Range& increments);

  int count() const { return is_limited_ ? kLimits : 0; }

  /// Values (size count) and, unless `slopes` is empty, derivatives.
  void evaluate(const DrivenCrank& at, std::span<double> values,
                std::span<DrivenSlopes> slopes) const;

  /// The same on the way from one crank angle to another, from the frame; the increments are
  /// ignored.
  void evaluate(const Lengths<double>& links, const Range& way, std::span<double> values,
                std::span<WaySlopes> slopes) const;

  /// Σ weightsₖ ∇²cₖ, 5 × 5 row-major, added to `out`.
  void add_hessian(const DrivenCrank& at, std::span<const double> weights,
                   std::span<double, 25> out) const;

 private:
  bool is_limited_ = false;
  Range increments_{0, 0};
  double greatest_cosine_ = 1, least_cosine_ = -1;
};

}  // namespace cognate::problems
