#include "problems/path/read_exact.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/path/exact/designs.hpp"
#include "synthesis/exact/nine_point/constrained_path.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kPoints = "points";
constexpr std::string_view kPoses = "poses";
// Nine points, and five poses; more have a message of their own.
constexpr Count kPointCount{.min = 1, .of = "points"};
constexpr Count kPoseCount{.min = 1, .of = "poses"};
constexpr int kEquations = 8;
/// Angles that whole turns apart leave no nearer to each other are different.
constexpr double kSameAngle = 1e-13;

void read_poses(TableReader& target, PathProblem& problem) {
  if (!target.has(kPoses)) return;
  const auto rows = target.each_row(kPoses, 3, kNumber, "[x, y, angle_deg]", kPoseCount);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i] || kAngle.accepts((*rows[i])[2])) continue;
    target.faults().add(target.where(kPoses, i),
                        fmt::format("pose {} of target.poses has the angle {}; expected {}", i + 1,
                                    (*rows[i])[2], kAngle.allowed));
  }
  for (const auto& row : all_or_none(rows).value_or(std::vector<std::vector<double>>{})) {
    problem.points.push_back({row[0], row[1]});
    problem.pose_angles.push_back(radians(row[2]));
  }
}

void read_exact_points(TableReader& target, PathProblem& problem) {
  if (!target.has(kPoints) && target.has(kPoses)) return;
  if (!target.has(kPoints)) {
    target.fault(kPoints, "is missing; expected an array of 2 to 9 points [x, y]");
    return;
  }
  const auto points = target.each_two(kPoints, kNumber, "[x, y]", kPointCount);
  for (const Two& point : all_or_none(points).value_or(std::vector<Two>{})) {
    problem.points.push_back({point[0], point[1]});
  }
}

// Two poses at one place may differ in their angles.
bool are_alike(const PathProblem& problem, std::size_t i, std::size_t k) {
  if (!(problem.points[i] == problem.points[k])) return false;
  const bool two_poses = k < problem.pose_angles.size();
  if (!two_poses) return true;
  const double turn = problem.pose_angles[i] - problem.pose_angles[k];
  return std::abs(std::remainder(turn, kTurn)) <= kSameAngle;
}

void check_distinct(TableReader& target, const PathProblem& problem) {
  const std::size_t poses = problem.pose_angles.size();
  for (std::size_t k = 1; k < problem.points.size(); ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      if (!are_alike(problem, i, k)) continue;
      const bool is_pose = k < poses;
      const auto name = [&](std::size_t at) {
        return at < poses ? fmt::format("pose {}", at + 1)
                          : fmt::format("point {}", at + 1 - poses);
      };
      target.faults().add(
          is_pose ? target.where(kPoses, k) : target.where(kPoints, k - poses),
          fmt::format("{} is where {} is: together they are one condition; with method = \"exact\" "
                      "all positions must differ (a closed path needs no repeated point)",
                      name(k), name(i)));
      break;
    }
  }
}

void check_unused(TableReader& target, TableReader& solve, const PathProblem& problem) {
  if (problem.timing != Timing::free) {
    target.fault("timing",
                 fmt::format("is \"{}\" with method = \"exact\", which meets the points at crank "
                             "angles of its own; remove it, or remove method for least squares",
                             to_string(problem.timing)));
  }
  if (target.has("weights")) {
    target.fault("weights",
                 "are given with method = \"exact\", which meets every point; remove "
                 "them, or remove method for least squares");
  }
  const auto other = [&](std::string_view key) {
    solve.fault(key,
                "is given with method = \"exact\", which has a solver of its own; remove it, or "
                "remove method for least squares");
  };
  if (problem.solve.solver != synthesis::Solver::automatic) other("solver");
  if (problem.solve.tolerance) other("tolerance");
}

// The sense is judged from one listed position to the next.
void check_sense_has_an_order(TableReader& target, const PathProblem& problem) {
  if (problem.crank_sense == CrankSense::either || problem.order != PointOrder::any) return;
  target.fault("crank_sense",
               "is given for positions in any order (order = \"any\", as poses and points together "
               "have it), for which the sense is not defined; remove it, or add order = \"cyclic\" "
               "and list the positions as they follow one another");
}

