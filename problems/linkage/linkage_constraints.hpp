/// @file The constraints that depend on the four link lengths alone, as smooth functions c ≥ 0.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "synthesis/bounds/link_limit.hpp"

namespace cognate::problems {

/// Whether a four-bar reported as `found` satisfies `required`: its own class, `grashof` any but a
/// triple rocker, `non_grashof` that alone. A change point has the class that `mobility_class`
/// gives it and no other.
bool is_of_class(MobilityClass found, RequiredClass required);

/// The class to which a refinement from `start` is to keep: the one requested, or, where the
/// transmission angle is limited and the crank of `start` turns fully, that of `start`, so that the
/// limits are those of the full turn; where the crank must turn fully, the nearest such class.
/// Empty: any.
std::optional<RequiredClass> confining_class(const Constraints& constraints,
                                             const Lengths<double>& start);

/// The class of a linkage, unless one is required already, or the linkage is not of the kind that
/// is: to stay where its limits hold.
std::optional<RequiredClass> open_class(const Constraints& constraints,
                                        const Lengths<double>& links);

/// Class, transmission angle over the full turn, largest link ratio, proportions and time ratio, as
/// functions c(l) ≥ 0.
///
/// Class: with s the link that must be the shortest, s + k ≤ sum of the other two for each other
/// link k. These three half spaces imply that s is the shortest, and together are Grashof's
/// criterion. `grashof` and `non_grashof` use shortest + longest − the other two as it stands.
/// Proportions: some s has minᵢ ≤ s lᵢ ≤ maxᵢ for all i if and only if minᵢ lⱼ ≤ maxⱼ lᵢ for all
/// pairs; where one of the lengths is given, the pairs with that one imply the others.
/// Transmission: cos μ at crank and frame collinear, d = |l₄ ∓ l₁|, against the limits' cosines.
class LinkageConstraints {
 public:
  /// `scale`: typical length by which linear constraints are divided.
  LinkageConstraints(const Constraints& constraints, double scale);

  int count() const { return static_cast<int>(limits_.size()); }
  std::span<const synthesis::LinkLimit> limits() const { return limits_; }

  /// Whether a limit on the transmission angle is among them. It is not when no class with a fully
  /// turning crank is requested: the limit then refers to the motion between the targets.
  bool limits_transmission() const { return limits_transmission_; }

  /// Values (size count) and, unless `gradient` is empty, derivatives with respect to the lengths.
  void evaluate(const Lengths<double>& links, std::span<double> values,
                std::span<Lengths<double>> gradient) const;

  /// Σ weightsₖ ∇²cₖ by the lengths, 4 × 4 row-major, added to `out`.
  void add_hessian(const Lengths<double>& links, std::span<const double> weights,
                   std::span<double, 16> out) const;

 private:
  void add_shortest(int shortest, double scale);
  void add_class(RequiredClass required, double scale);
  void add_link_ratio(double ratio, double scale);
  void add_proportions(const std::array<Range, 4>& ranges, double scale);
  void add_time_ratio(const Range& ratio);

  std::vector<synthesis::LinkLimit> limits_;
  bool limits_transmission_ = false;
};

}  // namespace cognate::problems
