/// @file Four-bars in batches: many crank positions, many designs, many coupler points, on the
/// vector instructions and threads of the machine.
///
///     const auto table = CrankTable<double>::full_turn(360);
///     std::vector<double> x(360), y(360);
///     const BatchStatus status = evaluate_batch(linkage, table, {.x = x, .y = y});
///
/// The quantities computed are those a column is given for, and the loop that runs computes only
/// that (or the smallest compiled set that holds it, see quantities.hpp). Derivatives are by the
/// crank angle: with θ̇ and θ̈ of the crank, velocity = P′·θ̇ and acceleration = P″·θ̇² + P′·θ̈. Where a
/// linkage does not close, every value is NaN; at a dead point, where the links of the dyad are in
/// line, positions are still found and derivatives are not finite.
///
/// Positions keep the accuracy of the closure (see closure.hpp) at any size of the lengths, 1e-150
/// to 1e150. Values depend neither on the number of threads nor on the other designs, but differ by
/// roundings between instruction sets.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "analysis/batch/crank_table.hpp"
#include "analysis/batch/instruction_set.hpp"
#include "analysis/batch/quantities.hpp"
#include "analysis/linkage/four_bar.hpp"

namespace cognate {

/// Designs as a structure of arrays, all of one size; the meaning is that of FourBar's members.
/// `assembly` is +1 (open) or −1 (crossed). The coupler points of design i are
/// (point_u, point_v)[k·size + i], k = 0, 1, …: as many as the arrays hold.
template <class Real>
struct FourBarArrays {
  std::span<const Real> pivot_a_x, pivot_a_y, pivot_d_x, pivot_d_y;
  std::span<const Real> crank, coupler, rocker, assembly;
  std::span<const Real> point_u, point_v;
};

/// Where results go; an empty column is not computed. With n designs, r rows and k coupler points a
/// column has n·r·k values, that of point p, row j and design i at (p·r + j)·n + i. Those of the
/// transmission angle belong to all points and number n·r. Where x is given y must be given, too.
template <class Real>
struct FourBarColumns {
  std::span<Real> x{}, y{};                            ///< the coupler point P
  std::span<Real> velocity_x{}, velocity_y{};          ///< P′ = dP/dθ
  std::span<Real> acceleration_x{}, acceleration_y{};  ///< P″
  /// Of the coupler curve, positive where it turns left as θ grows; not finite at a cusp.
  std::span<Real> curvature{};
  /// Sine and cosine of μ = ∠BCD; the sine has the sign of the assembly.
  std::span<Real> transmission_sin{}, transmission_cos{};
  /// ∂P by each DesignVariable.
  std::array<std::span<Real>, kDesignVariables> gradient_x{}, gradient_y{};
};

/// On what a batch runs.
struct BatchOptions {
  int threads = 1;                                  ///< 0: as many as the machine has
  std::optional<InstructionSet> instruction_set{};  ///< the widest there is, if empty
};

/// Every way out of a batch.
enum class BatchStatus {
  done,
  nothing_wanted,    ///< every column is empty
  sizes_differ,      ///< arrays or columns have not the sizes described, or a half is missing
  no_coupler_point,  ///< a column needs a coupler point that is not given
  missing_instruction_set,  ///< this machine or build has not what the options ask for
};

/// One design at every position of `cranks` (lanes are crank positions).
template <class Real>
[[nodiscard]] BatchStatus evaluate_batch(const FourBar& linkage, const CrankTable<Real>& cranks,
                                         const FourBarColumns<Real>& columns,
                                         const BatchOptions& options = {});

/// Every design with each of its coupler points at every position of `cranks` (lanes are designs).
template <class Real>
[[nodiscard]] BatchStatus evaluate_batch(const FourBarArrays<Real>& linkages,
                                         const CrankTable<Real>& cranks,
                                         const FourBarColumns<Real>& columns,
                                         const BatchOptions& options = {});

}  // namespace cognate
