/// @file Starts for motion generation by least squares: pairs of dyads near the poses.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "problems/guidance/design.hpp"
#include "problems/guidance/dyads.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

struct MotionStart {
  DyadPair pair;
  std::string
      origin;  ///< "algebraic", "exact:five-poses:1,3,6,9,11" (numbers of the poses) or "search"
};

/// Two links, each pivot moved at random by up to a share of its link's length, from a thousandth
/// to three tenths; within what the file gives and bounds.
DyadPair disturbed(const MotionProblem& scaled, const DyadPair& links, std::mt19937_64& random);

/// Starts, the most promising first: pairs of the dyads of least algebraic error; the nearest of
/// those that pass exactly through five of the poses (all choices of five, or some hundreds of them
/// at random); pairs of the dyads of locally least geometric error that a space-filling set of
/// draws leads to; sliders and blocks; and then pairs of other draws without end. The same for the
/// same seed.
class MotionStarts {
 public:
  /// `numbers`: of the scaled problem's poses in the file, from 0. Once `deadline` is reached, with
  /// what was found until then.
  MotionStarts(const MotionProblem& scaled, const std::vector<std::size_t>& numbers,
               std::uint64_t seed, const Deadline& deadline);

  /// Empty where there is no such start.
  std::optional<MotionStart> start(int index) const;

 private:
  void add(const synthesis::GuidingDyad& a, const synthesis::GuidingDyad& b,
           const std::string& origin);
  void add_algebraic();
  void add_exact(const std::vector<std::size_t>& numbers, const Deadline& deadline);
  void add_nearest(const Deadline& deadline);

  MotionProblem problem_;
  bool alike_, either_drives_;
  std::uint64_t seed_;
  std::vector<MotionStart> listed_;
  std::vector<DyadCandidate> first_, second_, slides_;  ///< from which others are drawn
};

}  // namespace cognate::problems
