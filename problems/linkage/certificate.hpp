/// @file Proof of how much better than the best design found any other can be.
#pragma once

#include <cstdint>
#include <string>

namespace cognate::problems {

/// The note of a result whose file asks for a certificate in vain.
inline constexpr const char* kNothingToCertify =
    "There is no certificate: the search has not found a design that meets every constraint, or "
    "was "
    "ended early.";

/// What a branch and bound over all designs of `domain` proved. Errors are what the search
/// minimises: the weighted sum of squares in the target's unit.
struct Certificate {
  double lower_bound = 0;   ///< no design of the domain that satisfies the constraints errs by less
  double upper_bound = 0;   ///< the error of the best design found
  double gap_relative = 0;  ///< (upper − lower)/upper, 0 where upper is rounding
  bool complete = false;    ///< the gap requested was reached, not ended by time
  std::uint64_t boxes = 0;  ///< parts of the domain examined
  std::string domain;       ///< which designs were looked at, in words
};

}  // namespace cognate::problems
