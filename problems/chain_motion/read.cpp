#include "problems/chain/front/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/read_design.hpp"
#include "problems/chain/read_made.hpp"
#include "problems/chain/read_target.hpp"
#include "problems/chain_motion/problem.hpp"
#include "problems/guidance/read_poses.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems {
namespace reading {
namespace {

constexpr std::string_view kType = "type";
constexpr std::string_view kParts[] = {"pivot", "crank", "dyad", "point"};
constexpr std::size_t kLeastPoses = 3;
constexpr double kOnePlace = 1e-12;  // of the farthest place: ways up to this are rounding

std::vector<std::string_view> motion_types() {
  std::vector<std::string_view> words;
  for (const TopologyWord& topology : topology_words()) words.push_back(topology.word);
  words.push_back(kChainWord);
  return words;
}

void fault_type(TableReader& document, TableReader& mechanism) {
  fault_chain_type(document, mechanism, motion_types());
  if (mechanism.contains(kType)) return;
  mechanism.fault(kType,
                  "is missing, but the file has parts of a chain; expected \"chain\" where they "
                  "define it, or the name of the topology that they belong to");
}

/// A turn more is the same pose, whose angle in radians may be another in its last digit.
bool is_same(const synthesis::Pose& a, const synthesis::Pose& b) {
  constexpr double kRounding = 1e-11;
  return norm(a.at - b.at) == 0 && std::abs(std::remainder(a.angle - b.angle, kTurn)) < kRounding;
}

std::string_view key_of(const GivenPoses& given) {
  return given.segments.empty() ? "poses" : "segments";
}

void check_poses(TableReader& target, const GivenPoses& given) {
  const std::string_view key = key_of(given);
  const auto& poses = given.poses;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (!is_same(poses[i - 1], poses[i])) continue;
    target.faults().add(target.where(key, i),
                        fmt::format("pose {} of target.{} repeats pose {}; neighbouring poses must "
                                    "differ (only the last may repeat the first)",
                                    i + 1, key, i));
  }
  double farthest = 0, way = 0;
  for (const synthesis::Pose& pose : poses) {
    farthest = std::max(farthest, norm(pose.at));
    way = std::max(way, norm(pose.at - poses.front().at));
  }
  if (poses.empty() || way > kOnePlace * farthest) return;
  target.fault(key,
               "have the body's origin at one place: a link that turns about a fixed pivot there "
               "meets them; expected places that differ, or another point of the body as its "
               "origin");
}

/// Returns whether the last pose was the first again and is left out.
bool read_body(TableReader& target, ChainMotionProblem& problem) {
  const auto closed = target.boolean("closed");
  GivenPoses given = read_poses(target, kLeastPoses);
  check_poses(target, given);
  problem.poses = std::move(given.poses);
  if (problem.poses.empty()) return false;
  const bool repeats = is_same(problem.poses.front(), problem.poses.back());
  problem.closed = closed.value_or(repeats);
  const bool dropped = problem.closed && repeats;
  if (dropped) problem.poses.pop_back();
  if (problem.poses.size() < kLeastPoses) {
    target.fault(key_of(given), "are two different poses; expected at least 3");
  }
  return dropped;
}

void read_motion_target(TableReader& target, ChainMotionProblem& problem) {
  const bool dropped = read_body(target, problem);
  problem.crank_angles =
      read_chain_timing(target, {problem.poses.size(), problem.closed, dropped, "pose", "motion"});
  problem.angle_weight = target.number("angle_weight", kLinkLength);
  if (!target.contains("method")) return;
  target.know({"method"});
  target.fault("method",
               "is for motions without mechanism.type; remove it: chains come as near to all poses "
               "as they can (least squares)");
}

/// The body's origin has to be on a link, so that the link's angle is the body's.
void check_origin(TableReader& target, const ChainMotionProblem& problem) {
  for (const Topology& topology : problem.topologies) {
    const TopologyLine& origin = topology.lines[static_cast<std::size_t>(topology.trace)];
    if (origin.line.type == synthesis::LineType::attached) continue;
    return target.fault(
        "point", fmt::format("\"{}\" is a joint of two links, which does not say which of them "
                             "carries the body; expected a [[point]] on a link",
                             origin.name));
  }
}

}  // namespace
}  // namespace reading

bool KindTraits<ChainMotionProblem>::takes(reading::TableReader& document) {
  const bool has_type =
      document.has_table("mechanism") && document.table("mechanism").contains(reading::kType);
  return has_type || std::ranges::any_of(reading::kParts, [&](std::string_view part) {
           return document.contains(part);
         });
}

ChainMotionProblem KindTraits<ChainMotionProblem>::read(reading::TableReader& document,
                                                        const std::filesystem::path& /*folder*/) {
  using namespace reading;
  ChainMotionProblem problem;
  LinkageTables tables(document);
  const bool has_type = tables.mechanism.has_text(kType);
  problem.mechanism = has_type ? *tables.mechanism.text(kType) : "";
  if (problem.mechanism != kChainWord && topologies(problem.mechanism).empty()) {
    fault_type(document, tables.mechanism);
    return problem;
  }
  read_motion_target(tables.target, problem);
  const Wanted wanted = read_traced(tables.target, problem.mechanism, "P");
  problem.topologies = read_topologies(document, tables, topologies(problem.mechanism), wanted);
  check_origin(tables.target, problem);
  problem.constraints = read_chain_constraints(tables.constraints);
  read_chain_solve(tables.solve, problem.solve);
  problem.against =
      read_against(tables.solve, {.mechanism = problem.mechanism, .topologies = problem.topologies},
                   problem.solve);
  read_made(document, tables, "length", problem.constraints.over, problem);
  for (TableReader* table :
       {&tables.target, &tables.mechanism, &tables.constraints, &tables.solve}) {
    table->finish();
  }
  problem.warnings = read_warnings(document);
  return problem;
}

}  // namespace cognate::problems
