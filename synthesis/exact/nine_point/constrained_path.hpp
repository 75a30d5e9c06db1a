/// @file Every four-bar through fewer points and poses, some of its parts being given.
///
/// M poses, N further points and g conditions by given parts (given_parts.hpp) with 2(M − 1) + N +
/// g = 8 have finitely many solutions in general: five points with both pivots given have 36 (A. P.
/// Morgan & C. W. Wampler, J. Mech. Des. 112, 1990). Dyads are distinguished: the first is the
/// crank.
///
/// The generic problem of each kind is solved by monodromy from one planted solution, its data
/// random complex numbers: loops are made until three in a row find nothing new, which is evidence,
/// not proof, that there are no more. Its solutions are followed to the desired data. A class that
/// is met first takes most of its time there; it is kept for the next problem.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "synthesis/exact/nine_point/fixed_parts.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"

namespace cognate::synthesis {

/// Resources of a solve, and its progress callback.
struct ConstrainedPathOptions {
  int threads = 0;                       ///< as many as the machine has for 0
  std::function<bool()> stop;            ///< asked often, from any thread
  std::function<void(double)> progress;  ///< the share that is done, in [0, 1]
  std::filesystem::path cache;           ///< folder for the generic problems; none if empty
};

/// `solutions.tracked` is the number of solutions of the generic problem, 0 where there was no time
/// to solve it.
struct ConstrainedPathSolutions {
  ExactPathSolutions solutions;
  bool settled = true;                    ///< the last loops of monodromy found nothing new
  std::vector<SideCondition> conditions;  ///< in the coordinates of the system
};

/// Whether positions and given parts, eight conditions at most, are independent of one another: not
/// where they determine one dyad more than once, as four poses do along with its fixed pivot.
bool are_independent(const PathClass& kind, const FixedParts& given);

/// Solves for all positions. `wrong_count` where there are too many or too few conditions,
/// `dependent` where these are not independent of one another. The result does not
/// depend on the number of threads.
ConstrainedPathSolutions solve_constrained_path(std::span<const PathPose> positions,
                                                const FixedParts& given,
                                                const ConstrainedPathOptions& options = {});

}  // namespace cognate::synthesis
