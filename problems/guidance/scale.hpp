/// @file Motion problems in units of the body's own way, with its middle as origin.
#pragma once

#include "problems/guidance/design.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/linkage/similarity.hpp"

namespace cognate::problems {

/// Solvers see every motion at the same place and of the same size. The body keeps its axes.
class MotionScale {
 public:
  explicit MotionScale(const MotionProblem& problem);

  /// Length unit of the scaled problem: the natural angle weight, or, where the body's origin
  /// stands still, the weight of the problem.
  double size() const { return similarity_.size; }

  MotionProblem into(MotionProblem problem) const;  ///< file units → scaled

  DyadPair into(const DyadPair& pair) const;

  /// Scaled → file units; what the file gives comes out as written.
  synthesis::Pose out_of(const synthesis::Pose& pose) const;
  DyadPair out_of(const DyadPair& pair) const;

 private:
  synthesis::GuidingDyad into(const synthesis::GuidingDyad& dyad) const;
  synthesis::GuidingDyad out_of(const synthesis::GuidingDyad& dyad) const;

  const MotionProblem& problem_;
  Similarity similarity_;
};

}  // namespace cognate::problems
