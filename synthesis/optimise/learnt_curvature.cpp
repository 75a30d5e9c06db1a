#include "synthesis/optimise/learnt_curvature.hpp"

namespace cognate::synthesis {
namespace {

/// The least share of the expected curvature along a step that is believed (Powell).
constexpr double kLeastShare = 0.2;

}  // namespace

void LearntCurvature::learn(const Eigen::VectorXd& step, const Eigen::VectorXd& change,
                            double least) {
  if (matrix_.isZero(0)) matrix_.diagonal().setConstant(least);
  const Eigen::VectorXd expected = matrix_ * step;
  const double known = step.dot(expected), seen = step.dot(change);
  if (!(known > 0) || !change.allFinite()) return;
  const double share = seen >= kLeastShare * known ? 1 : (1 - kLeastShare) * known / (known - seen);
  const Eigen::VectorXd believed = share * change + (1 - share) * expected;
  matrix_ += believed * believed.transpose() / step.dot(believed) -
             expected * expected.transpose() / known;
}

}  // namespace cognate::synthesis
