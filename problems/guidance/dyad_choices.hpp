/// @file The dyads that a body guidance may be built of: those that the poses and the pivots given
/// leave, as a list or as a family to search.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problems/guidance/problem.hpp"
#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::problems {

/// The parameters of a family of dyads.
using DyadPlace = std::array<double, 4>;

/// A dyad, and where it stands in its family: parameters, and the step in each of them over which a
/// search from here begins (0 where it is not to be moved).
struct DyadChoice {
  synthesis::GuidingDyad dyad;
  DyadPlace at{};
  DyadPlace step{};
};

/// What one of the two dyads may be. Without `dyad_at` `choices` are all there are.
struct DyadChoices {
  std::vector<DyadChoice> choices;
  std::function<std::optional<synthesis::GuidingDyad>(const DyadPlace&)> dyad_at;
  std::vector<std::string> notes;  ///< what is special, or why there is none
  bool is_degenerate = false;      ///< `notes` say why the poses have no two dyads

  bool is_family() const { return static_cast<bool>(dyad_at); }
};

/// Both dyads. Where `second` is empty both are taken from `first`.
struct DyadPairChoices {
  DyadChoices first;
  std::optional<DyadChoices> second;
};

/// Two or three poses: the dyads of the pivots given, in the order moving, fixed; where a pivot is
/// missing, links of any moving pivot within 1.5 extents of the poses from the body's origin, and
/// where `dyads` leaves a kind out, sliders and blocks as far as it allows them.
DyadPairChoices dyads_of_few_poses(const MotionProblem& problem);

/// The dyads that the poses alone leave: four poses Burmester's curves, five a list.
DyadChoices dyad_of_four_poses(const MotionProblem& problem);
DyadChoices dyad_of_five_poses(const MotionProblem& problem);

/// Whether the problem allows dyads of a kind.
bool allows(const MotionProblem& problem, synthesis::DyadKind kind);

}  // namespace cognate::problems
