/// @file What holds of a motion as a whole.
#pragma once

#include <string>
#include <vector>

#include "analysis/mechanism/course.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/linkage/deadline.hpp"

namespace cognate::problems {

struct MotionSummary {
  std::vector<Fact> facts;
  std::vector<Landmark> landmarks;
  int ranges = 0;           ///< that the drive crosses
  double from = 0, to = 0;  ///< the first of them, to which the stroke belongs
  std::string endless{};    ///< the output, where its stroke goes to infinity
};

/// Over `course`: extremes of transmission and pressure angles in all its ranges, the output's
/// stroke or swing (in the range driven, the first of several, and on the whole circuit) and the
/// time ratio (in closed form where the type has one; of the crank's whole turn), with the places
/// where they stand, dead points and change points as landmarks in the order of the motion.
/// Nothing where the mechanism can be assembled nowhere. Once `deadline` is reached it is not of
/// the whole motion.
MotionSummary summarise(const AnalysisProblem& problem, const Course& course,
                        const Deadline& deadline);

}  // namespace cognate::problems
