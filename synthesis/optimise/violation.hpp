/// @file How far constraints are from being met.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace cognate::synthesis {

/// By how much constraints miss: |c| of the first `equalities`, −c of the others; 0 where all hold.
inline double largest_violation(const Eigen::VectorXd& constraints, int equalities) {
  double largest = 0;
  for (Eigen::Index i = 0; i < constraints.size(); ++i) {
    largest = std::max(largest, i < equalities ? std::abs(constraints[i]) : -constraints[i]);
  }
  return largest;
}

}  // namespace cognate::synthesis
