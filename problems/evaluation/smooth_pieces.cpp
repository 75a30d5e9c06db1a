#include "problems/evaluation/smooth_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <variant>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/load_breaks.hpp"

namespace cognate::problems {
namespace {

/// Parts of the drive's scale: places closer than this are one.
constexpr double kSamePlace = 1e-12;

/// Where loads begin or cease anywhere on the assembly ranges. What one turn has may come
/// back in the next.
std::vector<double> all_breaks(const AnalysisProblem& problem,
                               const AssemblyRanges& assembly_ranges,
                               std::span<const Stroke> strokes) {
  const auto& mechanism = problem.mechanism.mechanism;
  std::vector<double> breaks;
  for (std::size_t i = 0; i < problem.loads.size(); ++i) {
    const Stroke stroke = i < strokes.size() ? strokes[i] : Stroke{};
    std::ranges::move(load_breaks(mechanism, assembly_ranges, problem.loads[i], stroke),
                      std::back_inserter(breaks));
  }
  if (driven_by_length(mechanism.drive)) return breaks;
  const auto [low, high] = std::minmax(assembly_ranges.start, assembly_ranges.end);
  std::vector<double> repeated;
  for (const double place : breaks) {
    const double first = place - kTurn * std::floor((place - low) / kTurn);
    for (double again = first; again <= high; again += kTurn) repeated.push_back(again);
  }
  repeated.insert(repeated.end(), breaks.begin(), breaks.end());
  return repeated;
}

/// Cuts one run.
class RunCutter {
 public:
  RunCutter(const AssemblyRange& run, double scale, std::vector<SmoothPiece>& pieces)
      : run_(run), scale_(scale), pieces_(pieces) {}

  void cut(const std::vector<double>& breaks) {
    std::vector<double> places{run_.from, run_.to};
    const auto inside = [&](double x) { return x > run_.from && x < run_.to; };
    std::ranges::copy_if(breaks, std::back_inserter(places), inside);
    for (const Change& change : run_.changes) places.push_back(change.drive);
    const double quarters = std::ceil((run_.to - run_.from) / (scale_ * kTurn / 4));
    for (double k = 1; k < quarters; ++k) {
      places.push_back(run_.from + (run_.to - run_.from) * k / quarters);
    }
    std::ranges::sort(places);
    double from = places.front();
    for (const double to : places) {
      if (to - from <= kSamePlace * scale_) continue;
      pieces_.push_back({from, to, end_at(from), end_at(to), {}});
      from = to;
    }
  }

 private:
  PieceEnd end_at(double place) const {
    const auto is_here = [&](double other) {
      return std::abs(place - other) <= kSamePlace * scale_;
    };
    if (run_.from_dyad >= 0 && is_here(run_.from)) return PieceEnd::dead;
    if (run_.to_dyad >= 0 && is_here(run_.to)) return PieceEnd::dead;
    const bool changes = std::ranges::any_of(run_.changes, is_here, &Change::drive);
    return changes ? PieceEnd::change : PieceEnd::smooth;
  }

  const AssemblyRange& run_;
  double scale_;
  std::vector<SmoothPiece>& pieces_;
};

}  // namespace

std::vector<SmoothPiece> smooth_pieces(const AnalysisProblem& problem,
                                       const AssemblyRanges& assembly_ranges,
                                       std::span<const Stroke> strokes) {
  std::vector<SmoothPiece> pieces;
  const std::vector<double> breaks = all_breaks(problem, assembly_ranges, strokes);
  for (const AssemblyRange& run : assembly_ranges.runs)
    RunCutter(run, assembly_ranges.scale, pieces).cut(breaks);
  ActiveLoads active(problem.mechanism.mechanism, problem.loads, strokes);
  FollowedMotion<1> motion(problem.mechanism.mechanism, assembly_ranges);
  for (SmoothPiece& piece : pieces) {
    const double middle = std::midpoint(piece.from, piece.to);
    if (!motion.move_to(middle)) continue;
    const auto loads = active.at<1>(middle, problem.drive.rate.speed, motion.bodies());
    piece.loads.assign(loads.begin(), loads.end());
  }
  return pieces;
}

}  // namespace cognate::problems
