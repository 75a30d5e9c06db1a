/// @file Proofs of timed paths followed down to linkages whose error is known from circles alone.
///
/// A linkage of random proportions and phase is made, with pivots, crank and coupler point fitted
/// in long double and brought within the file's limits; where its circles meet gives its error.
/// Whatever box holds it may not be discarded by a proof of a bound above that error, from the
/// whole domain down to boxes as narrow as proofs make them.
#pragma once

#include <optional>
#include <random>

#include "problems/path/certificate.hpp"

namespace cognate::test {

struct DescentTally {
  long designs = 0;
  long boxes = 0;  ///< judged, each with a linkage better than the bound in it
  long wrongly_discarded = 0;
  long discarded_below = 0;  ///< of these boxes against half the error, where that may be right
  int deepest = 0;

  DescentTally& operator+=(const DescentTally& other);
};

/// Follows the proof of `problem` to linkages at random until `boxes` boxes were judged. The bound
/// is `scale` times what the proof is told to show: other than 1 only to see that errors are found.
DescentTally descend(const problems::PathProblem& problem, long boxes, std::mt19937_64& random,
                     double scale = 1);

}  // namespace cognate::test
