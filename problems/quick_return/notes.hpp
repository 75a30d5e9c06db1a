/// @file Why a quick return has no mechanism, or more than a few, in words.
#pragma once

#include <string>
#include <vector>

#include "problems/quick_return/problem.hpp"
#include "synthesis/exact/quick_return/rocker.hpp"
#include "synthesis/exact/quick_return/shaper.hpp"
#include "synthesis/exact/quick_return/slider.hpp"

namespace cognate::problems {

/// Names a degeneracy; where nothing was found, what there could be: the intervals of the length
/// given, pivots on two circuits, or a time ratio too great for the swing.
std::vector<std::string> rocker_notes(const QuickReturnProblem& problem,
                                      const synthesis::RockerSolutions& found);
std::vector<std::string> slider_notes(const QuickReturnProblem& problem,
                                      const synthesis::SliderSolutions& found);

/// Why there is no guide-bar.
std::string guide_note(const QuickReturnProblem& problem);

/// Why there is no shaper.
std::string shaper_note(synthesis::ShaperOutcome outcome);

}  // namespace cognate::problems
