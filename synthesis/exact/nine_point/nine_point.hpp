/// @file Every four-bar whose coupler passes exactly through given points and poses.
///
/// Alt's problem is the one of nine points: 1442 triplets of Roberts cognates, 4326 four-bars
/// (Wampler, Morgan & Sommese, J. Mech. Des. 114, 1992). Where some of the positions have an
/// orientation as well there are fewer unknowns and fewer points: M poses and N further points
/// with 2(M − 1) + N = 8, the Alt–Burmester problems (Brake et al., J. Mech. Rob. 8, 2016). A
/// single pose is no more than a point, so (1, 8) is Alt's problem.
///
///     M  N   four-bars over the complex numbers, counting the swap of the dyads
///     1  8   8652, that is 1442 triplets
///     2  6   2224
///     3  4   402
///     4  2   60
///     5  0   16, that is 4 dyads squared; the 12 of two different dyads are linkages
///
/// All of them are followed from those of a generic problem, which is solved once (start_set.hpp).
#pragma once

#include <array>
#include <complex>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "analysis/batch/instruction_set.hpp"
#include "analysis/numbers/vec2.hpp"
#include "synthesis/exact/nine_point/path_equations.hpp"

namespace cognate::synthesis {

/// A position of the coupler: a point of its path, and its orientation in radians if it is given.
struct PathPose {
  Vec2d at;
  std::optional<double> angle;
};

/// Which of the Alt–Burmester problems: `poses` ≥ 1 counts the reference, `points` the points
/// without orientation beside it.
struct PathClass {
  int poses = 1;
  int points = 8;
  /// Whether both numbers are the same.
  friend bool operator==(const PathClass&, const PathClass&) = default;
};

/// The class of a list of positions, of any number; a single orientation says nothing
/// and counts as none.
PathClass class_of(std::span<const PathPose> positions);

/// A problem in the coordinates of its equations (path_equations.hpp): the plane as complex
/// numbers, with the reference position at the origin and displacements of root mean square 1.
struct PathSystem {
  Vec2d origin;      ///< the reference position in the plane of the caller
  double scale = 1;  ///< the caller's length of 1 here
  PathClass kind;
  std::vector<std::complex<double>> d;  ///< displacements, those of the poses − 1 first
  std::vector<std::complex<double>> t;  ///< rotations e^{i(θⱼ − θ₀)} of the poses − 1
  int reference = 0;                    ///< index of the reference among the caller's positions
  std::vector<int> order;               ///< d[k] belongs to the caller's position order[k]
};

/// One solution, in the coordinates of the PathSystem. In a real one, barred numbers are the
/// conjugates of the others; else they are independent.
struct PathRoot {
  Dyad<std::complex<double>> first, second;
  std::vector<std::complex<double>> rotations;  ///< of the coupler at d[k]; those given included
  double residual = 0;   ///< largest distance by which a point or pose is missed, in scales
  double condition = 0;  ///< largest movement of the pivots for a movement of 1 of the data
  bool real = false;     ///< a linkage of the real plane
};

/// Every way out.
enum class ExactPathStatus {
  solved,       ///< every path was followed to its end
  wrong_count,  ///< 2(poses − 1) + points is not 8
  not_finite,   ///< a coordinate or angle is infinite, no number, or too large to square
  coincident,   ///< two positions ask for the same: a curve of solutions goes through them
  dependent,    ///< given parts and positions determine one dyad more than once
  interrupted,  ///< `stop` returned true: some paths have no end
};

/// Every solution found, and what became of every path.
struct ExactPathSolutions {
  ExactPathStatus status = ExactPathStatus::solved;
  std::array<int, 2> coincident{};  ///< the caller's two positions, where they are the reason
  PathSystem system;
  /// All distinct finite solutions found, one of each triplet of cognates for class (1, 8), else
  /// one of each pair with the dyads swapped. The real ones come first.
  std::vector<PathRoot> roots;
  int tracked = 0;      ///< paths: 1442, 1112, 201, 30 or 6; 0 where stopped before there were any
  int finite = 0;       ///< roots.size()
  int at_infinity = 0;  ///< paths on which a pivot goes to infinity: a slider in place of a crank
  int singular = 0;     ///< paths that end where solutions meet, so that Newton cannot refine them
  int lost = 0;         ///< paths of which nothing is known
  int duplicates = 0;   ///< paths that ended where another one did, after every repetition
  int repeated = 0;     ///< paths that had to be followed again, in another chart or precision
};

/// Resources of a solve, and its progress callback.
struct ExactPathOptions {
  int threads = 0;                       ///< as many as the machine has for 0
  std::optional<InstructionSet> set;     ///< the widest of the machine if empty
  std::filesystem::path cache;           ///< folder for the generic problems; none if empty
  std::function<bool()> stop;            ///< asked often, from one thread at a time
  std::function<void(double)> progress;  ///< the share of the paths that is done, in [0, 1]
};

/// Solves for all positions. The result depends neither on the number of threads nor on the cache.
/// A count below that of the class is no proof of absence: what is lost says how much is missing.
ExactPathSolutions solve_exact_path(std::span<const PathPose> positions,
                                    const ExactPathOptions& options = {});

/// The three cognates of a solution of class (1, 8), `root` first: they trace the same curve.
/// Roberts: (x, a, y, b) → ((x − a)y/(x − y), (bx − ay)/(x − y), a − x, a), the coupler of the next
/// being parallel to the first dyad. Residual and condition are copied.
std::array<PathRoot, 3> cognates(const PathSystem& system, const PathRoot& root);

/// A point of the system's plane in the plane of the caller.
Vec2d to_plane(const PathSystem& system, std::complex<double> z);

}  // namespace cognate::synthesis
