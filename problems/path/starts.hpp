/// @file Starts for path generation: the best of many random designs, screened in SIMD lanes.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "problems/path/problem.hpp"
#include "synthesis/lanes/path_screen.hpp"

namespace cognate::problems {

/// A design to be refined, with the crank angles (from the x axis) it was found with.
struct PathStart {
  FourBar linkage;
  std::vector<double> crank_angles;
  bool clockwise = false;  ///< the sense in which increments are counted
  double error = 0;        ///< weighted sum of squares, at these crank angles
};

/// Draws designs for a scaled path problem. Where points are not timed each draw has a random
/// timing of its own, so that the linear unknowns can be eliminated there too.
class PathStarts {
 public:
  explicit PathStarts(const PathProblem& scaled);

  /// When the crank passes the points.
  struct CrankTiming {
    std::vector<double> angles;  ///< increments, or angles where the reference is not the first
    bool clockwise = false;
  };

  /// A design that was found.
  struct KnownPath {
    CrankTiming timing;
    Lengths<double> links;
    double phase = 0;  ///< of the crank at the first point, from the frame line
  };

  /// How much of a known design a start takes over.
  enum class Likeness {
    timing,      ///< about when it meets the points
    proportions  ///< that, its proportions and its phase
  };

  /// The best of `candidates` random designs, or nothing if none closes at every point. Where no
  /// point is timed they are like `about`, if that is given.
  std::optional<PathStart> draw(std::mt19937_64& random, std::size_t candidates,
                                const KnownPath* about = nullptr,
                                Likeness likeness = Likeness::timing) const;

 private:
  CrankTiming random_timing(std::mt19937_64& random) const;
  CrankTiming timing_about(std::mt19937_64& random, const CrankTiming& known) const;
  std::vector<std::size_t> random_tour(std::mt19937_64& random) const;
  std::vector<double> random_shares(std::mt19937_64& random,
                                    const std::vector<std::size_t>& tour) const;
  std::vector<double> random_increments(std::mt19937_64& random) const;
  std::vector<double> random_between(std::mt19937_64& random) const;
  std::vector<double> random_angles(std::mt19937_64& random) const;
  std::vector<double> closed_increments(std::mt19937_64& random) const;
  double gap(std::size_t from, std::size_t to) const;
  void set_limits(synthesis::SeparableTarget& target) const;
  void set_direction(synthesis::SeparableTarget& target) const;
  Lengths<double> random_links(std::mt19937_64& random) const;
  void fill(std::mt19937_64& random, synthesis::PathCandidates& candidates) const;
  void fill_about(std::mt19937_64& random, const KnownPath& known,
                  synthesis::PathCandidates& candidates) const;
  std::optional<double> fixed_phase() const;
  PathStart start(const synthesis::SeparableTarget& target, const CrankTiming& timing,
                  const synthesis::PathCandidates& candidates, std::size_t best) const;

  PathProblem problem_;
  std::vector<double> x_, y_, weight_;
  Vec2d origin_;  ///< what x_, y_ are relative to
  double largest_ratio_ = 100;
  std::size_t first_timed_ = 0;  ///< the point from which increments count
};

}  // namespace cognate::problems
