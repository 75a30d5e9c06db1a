/// @file What a mechanism is, by its type and dimensions alone.
#pragma once

#include <vector>

#include "problems/basics/quantity_key.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::problems {

inline constexpr QuantityKey<std::string> kClassKey{"class"};
inline constexpr QuantityKey<bool> kChangePointKey{"change_point"};
inline constexpr QuantityKey<bool> kCrankTurnsKey{"crank_turns_fully"};
inline constexpr QuantityKey<double> kMobilityKey{"mobility"};

/// The dimensions whose closed forms hold for `mechanism`: of an inversion those of the
/// slider-crank or guide-bar that moves alike, else its own.
template <class Type>
decltype(auto) dimensions_of_formulas(const Type& mechanism) {
  if constexpr (requires { as_slider_crank(mechanism); }) {
    return as_slider_crank(mechanism);
  } else if constexpr (requires { as_guide_bar(mechanism); }) {
    return as_guide_bar(mechanism);
  } else {
    return (mechanism);
  }
}

/// `class`, `mobility`, and where the type has a closed form `change_point` and
/// `crank_turns_fully`. The class of a four-bar is Grashof's, of a slider-crank, a guide-bar and
/// their inversions which link turns; a double slider has its type's name and a chain the types of
/// its dyads: "RPR+RRP chain". Of a four-bar also `rocker_turns_fully`. `change_point_kind`
/// (analysis/linkage/change_point.hpp) and `moves_as`: of a four-bar with a change point, the
/// motion on which it stands at the drive's `start`.
std::vector<Quantity> type_quantities(const NamedMechanism& mechanism, double start);

}  // namespace cognate::problems
