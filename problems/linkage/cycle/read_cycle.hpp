/// @file What a file limits over the full turn of the crank, and how the linkage is driven and
/// loaded meanwhile.
#pragma once

#include <string_view>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// What a kind of problem can limit over the turn.
struct CycleScope {
  std::string_view refusal;  ///< why nothing, to follow "constraints.clearance "; else empty
  bool has_place = true;     ///< whether the fixed pivots have a place in the plane
  bool has_coupler_point = true;
};

/// Faults what cannot be limited over the turn, or not with the class that has been read.
void check_over_turn(TableReader& constraints, std::string_view key, const CycleScope& scope,
                     const Constraints& limits);

/// `clearance` of `[constraints]`, after its class has been read.
void read_clearances(TableReader& constraints, const CycleScope& scope, Constraints& limits);

/// `clearance` and the limits of `kCycleQuantities` of `[constraints]`, after its class has been
/// read, and of `document` what these refer to: `[drive]`, `[flywheel]`, `[[link]]`, `[[load]]` and
/// `gravity`. What `objectives` of the table `solve` names without a limit is to be known, too.
void read_cycle_limits(TableReader& document, TableReader& constraints, const TableReader& solve,
                       const CycleScope& scope, Constraints& limits);

/// Why `certify` is refused beside such limits.
inline constexpr std::string_view kTurnNotCertified =
    "is true with limits over the full turn of the crank, of which a certificate knows nothing; "
    "remove it";

}  // namespace cognate::problems::reading