void check_closes(TableReader& mechanism, const Given& given) {
  if (!given.crank || !given.coupler || !given.rocker || !given.frame) return;
  const std::array all{*given.crank, *given.coupler, *given.rocker, *given.frame};
  const double longest = *std::ranges::max_element(all);
  const double others = all[0] + all[1] + all[2] + all[3] - longest;
  if (longest <= others) return;
  constexpr std::array<std::string_view, 4> kKeys{"crank", "coupler", "rocker", "frame"};
  const auto which = std::size_t(std::ranges::max_element(all) - all.begin());
  mechanism.fault(kKeys[which],
                  fmt::format("is {}, longer than the other three links together ({}), so that "
                              "they never close; at most their sum is allowed",
                              longest, others));
}

/// A given part, its key in the file and how to leave it out.
struct FixedPart {
  std::string_view key;
  bool (*take)(synthesis::FixedParts&);  ///< false where it was not given
};

template <auto Member>
bool take_out(synthesis::FixedParts& parts) {
  const bool was_given = (parts.*Member).has_value();
  (parts.*Member).reset();
  return was_given;
}

constexpr std::array<FixedPart, 8> kParts = {{
    {"coupler_point", take_out<&synthesis::FixedParts::coupler_point>},
    {"crank", take_out<&synthesis::FixedParts::crank>},
    {"rocker", take_out<&synthesis::FixedParts::rocker>},
    {"coupler", take_out<&synthesis::FixedParts::coupler>},
    {"frame", take_out<&synthesis::FixedParts::frame>},
    {"frame_angle_deg", take_out<&synthesis::FixedParts::frame_angle>},
    {"pivot_a", take_out<&synthesis::FixedParts::pivot_a>},
    {"pivot_d", take_out<&synthesis::FixedParts::pivot_d>},
}};

// Eight conditions or fewer can still be more than one dyad has unknowns.
void check_each_dyad(TableReader& mechanism, const PathProblem& problem) {
  const auto kind = synthesis::class_of(positions_of(problem));
  const synthesis::FixedParts parts = given_parts(problem.given);
  if (are_independent(kind, parts)) return;
  std::string_view key = kParts.back().key;
  for (const FixedPart& part : kParts) {
    synthesis::FixedParts without = parts;
    if (!part.take(without)) continue;
    key = part.key;
    if (are_independent(kind, without)) break;
  }
  mechanism.fault(
      key,
      fmt::format("is one condition too many for a dyad (crank and pivot A, or rocker and pivot D) "
                  "with {} poses: each has four dimensions, of which every pose beside the first "
                  "takes one, its pivot two and its length one; remove it, or give fewer poses",
                  std::max<std::size_t>(1, problem.pose_angles.size())));
}

}  // namespace

void read_exact_positions(TableReader& target, PathProblem& problem) {
  read_poses(target, problem);
  read_exact_points(target, problem);
  if (problem.points.size() == 1) {
    target.fault(
        target.has(kPoses) ? kPoses : kPoints,
        "is one position, through which every coupler can be put; expected 2 to 9 points, or poses "
        "and points together");
  }
  check_distinct(target, problem);
}

int default_exact_designs(const PathProblem& problem) {
  return equation_count(problem) >= kEquations ? kMostExactDesigns : Solve{}.designs;
}

void check_exact_path(TableReader& target, TableReader& mechanism, TableReader& solve,
                      const PathProblem& problem) {
  check_unused(target, solve, problem);
  if (problem.given.coupler_point && !problem.given.coupler) {
    mechanism.fault("coupler_point",
                    "is given without coupler; with method = \"exact\" the coupler point is known "
                    "in the coupler's frame only along with the coupler's length");
  }
  check_sense_has_an_order(target, problem);
  check_closes(mechanism, problem.given);
  const int count = equation_count(problem);
  if (problem.points.empty()) return;
  if (count <= kEquations) {
    check_each_dyad(mechanism, problem);
    return;
  }
  const int parts = synthesis::condition_count(given_parts(problem.given));
  target.fault(
      target.has(kPoints) ? kPoints : kPoses,
      fmt::format("are too many for exact synthesis: {} positions, {} of them with an angle, and "
                  "{} given dimensions of the mechanism make {} conditions beside the first "
                  "position; 8 are the most (nine points, or five poses), least squares takes more",
                  problem.points.size(), problem.pose_angles.size(), parts, count));
}

}  // namespace cognate::problems::reading
