/// @file A certificate checked again: a sample of the boxes that its proof discards is shown to
/// hold no better linkage by other code and in 113 bits, and the boxes are shown to cover the
/// domain.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problems/certificate/path_box.hpp"
#include "problems/path/certificate.hpp"

namespace cognate::problems {

struct RecheckOptions {
  std::size_t sample = 200;
  std::uint64_t seed = 1;  ///< which boxes are taken
  int threads = 0;
  std::function<bool()> stop;
  std::function<void(double share)> progress;
};

struct Recheck {
  std::uint64_t boxes = 0;      ///< that the proof divides or discards
  std::uint64_t discarded = 0;  ///< that it discards
  bool reaches_bound = false;   ///< the prover is done with every box
  bool covers = false;          ///< they cover the domain
  std::size_t chosen = 0;       ///< discarded boxes that are to be looked at again
  std::size_t sampled = 0;      ///< those of which that were, before the time ended
  std::size_t confirmed = 0;    ///< those shown to hold no better linkage
  std::size_t undecided = 0;    ///< those of which that could not be shown
  std::uint64_t parts = 0;      ///< into which they were divided, those that were not divided too
  std::optional<Counterexample> refutation;  ///< the rest of the sample is then left

  bool holds() const { return reaches_bound && covers && confirmed == chosen && !refutation; }
};

/// Why the certificates of `problem` are not checked again; empty where they are.
std::string recheck_refusal(const PathProblem& problem);

/// Of the `bound` that a certificate states, in the file's unit.
Recheck recheck(const PathProblem& problem, double bound, const RecheckOptions& options);

/// Whether `domain` begins with boxes that hold all proportions and phases of `problem`.
bool covers_domain(const PathProblem& problem, const PathDomain& domain);

/// The first of `linkages`, with its crank angle at the first point, that errs by less than
/// `bound`.
std::optional<Counterexample> better_linkage(const PathProblem& problem, double bound,
                                             const std::vector<Counterexample>& linkages);

}  // namespace cognate::problems
