#include "problems/dwell/verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/chain/verify.hpp"
#include "problems/dwell/space.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

constexpr int kWindowSamples = 721, kTurnSamples = 1441;
constexpr int kGoldenSteps = 40;
/// Crank angles reported of a dwell, for which its mean square counts in the sum of squares.
constexpr int kEnds = 2;

/// The output over a part of the turn, radians.
struct OutputRange {
  double least = kInfinity, greatest = -kInfinity;
  double square = 0;  ///< mean, of the deviation from the middle

  double middle() const { return 0.5 * (least + greatest); }
  double half_band() const { return 0.5 * (greatest - least); }
  bool known() const { return std::isfinite(least) && std::isfinite(greatest); }
};

/// The direction of the output along the crank.
class Output {
 public:
  Output(const DwellProblem& problem, const NamedMechanism& mechanism)
      : motion_(mechanism.mechanism) {
    for (std::size_t i = 0; i < 2; ++i) {
      points_[i] = std::ranges::find(mechanism.points, problem.output[i], &NamedPoint::name)->at;
    }
  }

  /// Angles are counted from the direction `reference`, the first within half a turn of it.
  OutputRange over(double from, double to, int samples, const Vec2d& reference) {
    crank_.clear();
    angle_.clear();
    for (int i = 0; i < samples; ++i) {
      crank_.push_back(from + (to - from) * i / (samples - 1));
      const Vec2d way = way_at(crank_.back());
      const double angle = relative_angle(way, reference);
      angle_.push_back(i == 0 ? angle
                              : angle_.back() + std::remainder(angle - angle_.back(), kTurn));
    }
    return range();
  }

  Vec2d way_at(double crank) {
    if (!motion_.move_to(crank)) return {std::numeric_limits<double>::quiet_NaN(), 0};
    return motion_.point(points_[1])[0] - motion_.point(points_[0])[0];
  }

 private:
  OutputRange range() {
    OutputRange range;
    for (const double angle : angle_) {
      if (!std::isfinite(angle)) return {};
    }
    for (std::size_t i = 0; i < angle_.size(); ++i) {
      range.least = std::min(range.least, -extreme(i, -1));
      range.greatest = std::max(range.greatest, extreme(i, 1));
    }
    for (const double angle : angle_) {
      range.square += (angle - range.middle()) * (angle - range.middle()) / double(angle_.size());
    }
    return range;
  }

  /// The greatest of sense·angle about sample i, refined where it is greater than its neighbours.
  double extreme(std::size_t i, double sense) {
    const double here = sense * angle_[i];
    const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, angle_.size() - 1);
    if (sense * angle_[before] > here || sense * angle_[after] > here) return here;
    const Vec2d way = way_at(crank_[i]);
    const auto lowered = [&](double crank) { return -sense * relative_angle(way_at(crank), way); };
    const auto found = golden_section(lowered, crank_[before], crank_[after], kGoldenSteps);
    return here + std::max(0.0, -found.least());
  }

  MechanismMotion<0> motion_;
  std::array<Attached<double>, 2> points_;
  std::vector<double> crank_, angle_;
};

void check_least(const std::string& name, double value, double least, Design& design) {
  design.constraints.push_back(
      {name, degrees(value), degrees(least), value >= least - kCheckTolerance});
}

void check_band(const Dwell& dwell, std::size_t k, double half_band, Design& design) {
  const auto& most = dwell.half_band_max;
  if (!most) return;
  design.constraints.push_back({fmt::format("dwell[{}].half_band_deg_max", k + 1),
                                degrees(half_band), degrees(*most),
                                half_band <= *most + kCheckTolerance});
}

/// The dwells, with the direction `reference` as the zero of angles.
std::vector<OutputRange> measure_dwells(const DwellProblem& problem,
                                        const std::vector<double>& starts, const Vec2d& reference,
                                        Output& output, Design& design) {
  std::vector<OutputRange> dwells;
  TargetError& error = design.error;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const double to = starts[k] + problem.dwells[k].over;
    dwells.push_back(output.over(starts[k], to, kWindowSamples, reference));
    const OutputRange& dwell = dwells.back();
    error.max = dwell.known() ? std::max(error.max, dwell.half_band()) : kInfinity;
    error.sum_of_squares += dwell.known() ? kEnds * dwell.square : kInfinity;
    for (const double at : {starts[k], to}) design.crank_angles.push_back(in_one_turn(at));
    design.metrics.quantities.push_back(
        {k == 0 ? "dwell_from_deg" : "dwell_2_from_deg", degrees(in_one_turn(starts[k]))});
  }
  error.rms = std::sqrt(error.sum_of_squares / (kEnds * double(starts.size())));
  return dwells;
}

/// Half bands, swing and levels, with their checks.
void measure_output(const DwellProblem& problem, const NamedMechanism& mechanism,
                    const std::vector<double>& starts, Design& design) {
  Output output(problem, mechanism);
  const Vec2d reference = output.way_at(starts[0]);
  const OutputRange turn = output.over(0, kTurn, kTurnSamples, reference);
  const double swing = std::min(kTurn, turn.greatest - turn.least);
  const auto dwells = measure_dwells(problem, starts, reference, output, design);
  auto& quantities = design.metrics.quantities;
  quantities.push_back({"half_band_deg", degrees(design.error.max)});
  quantities.push_back({"swing_deg", degrees(swing)});
  if (problem.swing_min > 0) check_least("swing_deg_min", swing, problem.swing_min, design);
  for (std::size_t k = 0; k < dwells.size(); ++k) {
    check_band(problem.dwells[k], k, dwells[k].half_band(), design);
  }
  if (!problem.apart || dwells.size() < 2) return;
  const double apart = std::abs(dwells[1].middle() - dwells[0].middle());
  quantities.push_back({"apart_deg", degrees(apart)});
  check_least("apart_deg", apart, *problem.apart, design);
}

}  // namespace

Design verified(const DwellProblem& problem, const Topology& topology, NamedMechanism mechanism,
                const std::vector<double>& starts) {
  Design design;
  design.metrics.quantities.push_back({"topology", topology.name});
  measure_output(problem, mechanism, starts, design);
  const AssemblyRanges motion = follow(mechanism.mechanism, 0, kTurn);
  measure_transmission(topology, mechanism, motion, design.metrics);
  check_transmission(problem.constraints.transmission_angle, design);
  check_circuit(motion, design);
  design.mechanism = std::move(mechanism);
  return design;
}

}  // namespace cognate::problems
