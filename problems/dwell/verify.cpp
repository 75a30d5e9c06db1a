#include "problems/dwell/verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/chain/crank_motion.hpp"
#include "problems/chain/output/body.hpp"
#include "problems/chain/verify.hpp"
#include "problems/dwell/space.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

constexpr int kWindowSamples = 721, kTurnSamples = 1441;
constexpr int kGoldenSteps = 40;
/// Crank angles reported of a dwell, for which its mean square counts in the sum of squares.
constexpr int kEnds = 2;

/// The output over a part of the turn, radians or a length.
struct OutputRange {
  double least = kInfinity, greatest = -kInfinity;
  double square = 0;  ///< mean, of the deviation from the middle

  double middle() const { return 0.5 * (least + greatest); }
  double half_band() const { return 0.5 * (greatest - least); }
  bool known() const { return std::isfinite(least) && std::isfinite(greatest); }
};

/// The output along the crank: the direction of a link, or the displacement of a slider.
class Output {
 public:
  Output(const DwellProblem& problem, const NamedMechanism& mechanism)
      : motion_(mechanism.mechanism) {
    if (slides(problem)) guide_ = guide_of(mechanism, problem.output[1]);
    for (std::size_t i = guide_ ? 1 : 0; i < 2; ++i) {
      points_.at(i) =
          std::ranges::find(mechanism.points, problem.output.at(i), &NamedPoint::name)->at;
    }
  }

  /// Angles are counted from the direction `reference`, the first within half a turn of it.
  OutputRange over(double from, double to, int samples, const Vec2d& reference) {
    crank_.clear();
    output_.clear();
    for (int i = 0; i < samples; ++i) {
      crank_.push_back(from + (to - from) * i / (samples - 1));
      const double here = difference(way_at(crank_.back()), reference);
      const bool follows = i > 0 && !guide_;
      output_.push_back(follows ? output_.back() + std::remainder(here - output_.back(), kTurn)
                                : here);
    }
    return range();
  }

  /// Those of the last range.
  const std::vector<double>& sampled() const { return output_; }

  /// The direction of the output; of a slider its displacement as x.
  Vec2d way_at(double crank) {
    if (!motion_.move_to(crank)) return {std::numeric_limits<double>::quiet_NaN(), 0};
    const Vec2d to = motion_.point(points_[1]);
    if (guide_) return {dot(guide_->direction, to - guide_->through), 0};
    return to - motion_.point(points_[0]);
  }

 private:
  double difference(const Vec2d& way, const Vec2d& reference) const {
    return guide_ ? way.x - reference.x : relative_angle(way, reference);
  }

  OutputRange range() {
    OutputRange range;
    for (const double output : output_) {
      if (!std::isfinite(output)) return {};
    }
    for (std::size_t i = 0; i < output_.size(); ++i) {
      range.least = std::min(range.least, -extreme(i, -1));
      range.greatest = std::max(range.greatest, extreme(i, 1));
    }
    for (const double output : output_) {
      range.square +=
          (output - range.middle()) * (output - range.middle()) / double(output_.size());
    }
    return range;
  }

  /// The greatest of sense·output about sample i, refined where it is greater than its neighbours.
  double extreme(std::size_t i, double sense) {
    const double here = sense * output_[i];
    const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, output_.size() - 1);
    if (sense * output_[before] > here || sense * output_[after] > here) return here;
    const Vec2d way = way_at(crank_[i]);
    const auto lowered = [&](double crank) { return -sense * difference(way_at(crank), way); };
    const auto found = golden_section(lowered, crank_[before], crank_[after], kGoldenSteps);
    return here + std::max(0.0, -found.least());
  }

  CrankMotion motion_;
  std::array<Attached<double>, 2> points_{};  ///< of a slider the second alone: its pin
  std::optional<Guide<double>> guide_;        ///< of a slider
  std::vector<double> crank_, output_;
};

/// What names, units and tolerances of outputs are: those of angles, or those of displacements,
/// which are relative to the stroke.
struct OutputWords {
  bool slides;
  double size;  ///< of what a check counts relative to

  explicit OutputWords(const DwellProblem& problem)
      : slides(problems::slides(problem)), size(slides ? problem.swing_min : 1) {}

  double shown(double output) const { return slides ? output : degrees(output); }
  const char* of(const char* displacement, const char* angle) const {
    return slides ? displacement : angle;
  }
  void check_least(const std::string& name, double value, double least, Design& design) const {
    design.constraints.push_back(
        {name, shown(value), shown(least), value >= least - kCheckTolerance * size});
  }
  void check_band(const Dwell& dwell, std::size_t k, double half_band, Design& design) const {
    const auto& most = dwell.half_band_max;
    if (!most) return;
    design.constraints.push_back(
        {fmt::format("dwell[{}].{}", k + 1, of("half_band_max", "half_band_deg_max")),
         shown(half_band), shown(*most), half_band <= *most + kCheckTolerance * size});
  }
};

/// The dwells, with the output `reference` as the zero.
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
  const OutputWords words(problem);
  const double whole = turn.greatest - turn.least;
  const double swing = words.slides ? whole : std::min(kTurn, whole);
  const auto dwells = measure_dwells(problem, starts, reference, output, design);
  auto& quantities = design.metrics.quantities;
  quantities.push_back({words.of("half_band", "half_band_deg"), words.shown(design.error.max)});
  quantities.push_back({words.of("stroke", "swing_deg"), words.shown(swing)});
  if (problem.swing_min > 0) {
    words.check_least(words.of("stroke_min", "swing_deg_min"), swing, problem.swing_min, design);
  }
  for (std::size_t k = 0; k < dwells.size(); ++k) {
    words.check_band(problem.dwells[k], k, dwells[k].half_band(), design);
  }
  if (!problem.apart || dwells.size() < 2) return;
  const double apart = std::abs(dwells[1].middle() - dwells[0].middle());
  const char* name = words.of("apart", "apart_deg");
  quantities.push_back({name, words.shown(apart)});
  words.check_least(name, apart, *problem.apart, design);
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
  check_circuit(topology, mechanism, motion, design);
  mechanism.output = output_body(topology, problem.output);
  design.mechanism = std::move(mechanism);
  return design;
}

std::vector<double> output_over_turn(const DwellProblem& problem, const NamedMechanism& mechanism,
                                     int steps) {
  Output output(problem, mechanism);
  const OutputRange turn = output.over(0, kTurn, steps + 1, output.way_at(0));
  return turn.known() ? output.sampled() : std::vector<double>{};
}

double half_band(const DwellProblem& problem, const NamedMechanism& mechanism, const Dwell& dwell,
                 double start) {
  Output output(problem, mechanism);
  const Vec2d reference = output.way_at(start);
  return output.over(start, start + dwell.over, kWindowSamples, reference).half_band();
}

}  // namespace cognate::problems
