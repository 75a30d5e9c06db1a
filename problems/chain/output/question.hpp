/// @file The tolerances of a chain whose output is an angle or a displacement.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "problems/linkage/design_tolerances.hpp"

namespace cognate::problems {

/// A question whose first quantity is the output's angle, as what is judged, without offsets.
struct OutputQuestion {
  ToleranceQuestion question;
  std::vector<Vec2d> way;  ///< the nominal response at each station
};

/// The angle of the way between the points called `output` at crank angles (radians); empty where
/// the mechanism cannot be assembled at one of them.
std::optional<OutputQuestion> output_question(const NamedMechanism& mechanism,
                                              const std::array<std::string, 2>& output,
                                              const std::vector<double>& angles);

/// The same for the displacement of the slider whose pin has this name, along its guide.
std::optional<OutputQuestion> displacement_question(const NamedMechanism& mechanism,
                                                    const std::string& pin,
                                                    const std::vector<double>& angles);

}  // namespace cognate::problems
