/// @file A coupler curve ready to be searched: its point, derivatives and zeros of functions of it.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "analysis/coupler_curve/circuits.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate {

/// A place on one of the circuits' arcs.
struct ArcPlace {
  const CircuitArc* arc = nullptr;
  double place = 0;
};

/// The coupler point there, in the frame's axes and the curve's unit, with its derivatives.
struct TracedPoint {
  LinkPose pose;
  std::array<Vec2d, 4> motion;
  double speed = 0;  ///< the sum of the speeds that B and P about B have, which P's cannot exceed
};

/// A four-bar's coupler curve over the lengths divided by a power of two. The linkage has a coupler
/// point.
class TracedCurve {
 public:
  /// The curve on all circuits, or on one alone.
  explicit TracedCurve(const FourBar& linkage, std::optional<int> circuit = std::nullopt);

  const Circuits& circuits() const { return circuits_; }
  double unit() const { return unit_; }
  double frame() const { return links_.frame; }

  /// (P − B)/(C − B).
  Vec2d ratio() const { return (1 / links_.coupler) * point_; }

  TracedPoint at(const ArcPlace& where) const;

  /// Zeros of `f` over all circuits where it changes its sign; `slope` is its derivative by the
  /// curve's parameter, either way: it shows where to look for two zeros in one cell. Both take a
  /// TracedPoint. Places at which the motion itself stands still (change points) are left out.
  template <class Function, class Slope>
  std::vector<ArcPlace> zeros(Function f, Slope slope) const {
    std::vector<ArcPlace> found;
    const TracedPoint* sample = samples_.data();
    for (const CircuitArc& arc : circuits_.arcs()) {
      const auto value = [&](double place) { return f(at({&arc, place})); };
      const auto change = [&](double place) { return slope(at({&arc, place})); };
      const auto add = [&](double place) {
        if (moves({&arc, place})) found.push_back({&arc, place});
      };
      const auto refine = [&](double a, double at_a, double b, double at_b) {
        add(better_end(value, bracket_zero(value, a, at_a, b, at_b)));
      };
      for (int k = 0; k < kCells; ++k, ++sample) {
        const double a = place_of(arc, k), at_a = f(sample[0]);
        const double b = place_of(arc, k + 1), at_b = f(sample[1]);
        if (at_a == 0) {
          add(a);
        } else if (at_a * at_b < 0) {
          refine(a, at_a, b, at_b);
        } else if (const double change_a = slope(sample[0]), change_b = slope(sample[1]);
                   at_b != 0 && change_a * change_b < 0) {
          const double peak = bracket_zero(change, a, change_a, b, change_b).first;
          const double at_peak = value(peak);
          if (at_peak * at_a < 0) {
            refine(a, at_a, peak, at_peak);
            refine(peak, at_peak, b, at_b);
          }
        }
      }
      ++sample;
    }
    return found;
  }

 private:
  static constexpr int kCells = 480;

  static double place_of(const CircuitArc& arc, int cell) {
    return arc.from + (arc.to - arc.from) * cell / kCells;
  }

  bool moves(const ArcPlace& where) const;

  double unit_ = 1;
  Lengths<double> links_;
  Vec2d point_;
  double arm_ = 0;  ///< of the point about B
  Circuits circuits_;
  std::vector<TracedPoint> samples_;  ///< the ends of the cells of each arc
};

}  // namespace cognate
