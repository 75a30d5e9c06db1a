#include "synthesis/exact/respacing.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/linkage/closure.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion_within.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"

namespace cognate::synthesis {
namespace {

constexpr int kSamples = 240;  // some 40 for each of six peaks
constexpr int kMostExchanges = 60;
constexpr int kMostHalvings = 12;
constexpr double kLevel = 1e-10;  // of the height: rounding of e is some 1e-16 of a radian
constexpr int kMostUnknowns = 6;

/// The error of one linkage over the range.
class ErrorCurve {
 public:
  ErrorCurve(const RespacingTask& task, const GeneratingFourBar& linkage)
      : task_(task), linkage_(linkage), closure_(linkage.links) {}

  /// Whether the crank can make the whole motion, between samples too.
  bool closes() const {
    const auto [from, to] = std::minmax(task_.from, task_.to);
    const double start = linkage_.input_start;
    return motion_within(crank_ranges(linkage_.links), {start + from, start + to}).has_value();
  }

  /// Generated minus desired output, in [−π, π]; not a number where the linkage does not close.
  double at(double input) const {
    const auto links = directions(input);
    const double off = std::atan2(links.rocker.y, links.rocker.x) - linkage_.output_start;
    return std::remainder(off - task_.output(input), kTurn);
  }

  /// Its derivatives by ln l₂, ln l₃, ln l₄ and the start angles that are free.
  Eigen::RowVectorXd slope(double input) const {
    const auto links = directions(input);
    const double angle = linkage_.input_start + input;
    const auto by = closure_gradient(linkage_.links, unit_vector(angle), links).rocker;
    Eigen::RowVectorXd row(task_.precision_points());
    row[0] = by.coupler * linkage_.links.coupler;
    row[1] = by.rocker * linkage_.links.rocker;
    row[2] = by.frame * linkage_.links.frame;
    int next = 3;
    if (task_.input_start_free) row[next++] = by.crank_angle;
    if (task_.output_start_free) row[next] = -1;
    return row;
  }

 private:
  LinkDirections<double> directions(double input) const {
    return closure_.at(crank_direction(linkage_.input_start + input), sign(linkage_.assembly));
  }

