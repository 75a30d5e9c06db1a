#include "problems/straight_line/front.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "problems/basics/degrees.hpp"
#include "problems/straight_line/model.hpp"

namespace cognate::problems {
namespace {

constexpr double kRatio = 0.8;
constexpr int kMostPoints = 12;
/// Afresh at every second bound, and from the points beside each.
constexpr SegmentEffort kFresh{30, 3, 0}, kOnward{0, 1, 0};
/// The front ends where δ/L exceeds this.
constexpr double kBentFront = 0.02;
constexpr double kFeasible = 1e-7;
constexpr double kDescended = 0.6;  // share of the work, for progress, when all points are there

/// Points of the front by falling bound on the size.
class Front {
 public:
  Front(const StraightLineProblem& problem, const Run& run, const Deadline& deadline, Work& work)
      : problem_(problem), run_(run), deadline_(deadline), work_(work) {
    problem_.solve.designs = 1;
  }

  void descend() {
    double bound = size_limit(problem_);
    for (int i = 0; i < kMostPoints && !deadline_.reached(); ++i, bound *= kRatio) {
      const SegmentEffort& effort = i % 2 == 0 ? kFresh : kOnward;
      auto best = solve(bound, neighbours(points_.size()), effort);
      if (!best || best->objective > kBentFront) break;
      points_.push_back({bound, *best});
      if (run_.progress) run_.progress(kDescended * (i + 1) / kMostPoints, best->objective);
    }
  }

  /// Each again from the points beside it; what keeps to a bound keeps to every looser one.
  void settle() {
    for (std::size_t i = points_.size(); i-- > 0;) {
      if (deadline_.reached()) return;
      if (run_.progress) {
        const double done = 1 - double(i + 1) / double(points_.size());
        run_.progress(kDescended + (1 - kDescended) * done, points_[i].found.objective);
      }
      auto best = solve(points_[i].bound, neighbours(i), kOnward);
      if (best && best->objective < points_[i].found.objective) points_[i].found = *best;
    }
  }

  SegmentFront take(int designs) && {
    SegmentFront front;
    front.table.name = "straight-line front";
    front.table.columns = {{"size_over_length", {}},
                           {"deviation_relative", {}},
                           {"log10_deviation_relative", {}},
                           {"straight_length_over_size", {}},
                           {"crank_range_deg", {}}};
    std::erase_if(points_, [&](const Point& p) { return is_dominated(p); });
    const auto count = static_cast<double>(points_.size());
    const double step = std::max(1.0, count / designs);
    double next = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const SegmentDesign& found = points_[i].found;
      const double size = largest_dimension(found.segment) / found.segment.length;
      const double values[] = {size, found.objective, std::log10(std::max(found.objective, 1e-16)),
                               1 / size, degrees(2 * found.segment.reach)};
      for (std::size_t k = 0; k < 5; ++k) front.table.columns[k].values.push_back(values[k]);
      if (double(i) + 0.5 < next) continue;
      front.points.push_back(found);
      next += step;
    }
    return front;
  }

 private:
  struct Point {
    double bound;
    SegmentDesign found;
  };

  std::vector<LinkageSegment> neighbours(std::size_t i) const {
    std::vector<LinkageSegment> known;
    for (const std::size_t k : {i - 1, i, i + 1}) {
      if (k < points_.size()) known.push_back(points_[k].found.segment);
    }
    return known;
  }

  std::optional<SegmentDesign> solve(double bound, const std::vector<LinkageSegment>& known,
                                     const SegmentEffort& effort) {
    StraightLineProblem bounded = problem_;
    bounded.segment.size_over_length_max = bound;
    Run quiet = run_;
    quiet.progress = {};
    auto found = search_segments(bounded, known, effort, quiet, deadline_, work_).found;
    if (found.empty() || found.front().violation > kFeasible) return std::nullopt;
    return found.front();
  }

  bool is_dominated(const Point& point) const {
    return std::ranges::any_of(points_, [&](const Point& other) {
      return other.bound < point.bound && other.found.objective <= point.found.objective;
    });
  }

  StraightLineProblem problem_;
  const Run& run_;
  const Deadline& deadline_;
  Work& work_;
  std::vector<Point> points_;
};

}  // namespace

SegmentFront segment_front(const StraightLineProblem& problem, const Run& run,
                           const Deadline& deadline, Work& work) {
  Front front(problem, run, deadline, work);
  front.descend();
  front.settle();
  return std::move(front).take(problem.solve.designs);
}

}  // namespace cognate::problems
