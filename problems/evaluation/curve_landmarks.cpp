#include "problems/evaluation/curve_landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/coupler_curve/curve_features.hpp"
#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/output_travel.hpp"

namespace cognate::problems {
namespace {

constexpr int kCoupler = 2;

/// The drive's positions at which a motion takes a position of its linkage.
class LandmarkPassages {
 public:
  explicit LandmarkPassages(const AssemblyRanges& assembly_ranges)
      : assembly_ranges_(assembly_ranges) {}

  std::vector<double> of(const CrankPosition& position) const {
    const auto [low, high] = std::minmax(assembly_ranges_.start, assembly_ranges_.end);
    std::vector<double> drives;
    const double first = std::ceil((low - kSlack - position.crank_angle) / kTurn);
    for (double turn = first;; ++turn) {
      const double drive = position.crank_angle + turn * kTurn;
      if (!(drive <= high + kSlack)) return drives;
      if (takes(drive, position.side)) drives.push_back(std::clamp(drive, low, high));
    }
  }

 private:
  /// Positions at the ends of ranges are known to rounding, and belong to both assemblies there.
  static constexpr double kSlack = 1e-9;

  bool takes(double drive, Assembly side) const {
    return std::ranges::any_of(assembly_ranges_.runs, [&](const AssemblyRange& run) {
      if (drive < run.from - kSlack || drive > run.to + kSlack) return false;
      const bool dead = (run.from_dyad >= 0 && drive < run.from + kSlack) ||
                        (run.to_dyad >= 0 && drive > run.to - kSlack);
      return dead || sides_at(run, drive).front() == sign(side);
    });
  }

  const AssemblyRanges& assembly_ranges_;
};

class CurveLandmarks {
 public:
  CurveLandmarks(const AnalysisProblem& problem, const AssemblyRanges& assembly_ranges)
      : passages_(assembly_ranges),
        travel_(output_travel(problem.mechanism)),
        motion_(problem.mechanism.mechanism, assembly_ranges) {}

  void add(const CurveFeatures& features, const std::string& point) {
    for (const CurvePoint& cusp : features.cusps) add_all("cusp", point, cusp);
    for (const CurvePoint& place : features.inflections) add_all("inflection", point, place);
    for (const DoublePoint& place : features.double_points) add_double(point, place);
  }

  std::vector<Landmark> take() { return std::move(all_); }

 private:
  void add_all(const char* kind, const std::string& of, const CurvePoint& place) {
    for (const double drive : passages_.of(place.position)) {
      all_.push_back({kind, of, drive, output(drive)});
    }
  }

  /// Each passage names the nearest of the other kind; none is a double point alone.
  void add_double(const std::string& of, const DoublePoint& place) {
    const auto first = passages_.of(place.first.position);
    const auto second = passages_.of(place.second.position);
    add_passages(of, first, second);
    add_passages(of, second, first);
  }

  void add_passages(const std::string& of, const std::vector<double>& here,
                    const std::vector<double>& there) {
    if (there.empty()) return;
    for (const double drive : here) {
      const auto distance = [&](double other) { return std::abs(other - drive); };
      const double again = *std::ranges::min_element(there, {}, distance);
      all_.push_back({"double point", of, drive, output(drive), again});
    }
  }

  double output(double drive) {
    return motion_.move_to(drive) ? travelled<0>(travel_, motion_.bodies())
                                  : std::numeric_limits<double>::quiet_NaN();
  }

  LandmarkPassages passages_;
  Travel travel_;
  FollowedMotion<0> motion_;
  std::vector<Landmark> all_;
};

bool is_reported(const AnalysisOutput& output, int point) {
  return output.points.empty() || std::ranges::find(output.points, point) != output.points.end();
}

}  // namespace

std::vector<Landmark> curve_landmarks(const AnalysisProblem& problem,
                                      const AssemblyRanges& assembly_ranges,
                                      const Deadline& deadline) {
  const auto& mechanism = problem.mechanism;
  if (!problem.output.curvature || !mechanism.four_bar() || assembly_ranges.runs.empty()) return {};
  CurveLandmarks landmarks(problem, assembly_ranges);
  for (std::size_t i = 0; i < mechanism.points.size() && !deadline.reached(); ++i) {
    const auto& [name, at] = mechanism.points[i];
    if (at.body != kCoupler || !is_reported(problem.output, static_cast<int>(i))) continue;
    FourBar tracing = *mechanism.four_bar();
    tracing.coupler_point = at.at;
    if (const auto features = curve_features(tracing)) landmarks.add(*features, name);
  }
  return landmarks.take();
}

}  // namespace cognate::problems
