/// @file Forces and torques of mechanisms whose lengths are not in metres.
#pragma once

#include "problems/evaluation/problem.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::problems {

/// `problem` of lengths in units of `metres`, with inertias and torques so that forces come out in
/// N and torques in N times that unit.
AnalysisProblem in_newtons(AnalysisProblem problem, double metres);

/// Brings the torques and moments of `result` from N times the unit to N·m.
void to_newton_metres(AnalysisResult& result, double metres);

/// The note of `unit_notes` (basics/unit_notes.hpp) where `problem` has masses, loads or gravity.
std::vector<std::string> unit_notes(const AnalysisProblem& problem, std::optional<LengthUnit> unit);

/// `rule` and `problem` with masses and forces so large that inertias and torques at the drive come
/// out in kg·m² and N·m.
LoadRule in_joules(LoadRule rule, double metres);
AnalysisProblem in_joules(AnalysisProblem problem, double metres);

}  // namespace cognate::problems
