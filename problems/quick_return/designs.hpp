/// @file Quick-return mechanisms as designs: checked by the analysis kernel, mirror images marked.
#pragma once

#include <string>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/quick_return/problem.hpp"
#include "synthesis/exact/quick_return/guide.hpp"
#include "synthesis/exact/quick_return/rocker.hpp"
#include "synthesis/exact/quick_return/shaper.hpp"
#include "synthesis/exact/quick_return/slider.hpp"

namespace cognate::problems {

/// The target of a four-bar's `problem`.
synthesis::RockerTask rocker_task(const QuickReturnProblem& problem);

/// `crank_angles` are those of the two limits; the error is that of the time ratio as simulated.
Design quick_return_design(const QuickReturnProblem& problem,
                           const synthesis::QuickReturnRocker& found);
Design quick_return_design(const QuickReturnProblem& problem,
                           const synthesis::QuickReturnSlider& found);
Design quick_return_design(const QuickReturnProblem& problem,
                           const synthesis::QuickReturnGuide& found);
Design quick_return_design(const QuickReturnProblem& problem, const synthesis::Shaper& found,
                           const synthesis::RamMotion& motion);

/// The shaper by the names of the analysis library: pivots A (of the crank) and C (of the bar),
/// bodies crank, block, bar, rod and ram, pins B (crank), D (the bar's end) and E (ram).
NamedMechanism named_shaper(const synthesis::Shaper& shaper);

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
