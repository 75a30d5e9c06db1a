/// @file What holds of a motion as a whole.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/linkage/mobility.hpp"
#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

struct MotionSummary {
  std::optional<TransmissionAngles> transmission;  ///< of all dyads together
  std::optional<double> time_ratio;
  std::vector<Quantity> quantities;  ///< others
  std::vector<Landmark> landmarks;
  int ranges = 0;           ///< that the drive crosses
  double from = 0, to = 0;  ///< the first of them, to which the stroke belongs
  std::string endless{};    ///< the output, where its stroke goes to infinity
};

/// Over `assembly_ranges`: extremes of transmission and pressure angles in all its ranges, the
/// output's stroke or swing (in the range driven, the first of several, and on the whole circuit)
/// and the time ratio (in closed form where the type has one; of the crank's whole turn), with the
/// places where they stand, dead points and change points as landmarks in the order of the motion.
/// Nothing where the mechanism can be assembled nowhere. Once `deadline` is reached it is not of
/// the whole motion.
MotionSummary summarise(const AnalysisProblem& problem, const AssemblyRanges& assembly_ranges,
                        const Deadline& deadline);

/// All that a summary has in numbers, as it is reported.
std::vector<Quantity> quantities_of(const MotionSummary& summary);

}  // namespace cognate::problems