  const RespacingTask& task_;
  GeneratingFourBar linkage_;
  Closure<double> closure_;
};

struct Peak {
  double input = 0;
  double error = 0;
};

/// The highest point of |e| between two inputs about `top`, by golden section until the error no
/// longer decides the places apart.
Peak refined(const ErrorCurve& curve, double low, double high) {
  constexpr int kSteps = 44;  // 0.618⁴⁴ = 6e-10 of two steps: an error of 1e-20 in the height
  const auto found =
      golden_section([&](double x) { return -std::abs(curve.at(x)); }, low, high, kSteps);
  const double top = found.at_low < found.at_high ? found.low : found.high;
  return {top, curve.at(top)};
}

/// The highest point of each stretch in which the error keeps its sign, in the order of the inputs;
/// empty where the linkage does not close.
std::vector<Peak> peaks_of(const RespacingTask& task, const ErrorCurve& curve) {
  if (!curve.closes()) return {};
  std::array<Peak, kSamples + 1> samples;
  for (int i = 0; i <= kSamples; ++i) {
    const double input = i == kSamples ? task.to : task.from + (task.to - task.from) * i / kSamples;
    samples[i] = {input, curve.at(input)};
    if (!std::isfinite(samples[i].error)) return {};  // an end beyond a dead point by rounding
  }
  std::vector<int> tops;
  for (int i = 0; i <= kSamples; ++i) {
    const bool same = i > 0 && (samples[i].error < 0) == (samples[i - 1].error < 0);
    if (!same) {
      tops.push_back(i);
    } else if (std::abs(samples[i].error) > std::abs(samples[tops.back()].error)) {
      tops.back() = i;
    }
  }
  std::vector<Peak> peaks;
  for (const int top : tops) {
    const bool at_end = top == 0 || top == kSamples;
    const Peak inner =
        at_end ? samples[top] : refined(curve, samples[top - 1].input, samples[top + 1].input);
    peaks.push_back(std::abs(inner.error) > std::abs(samples[top].error) ? inner : samples[top]);
  }
  return peaks;
}

double greatest(const std::vector<Peak>& peaks) {
  double most = 0;
  for (const Peak& peak : peaks) most = std::max(most, std::abs(peak.error));
  return most;
}

/// `count` peaks in a row, of more than that those without the lower of the outermost ones.
void drop_outermost(std::vector<Peak>& peaks, std::size_t count) {
  while (peaks.size() > count) {
    const bool first = std::abs(peaks.front().error) < std::abs(peaks.back().error);
    peaks.erase(first ? peaks.begin() : peaks.end() - 1);
  }
}

double unevenness(const std::vector<Peak>& peaks) {
  double least = std::abs(peaks.front().error);
  for (const Peak& peak : peaks) least = std::min(least, std::abs(peak.error));
  const double most = greatest(peaks);
  return most > 0 ? (most - least) / most : 0;
}

/// Δp and E of the step; empty where the equations are singular.
std::optional<Eigen::VectorXd> level_step(const ErrorCurve& curve, const std::vector<Peak>& peaks) {
  using Matrix =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostUnknowns, kMostUnknowns>;
  const auto count = static_cast<Eigen::Index>(peaks.size());
  Matrix m(count, count);
  Eigen::VectorXd right(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Peak& peak = peaks[static_cast<std::size_t>(i)];
    m.row(i).head(count - 1) = curve.slope(peak.input);
    m(i, count - 1) = i % 2 == 0 ? -1 : 1;
    right[i] = -peak.error;
  }
  Eigen::VectorXd solution = Eigen::FullPivLU<Matrix>(m).solve(right);
  if (!solution.allFinite()) return std::nullopt;
  return solution;
}

GeneratingFourBar moved(const RespacingTask& task, const GeneratingFourBar& from,
                        const Eigen::VectorXd& step, double share) {
  GeneratingFourBar to = from;
  to.links.coupler *= std::exp(share * step[0]);
  to.links.rocker *= std::exp(share * step[1]);
  to.links.frame *= std::exp(share * step[2]);
  Eigen::Index next = 3;
  if (task.input_start_free) to.input_start += share * step[next++];
  if (task.output_start_free) to.output_start += share * step[next];
  return to;
}

/// Where the error changes its sign between neighbouring peaks, by bisection.
std::vector<double> zeros_between(const ErrorCurve& curve, const std::vector<Peak>& peaks) {
  std::vector<double> zeros;
  for (std::size_t i = 1; i < peaks.size(); ++i) {
    double low = peaks[i - 1].input, high = peaks[i].input;
    const bool negative = peaks[i - 1].error < 0;
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (low + high);
      ((curve.at(middle) < 0) == negative ? low : high) = middle;
    }
    zeros.push_back(0.5 * (low + high));
  }
  return zeros;
}

/// A linkage with its peaks.
struct Levelled {
  GeneratingFourBar linkage;
  std::vector<Peak> peaks;
};

/// The longest part of the step that lowers the greatest error, or at its end, where rounding hides
/// that, evens the peaks out; empty where there is none.
std::optional<Levelled> improved(const RespacingTask& task, const Levelled& from,
                                 const Eigen::VectorXd& step) {
  const double height = greatest(from.peaks);
  const std::size_t count = from.peaks.size();
  for (int halving = 0; halving < kMostHalvings; ++halving) {
    Levelled to{moved(task, from.linkage, step, std::ldexp(1.0, -halving)), {}};
    to.peaks = peaks_of(task, ErrorCurve(task, to.linkage));
    const double now = greatest(to.peaks);
    if (to.peaks.size() < count) continue;
    drop_outermost(to.peaks, count);
    const bool lower = now < height;
    const bool evener =
        now <= height * (1 + kLevel) && unevenness(to.peaks) < unevenness(from.peaks);
    if (lower || evener) return to;
  }
  return std::nullopt;
}

}  // namespace

Respacing equal_peaks(const RespacingTask& task, const GeneratingFourBar& start) {
  const std::size_t count = static_cast<std::size_t>(task.precision_points()) + 1;
  Respacing result{.linkage = start};
  Levelled now{start, peaks_of(task, ErrorCurve(task, start))};
  result.greatest = greatest(now.peaks);
  if (now.peaks.empty()) {
    result.outcome = RespacingOutcome::not_closing;
    return result;
  }
  if (now.peaks.size() < count) {
    result.outcome = RespacingOutcome::not_alternating;
    return result;
  }
  drop_outermost(now.peaks, count);
  while (result.exchanges < kMostExchanges) {
    const auto step = level_step(ErrorCurve(task, now.linkage), now.peaks);
    if (!step) break;
    auto next = improved(task, now, *step);
    if (!next) break;
    now = *std::move(next);
    ++result.exchanges;
  }
  result.linkage = now.linkage;
  result.greatest = greatest(now.peaks);
  result.unevenness = unevenness(now.peaks);
  if (result.unevenness <= kLevel) result.outcome = RespacingOutcome::level;
  for (const Peak& peak : now.peaks) result.peaks.push_back(peak.input);
  result.precision_inputs = zeros_between(ErrorCurve(task, now.linkage), now.peaks);
  return result;
}

}  // namespace cognate::synthesis
