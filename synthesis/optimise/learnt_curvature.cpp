#include "synthesis/optimise/learnt_curvature.hpp"

namespace cognate::synthesis {
namespace {

/// The least share of the expected curvature along a step that is believed (Powell).
constexpr double kLeastShare = 0.2;
/// The least cosine between a step and the change of the gradient. Where curvatures of both signs
/// cancel along a step the change is across it, and to believe it would make B as large as one
/// likes.
constexpr double kLeastCosine = 0.05;
/// Along steps with a lesser cosine to B s what B would be there is rounding.
constexpr double kKnownCosine = 1e-4;

}  // namespace

void LearntCurvature::learn(const Eigen::VectorXd& step, Eigen::VectorXd change, double least) {
  if (!change.allFinite()) return;
  if (matrix_.isZero(0)) matrix_.diagonal().setConstant(least);
  const double size = change.norm() / step.norm();
  const double lacking = kLeastCosine * size - step.dot(change) / step.squaredNorm();
  if (lacking > 0 && lacking < size) change += lacking * step;
  const Eigen::VectorXd expected = matrix_ * step;
  const double known = step.dot(expected), seen = step.dot(change);
  if (!(known > kKnownCosine * step.norm() * expected.norm())) return;
  const double share = seen >= kLeastShare * known ? 1 : (1 - kLeastShare) * known / (known - seen);
  const Eigen::VectorXd believed = share * change + (1 - share) * expected;
  matrix_ += believed * believed.transpose() / step.dot(believed) -
             expected * expected.transpose() / known;
}

}  // namespace cognate::synthesis
