#include "analysis/coupler_curve/circuit_samples.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/batch/design.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/compensated.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/dual.hpp"

namespace cognate {
namespace {

/// √ of a product of which one factor is a square: that of its other factor times the signed root.
Dual signed_root(const Dual& root, const Dual& factor) {
  return root * sqrt(factor);
}

/// The two triangles on the diagonal: four times their signed areas, and δ over its bounds.
struct SampledDiagonal {
  Dual square;        ///< δ = |BD|²
  Dual over_least;    ///< δ − (l₄ − l₁)²
  Dual crank_area;    ///< 2 l₁ l₄ sin θ
  Dual coupler_area;  ///< positive where the assembly is open
};

/// A circuit by its parameter σ. Lengths are in a unit near the longest.
class Circuit {
 public:
  Circuit(const Lengths<double>& links, const CircuitChoice& choice)
      : assembly_(sign(choice.assembly)), half_(choice.half) {
    const auto [l1, l2, l3, l4] = links;
    // (l₄ − l₁)² − (l₂ − l₃)² and (l₂ + l₃)² − (l₄ + l₁)².
    const double low = compensated_sum(l4, -l1, -l2, l3) * compensated_sum(l4, -l1, l2, -l3);
    const double high = compensated_sum(l2, l3, -l4, -l1) * (l1 + l2 + l3 + l4);
    crank_low_ = low >= 0;
    crank_high_ = high >= 0;
    least_ = std::max((l4 - l1) * (l4 - l1), (l2 - l3) * (l2 - l3));
    const double greatest = std::min((l4 + l1) * (l4 + l1), (l2 + l3) * (l2 + l3));
    swing_ = std::max(greatest - least_, 0.0);
    low_gap_ = std::abs(low);
    high_gap_ = std::abs(high);
  }

  /// At σ with the cosine and sine given.
  SampledDiagonal at(double cosine, double sine) const {
    return crank_low_ == crank_high_ ? in_one_turn(cosine, sine) : in_two_turns(cosine, sine);
  }

 private:
  /// σ = τ.
  SampledDiagonal in_one_turn(double cosine, double sine) const {
    const Dual half_swing(0.5 * swing_);
    const Dual rise = half_swing * Dual(1 - cosine, sine);
    const Dual fall = half_swing * Dual(1 + cosine, -sine);
    const Dual root = half_swing * Dual(sine, cosine);
    const Dual other = sqrt((rise + Dual(low_gap_)) * (fall + Dual(high_gap_)));
    if (crank_low_) return {rise + Dual(least_), rise, root, Dual(assembly_) * other};
    return {rise + Dual(least_), rise + Dual(low_gap_), Dual(half_) * other,
            Dual(assembly_ * half_) * root};
  }

  /// σ = τ/2: one end of δ turns the one triangle over, the other the other.
  SampledDiagonal in_two_turns(double cosine, double sine) const {
    const Dual c(cosine, -sine), s(sine, cosine), swing(swing_);
    const Dual rise = swing * s * s, fall = swing * c * c;
    const Dual root(std::sqrt(swing_));
    const Dual by_low = signed_root(root * s, fall + Dual(high_gap_));
    const Dual by_high = signed_root(root * c, rise + Dual(low_gap_));
    const Dual square = rise + Dual(least_), assembly(assembly_);
    if (crank_low_) return {square, rise, by_low, assembly * by_high};
    return {square, rise + Dual(low_gap_), by_high, assembly * by_low};
  }

  double assembly_, half_;
  bool crank_low_ = true, crank_high_ = true;
  double least_ = 0, swing_ = 0;  ///< of δ
  double low_gap_ = 0;            ///< between the two squares that bound δ from below
  double high_gap_ = 0;           ///< and from above
};

/// The coupler point in the frame's axes from A; `ratio` is (P − B)/(C − B).
Vec2<Dual> coupler_point(const Lengths<double>& links, const Vec2d& ratio,
                         const SampledDiagonal& at) {
  const auto [l1, l2, l3, l4] = links;
  const Dual over(1 / (2 * l4));
  const Vec2<Dual> pin{Dual(l1) - over * at.over_least, over * at.crank_area};
  const Vec2<Dual> diagonal{Dual(l4) - pin.x, -pin.y};
  const Dual inverse = Dual(0.5) / at.square;
  const Vec2<Dual> part{inverse * (at.square + Dual((l2 - l3) * (l2 + l3))),
                        inverse * at.coupler_area};
  return pin + Vec2<Dual>{Dual(ratio.x), Dual(ratio.y)} * (part * diagonal);
}

}  // namespace

CircuitChoice circuit_at(const FourBar& linkage, double crank_angle) {
  CircuitChoice choice{linkage.assembly, 1};
  const auto ranges = crank_ranges(lengths(linkage));
  if (ranges.size() < 2) return choice;
  const double angle = in_one_turn(crank_angle - frame_angle(linkage));
  const double last = kTurn + ranges.back().to;
  if (angle > ranges.front().to && angle <= last) choice.half = -1;
  return choice;
}

void CurveRoom::resize(std::size_t count) {
  for (auto* column : {&x, &y, &dx, &dy}) column->resize(count);
}

CycleTable::CycleTable(std::size_t count) : cos(count), sin(count) {
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = kTurn * static_cast<double>(i) / static_cast<double>(count);
    cos[i] = std::cos(angle);
    sin[i] = std::sin(angle);
  }
}

void sample_circuit(const FourBar& linkage, const CircuitChoice& circuit, const CycleTable& table,
                    CurveRoom& curve) {
  const Lengths<double> given = lengths(linkage);
  const double unit =
      batch::power_of_two_below(std::max({given.crank, given.coupler, given.rocker, given.frame}));
  const Lengths<double> links{given.crank / unit, given.coupler / unit, given.rocker / unit,
                              given.frame / unit};
  const Vec2d ratio = (1 / given.coupler) * *linkage.coupler_point;
  const Vec2d axis = (unit / given.frame) * (linkage.pivot_d - linkage.pivot_a);
  const Circuit motion(links, circuit);
  curve.resize(table.cos.size());
  for (std::size_t i = 0; i < table.cos.size(); ++i) {
    const Vec2<Dual> point = coupler_point(links, ratio, motion.at(table.cos[i], table.sin[i]));
    const Vec2d at = linkage.pivot_a + axis * Vec2d{point.x.value, point.y.value};
    const Vec2d rate = axis * Vec2d{point.x.rate, point.y.rate};
    curve.x[i] = at.x;
    curve.y[i] = at.y;
    curve.dx[i] = rate.x;
    curve.dy[i] = rate.y;
  }
}

}  // namespace cognate
