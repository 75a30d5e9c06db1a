#include "problems/evaluation/load_breaks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/output_limits.hpp"
#include "analysis/mechanism/travel.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"
#include "problems/evaluation/whole_motion.hpp"

namespace cognate::problems {
namespace {

/// Where the travel passes the value `target` in `run`. Between `limits` it goes one way.
class Passages {
 public:
  Passages(const Mechanism<double>& mechanism, const AssemblyRanges& assembly_ranges,
           const Travel& travel)
      : motion_(mechanism, assembly_ranges), travel_(travel) {}

  void find(const AssemblyRange& run, const std::vector<OutputValue>& limits, double target,
            std::vector<double>& found) {
    std::vector<double> places = crowded(run.from, run.to, motion_.assembly_ranges().cells(run));
    for (const OutputValue& limit : limits) places.push_back(limit.drive);
    std::ranges::sort(places);
    const auto f = [&](double drive) { return beyond(drive, target); };
    for (std::size_t i = 1; i < places.size(); ++i) {
      const double a = places[i - 1], b = places[i];
      const double at_a = f(a), at_b = f(b);
      if (!(a < b && at_a * at_b < 0) || std::abs(at_a - at_b) > kTurn / 2) continue;
      found.push_back(better_end(f, bracket_zero(f, a, at_a, b, at_b)));
    }
  }

 private:
  /// How far the travel is beyond `target`, of an angle by the shorter way.
  double beyond(double drive, double target) {
    if (!motion_.move_to(drive)) return std::nan("");
    const double difference = travelled<1>(travel_, motion_.bodies()) - target;
    return travel_.slides ? difference : std::remainder(difference, kTurn);
  }

  FollowedMotion<1> motion_;
  Travel travel_;
};

/// The ends of an interval of the drive, in every turn of a drive that turns.
void add_interval_ends(const AssemblyRanges& assembly_ranges, bool turns,
                       const std::pair<double, double>& interval, std::vector<double>& breaks) {
  const auto [low, high] = std::minmax(assembly_ranges.start, assembly_ranges.end);
  for (double end : {interval.first, interval.second}) {
    if (!turns) {
      breaks.push_back(end);
      continue;
    }
    for (end = low + in_one_turn(end - low); end < high; end += kTurn) breaks.push_back(end);
  }
}

}  // namespace

std::vector<Stroke> load_strokes(const AnalysisProblem& problem, const Deadline& deadline) {
  const auto needs = [](const LoadRule& rule) { return rule.within_stroke.has_value(); };
  if (std::ranges::none_of(problem.loads, needs)) return {};
  const auto& mechanism = problem.mechanism.mechanism;
  const AssemblyRanges assembly_ranges = whole_motion(problem, deadline);
  const auto all = travels(mechanism);
  std::vector<Stroke> strokes(problem.loads.size());
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (!needs(problem.loads[i])) continue;
    const auto body = static_cast<std::size_t>(problem.loads[i].at.body);
    const auto range = output_range(mechanism, assembly_ranges, all[body]);
    if (range) strokes[i] = {range->least.value, range->greatest.value};
  }
  return strokes;
}

std::vector<double> load_breaks(const Mechanism<double>& mechanism,
                                const AssemblyRanges& assembly_ranges, const LoadRule& rule,
                                const Stroke& stroke) {
  std::vector<double> breaks;
  const bool turns = !driven_by_length(mechanism.drive);
  if (rule.between) add_interval_ends(assembly_ranges, turns, *rule.between, breaks);
  if (rule.sense == LoadSense::always && !rule.within_stroke) return breaks;
  const Travel travel = travels(mechanism)[static_cast<std::size_t>(rule.at.body)];
  const auto range = output_range(mechanism, assembly_ranges, travel);
  if (!range) return breaks;
  for (const OutputValue& limit : range->limits) breaks.push_back(limit.drive);
  if (!rule.within_stroke) return breaks;
  Passages passages(mechanism, assembly_ranges, travel);
  for (const double part : {rule.within_stroke->first, rule.within_stroke->second}) {
    const double target = stroke.least + part * (stroke.greatest - stroke.least);
    for (const AssemblyRange& run : assembly_ranges.runs)
      passages.find(run, range->limits, target, breaks);
  }
  return breaks;
}

}  // namespace cognate::problems
