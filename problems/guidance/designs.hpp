/// @file The designs by least squares that searches come to, and how a problem is searched for
/// them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problems/guidance/design.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"
#include "problems/search/statistics.hpp"

namespace cognate::problems {

/// Two dyads and where they hold the body at each pose, in the file's unit.
struct HeldBody {
  DyadPair pair;
  std::vector<synthesis::Pose> reached;
};

/// The design of two dyads.
struct RatedMotion {
  HeldBody body;
  Design design;
  double violation = 0;         ///< of the file's constraints; see verify.hpp
  bool first_is_driven = true;  ///< of the problem whose minimum it is
};

/// The different designs among minima, by whichever dyad may drive.
class MotionDesigns {
 public:
  /// `problem`, by which they are verified, must outlive this object; `size`: its own, as of
  /// MotionScale.
  MotionDesigns(const MotionProblem& problem, double size) : problem_(problem), size_(size) {}

  /// Adds what has a design and is not known.
  void add(HeldBody body, const std::string& origin, bool first_is_driven);

  bool any_feasible() const { return !feasible_.empty(); }

  /// Best first: feasible ones if there are any. Those that meet the poses to rounding come first,
  /// by their transmission angle, the others by violation and error.
  std::vector<RatedMotion>& ranked();
  /// The designs of as many of these as the file asks for.
  std::vector<Design> take();

 private:
  std::optional<RatedMotion> candidate(HeldBody body, const std::string& origin) const;

  const MotionProblem& problem_;
  double size_;
  std::vector<RatedMotion> feasible_, violating_;
};

/// The root mean square error of a design, angles by their weight: a length.
double error_of(const MotionProblem& problem, const Design& design);

/// Relative change at which refinements stop unless the file says otherwise.
inline constexpr double kMotionTolerance = 1e-13;

/// The design that is verified of two dyads, computed by the kernel; see nearest_design.
std::optional<Design> verified_design(const MotionProblem& problem, const HeldBody& body,
                                      const std::string& origin);

/// The searches of a problem: pivots that are given do not say which dyad is driven.
std::vector<MotionProblem> drives_of(const MotionProblem& problem);

/// How many starts each of so many searches refines; empty: until more promise nothing new.
std::optional<int> starts_of(const MotionProblem& problem, std::size_t searches);

/// Searches one drive, and adds its minima to `designs`.
SearchStatistics add_minima(const MotionProblem& drive, std::optional<int> starts, const Run& run,
                            const Deadline& deadline, MotionDesigns& designs, Work& work);

/// Of two searches for the same thing.
SearchStatistics together(const SearchStatistics& a, const SearchStatistics& b);

}  // namespace cognate::problems
