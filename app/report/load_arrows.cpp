#include "app/report/load_arrows.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "analysis/mechanism/followed_motion.hpp"
#include "app/report/drawn_number.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "problems/evaluation/drive_rows.hpp"
#include "problems/evaluation/load_breaks.hpp"
#include "problems/evaluation/whole_motion.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::AnalysisProblem;
using problems::LoadRule;

ordered_json drawn_vector(const Vec2d& v) {
  return ordered_json::array({drawn(v.x), drawn(v.y)});
}

ordered_json arrow(const char* kind, const Attached<double>& at) {
  return {{"kind", kind}, {"body", at.body}, {"at", drawn_vector(at.at)}};
}

bool always_acts(const LoadRule& rule) {
  return rule.sense == problems::LoadSense::always && !rule.between && !rule.within_stroke;
}

/// For each load of the file whether it acts in each row; null of those that always do.
std::vector<ordered_json> acting_rows(const AnalysisProblem& problem,
                                      std::span<const std::size_t> rows) {
  std::vector<ordered_json> acts(problem.loads.size());
  if (std::ranges::all_of(problem.loads, always_acts)) return acts;
  const auto& mechanism = problem.mechanism.mechanism;
  const problems::Deadline deadline(problems::Run{});
  const auto strokes = load_strokes(problem, deadline);
  FollowedMotion<1> motion(mechanism,
                           follow_until(problem, problem.drive.start, problem.drive.end, deadline));
  std::vector<problems::ActiveLoads> each;
  for (std::size_t i = 0; i < acts.size(); ++i) {
    const std::span stroke = std::span(strokes).subspan(std::min(i, strokes.size()));
    each.emplace_back(mechanism, std::span(problem.loads).subspan(i, 1), stroke);
    if (!always_acts(problem.loads[i])) acts[i] = ordered_json::array();
  }
  for (const std::size_t row : rows) {
    const double drive = drive_at(problem.drive, static_cast<int>(row));
    const bool closes = motion.move_to(drive);
    for (std::size_t i = 0; i < acts.size(); ++i) {
      if (acts[i].is_null()) continue;
      acts[i].push_back(closes &&
                        !each[i].at<1>(drive, problem.drive.rate.speed, motion.bodies()).empty());
    }
  }
  return acts;
}

void add_loads(const AnalysisProblem& problem, std::span<const std::size_t> rows,
               ordered_json& list) {
  const auto acts = acting_rows(problem, rows);
  for (std::size_t i = 0; i < acts.size(); ++i) {
    const LoadRule& rule = problem.loads[i];
    ordered_json entry = arrow("load", rule.at);
    entry["force"] = drawn_vector(rule.force);
    entry["torque"] = drawn(rule.torque);
    entry["acts"] = acts[i];
    list.push_back(entry);
  }
}

void add_weights(const AnalysisProblem& problem, ordered_json& list) {
  const Vec2d gravity = metres(problem.length_unit) * problem.gravity;
  for (std::size_t body = 1; body < problem.inertias.size(); ++body) {
    const Inertia& inertia = problem.inertias[body];
    const Vec2d weight = inertia.mass * gravity;
    if (!(norm(weight) > 0)) continue;
    ordered_json entry = arrow("weight", {static_cast<int>(body), inertia.centre});
    entry["force"] = drawn_vector(weight);
    entry["torque"] = 0;
    entry["acts"] = nullptr;
    list.push_back(entry);
  }
}

void add_drive(const AnalysisProblem& problem, const problems::AnalysisResult& result,
               ordered_json& list) {
  const auto column = std::ranges::find(result.columns, "torque", &problems::Column::quantity);
  if (column == result.columns.end()) return;
  ordered_json entry = arrow("drive", {1, {}});
  entry["column"] = column - result.columns.begin();
  const auto& drive = problem.mechanism.mechanism.drive;
  const auto* slider = std::get_if<DrivingSlider<double>>(&drive);
  entry["direction"] = slider ? drawn_vector(slider->guide.direction) : ordered_json(nullptr);
  if (std::holds_alternative<DrivingRod<double>>(drive)) {
    entry["direction"] = drawn_vector({1, 0});
    entry["turns"] = true;
  }
  list.push_back(entry);
}

}  // namespace

ordered_json load_arrows(const AnalysisProblem& problem, const problems::AnalysisResult& result,
                         std::span<const std::size_t> rows) {
  ordered_json list = ordered_json::array();
  if (!problem.output.torque && !problem.output.reactions) return list;
  add_loads(problem, rows, list);
  add_weights(problem, list);
  add_drive(problem, result, list);
  return list;
}

}  // namespace cognate::app
