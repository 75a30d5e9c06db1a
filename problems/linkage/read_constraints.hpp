/// @file `[constraints]` and `[solve]`.
#pragma once

#include <string_view>

#include "problems/linkage/class_feasibility.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// `[constraints]` of any linkage, without `pivot_region`; `limits` decides whether the class and
/// the link ratio requested are possible at all.
void read_link_constraints(TableReader& table, const LengthLimits& limits,
                           Constraints& constraints);

/// `constraints.pivot_region`, and whether the pivots given lie in it.
void read_pivot_region(TableReader& table, const Given& given, Constraints& constraints);

/// The most designs that a search may be requested.
inline constexpr int kMostSearchedDesigns = 100;

/// `[solve]`, without the keys that it shares with `[target]`. `minimax`: the objective requested.
Solve read_solve(TableReader& table, const Constraints& constraints, bool minimax,
                 int most_designs = kMostSearchedDesigns);

/// `solve.designs`, at most `most_designs`, into `solve`.
void read_design_count(TableReader& table, int most_designs, Solve& solve);

/// Whether `solver` can have so many unknowns, the crank angle of each point or pose among them.
void check_unknown_count(TableReader& table, synthesis::Solver solver, int count);

/// `solve.loss` and `solve.loss_scale`. `other`: the method of the file instead of least squares,
/// to which no loss belongs, e.g. `objective = "minimax"`; empty where it is least squares.
void read_loss(TableReader& table, std::string_view other, Solve& solve);

/// `solve.certify` and `solve.certify_gap` into `solve`. `refusal`: why this problem cannot be
/// certified and what can, for a message; empty where it can be.
void read_certificate(TableReader& table, std::string_view refusal, Solve& solve);

/// `robust`. `refusal`: what speaks against it, "is given with …".
void read_robust(TableReader& table, std::string_view refusal, Solve& solve);

}  // namespace cognate::problems::reading
