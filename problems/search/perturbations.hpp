/// @file How the variables of a design move where its dimensions are off within their tolerances.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "problems/search/robust.hpp"
#include "synthesis/robust/perturbed_model.hpp"

namespace cognate::problems {

/// Samples drawn from the tolerances: a function of the seed and the sample's number alone.
class DrawnPerturbation final : public synthesis::Perturbation {
 public:
  /// `start` must outlive this object.
  DrawnPerturbation(const RobustStart& start, ToleranceDistribution distribution,
                    std::uint64_t seed, std::size_t count);

  std::size_t count() const override { return count_; }
  void move(std::span<const double> x, std::size_t sample, std::span<double> moved,
            std::span<double> slope) const override;

 private:
  const RobustStart& start_;
  std::size_t count_;
  std::vector<double> changes_;  ///< a column for each dimension
};

/// Two samples for each of n dimensions, at ±√n σ of it, the others in the middle: means over them
/// are those over the tolerances to third order (see MeanSquareModel).
class SpreadPerturbation final : public synthesis::Perturbation {
 public:
  /// `share`: of the tolerances. `start` must outlive this object.
  SpreadPerturbation(const RobustStart& start, ToleranceDistribution distribution, double share);

  std::size_t count() const override { return 2 * away_.size(); }
  void move(std::span<const double> x, std::size_t sample, std::span<double> moved,
            std::span<double> slope) const override;

 private:
  const RobustStart& start_;
  std::vector<double> middle_, away_;
};

/// Every combination of `levels` values of each dimension, evenly from the least to the greatest
/// that its tolerance allows: of 2 the corners of their box, of 3 also the middles of its edges and
/// faces.
class LevelPerturbation final : public synthesis::Perturbation {
 public:
  /// `start` must outlive this object.
  LevelPerturbation(const RobustStart& start, std::size_t levels);

  std::size_t count() const override { return count_; }
  void move(std::span<const double> x, std::size_t sample, std::span<double> moved,
            std::span<double> slope) const override;

 private:
  const RobustStart& start_;
  std::size_t levels_, count_ = 1;
};

}  // namespace cognate::problems
