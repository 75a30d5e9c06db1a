/// @file Whether no linkage of a box errs by less than a target, for timed paths with four unknown
/// proportions: many boxes at a time, one in each SIMD lane.
///
/// Where the directions of the coupler at all samples are alike, a bound of each by itself cannot
/// see that only their differences count. Here they are enclosed relative to one another and to
/// third order, see coupler_models.hpp and path_forms.hpp.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/batch/instruction_set.hpp"
#include "synthesis/bounds/path_bound.hpp"
#include "synthesis/bounds/staged_search.hpp"

namespace cognate::synthesis {

/// Whether proofs of PathProver look at this path over boxes like `box`: the crank turns fully, its
/// phase is unknown, and so is its direction in the plane.
bool has_path_proof(const TimedPath& path, const ProportionBox& box);

/// Limits of the lengths are observed as far as they exclude whole boxes; else more linkages are
/// looked at than they allow.
class PathProver {
 public:
  PathProver(TimedPath path, const ProportionLimits& limits,
             std::optional<InstructionSet> set = {});

  /// Of each box whether the error of all its linkages is at least `target`, or `first_target`,
  /// which is no more. Each verdict depends on its own box alone.
  void judge(std::span<const ProportionBox> boxes, double target, double first_target,
             std::span<StageVerdict> verdicts) const;

 private:
  bool is_possible(const ProportionBox& box) const;
  void judge_block(std::span<const ProportionBox> boxes, double target, double first_target,
                   std::span<StageVerdict> verdicts) const;

  TimedPath path_;
  ProportionLimits limits_;
  InstructionSet set_;
  std::vector<double> half_sine_, half_cosine_, sine_, cosine_, x_, y_;
  double mean_sine_ = 0, mean_cosine_ = 0;
};

}  // namespace cognate::synthesis
