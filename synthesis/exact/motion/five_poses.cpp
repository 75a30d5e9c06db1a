#include "synthesis/exact/motion/five_poses.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/exact/motion/degenerate_poses.hpp"
#include "synthesis/exact/motion/guidance_forms.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Vector3d;

/// The residual of the normalised conditions that a dyad may have, far above rounding.
constexpr double kSolved = 1e-11;
/// Dyads whose pivots are nearer than this (in homogeneous coordinates) are one.
constexpr double kSameSolution = 1e-9;

double solutions_apart(const Vector3d& a, const Vector3d& b) {
  return std::min((a - b).norm(), (a + b).norm());
}

/// The dyads found so far.
class Found {
 public:
  explicit Found(const GuidanceForms& forms) : forms_(forms) {}

  void add(const PivotPair& start) {
    const PivotPair pair = forms_.refined(start);
    if (!(forms_.residual(pair) <= kSolved) || is_known(pair)) return;
    const auto dyad = forms_.dyad(pair);
    if (!dyad) return;
    pairs_[static_cast<std::size_t>(result.count)] = pair;
    result.add(*dyad);
  }

  DyadSolutions result;

 private:
  bool is_known(const PivotPair& pair) const {
    return std::any_of(pairs_.begin(), pairs_.begin() + result.count, [&](const PivotPair& known) {
      return solutions_apart(known.moving, pair.moving) +
                 solutions_apart(known.fixed, pair.fixed) <=
             kSameSolution;
    });
  }

  const GuidanceForms& forms_;
  std::array<PivotPair, 4> pairs_;
};

}  // namespace

DyadSolutions dyads_of_five_poses(std::span<const Pose, 5> poses) {
  const GuidanceForms forms(poses);
  if (forms.status() != GuidanceStatus::found) return degenerate_dyads(poses, forms.status());
  const NullSpacePivots starts = pivots_of_null_space(forms.null_space());
  Found found(forms);
  for (int k = 0; k < starts.count; ++k) found.add(starts.pairs[static_cast<std::size_t>(k)]);
  found.result.status = starts.common_curve       ? GuidanceStatus::family
                        : found.result.count == 0 ? GuidanceStatus::none
                                                  : GuidanceStatus::found;
  return found.result;
}

}  // namespace cognate::synthesis
