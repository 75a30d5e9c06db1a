/// @file Where a crank may begin a motion that has to stay in one range of its mechanism.
#pragma once

#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/chain/scaled.hpp"

namespace cognate::problems {

/// The crank angles from which all of [`least`, `greatest`], counted from there, lies in one range
/// of `mechanism`; a whole turn of them where its crank turns fully.
std::vector<DriveRange> starts_within_ranges(const Mechanism<double>& mechanism, double least,
                                             double greatest);

/// Phases of the crank of a timed path from which its own is refined, spread over those at which
/// the chain can be assembled at all points.
std::vector<std::vector<double>> first_phases(const ScaledChain& problem,
                                              const synthesis::ChainDesign& design, int per_turn);

/// Whether they are a whole turn.
bool is_whole_turn(const DriveRange& starts);

/// The middles of equal parts of `starts`: so many of them as a whole turn has `per_turn`, and
/// enough of the narrowest.
std::vector<double> spread_over(const DriveRange& starts, int per_turn);

}  // namespace cognate::problems
