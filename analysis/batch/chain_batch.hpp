/// @file A mechanism of any dyads at many positions of its drive, on the vector instructions and
/// threads of the machine (lanes are positions).
///
///     const DriveTable drives(mechanism, angles);
///     std::vector<double> x(angles.size()), y(angles.size());
///     ChainColumns columns;
///     columns.points.push_back({{2, {0.5, 0.25}}, {x}, {y}});
///     const BatchStatus status = evaluate_batch(mechanism, sides(mechanism), drives, columns);
///
/// The highest derivative for which a column is given decides what is computed. Values are those of
/// `evaluate` in mechanism/kinematics.hpp but for roundings; they are NaN where a dyad that they
/// depend on cannot be assembled.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "analysis/batch/four_bar_batch.hpp"
#include "analysis/mechanism/mechanism.hpp"

namespace cognate {

/// Positions of a drive, made once and used for any number of calls.
class DriveTable {
 public:
  /// `coordinates` in radians, or displacements of a driving slider.
  DriveTable(const Mechanism<double>& mechanism, std::span<const double> coordinates);

  /// How many positions, and what the kernels read of each: the direction of a crank, or the
  /// displacement of a driving slider.
  std::size_t size() const { return cos_.size(); }
  std::span<const double> cos() const { return cos_; }
  std::span<const double> sin() const { return sin_; }
  std::span<const double> displacement() const { return displacement_; }

 private:
  std::vector<double> cos_, sin_, displacement_;
};

/// Where results go, each column as long as the table of drives or empty (not computed); x
/// and y (cosine and sine) go together. Column k holds the k-th derivative by the drive.
struct PointColumns {
  Attached<double> point;
  std::array<std::span<double>, 4> x, y;
};

/// The direction of a body's first axis, and the derivatives φ′, φ″, φ‴ of its angle.
struct BodyColumns {
  int body = 0;
  std::span<double> cos, sin;
  std::array<std::span<double>, 3> turn;
};

/// Sine and cosine of a dyad's transmission angle, as in DyadClosure.
struct DyadColumns {
  int dyad = 0;
  std::span<double> sine, cosine;
};

/// All that is computed of a chain: of points, of bodies, of dyads.
struct ChainColumns {
  std::vector<PointColumns> points;
  std::vector<BodyColumns> bodies;
  std::vector<DyadColumns> dyads;
};

/// The mechanism with `sides` (one for each dyad) at every position of `drives`.
[[nodiscard]] BatchStatus evaluate_batch(const Mechanism<double>& mechanism,
                                         std::span<const double> sides, const DriveTable& drives,
                                         const ChainColumns& columns,
                                         const BatchOptions& options = {});

}  // namespace cognate
