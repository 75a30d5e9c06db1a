#include "problems/cam/read_constraints.hpp"

#include <fmt/core.h>

#include "problems/cam/keys.hpp"
#include "problems/cam/read_follower.hpp"
#include "problems/cam/read_operation.hpp"

namespace cognate::problems::reading {
namespace {

using cam::FollowerType;

constexpr std::string_view kCurvature = "curvature_radius_min", kUndercut = "no_undercut",
                           kSeparation = "no_separation";

void read_undercut(TableReader& table, CamConstraints& constraints) {
  const auto radius = table.number(kCurvature, kRadiusOrNone);
  const bool no_undercut = table.boolean(kUndercut).value_or(true);
  if (!no_undercut && table.has(kCurvature)) {
    table.fault(kUndercut,
                "is false beside curvature_radius_min, which allows none; leave one of "
                "them out");
  }
  constraints.curvature_radius_min = radius ? radius : std::optional(0.0);
  if (!no_undercut) constraints.curvature_radius_min.reset();
}

// What only a flat face or only a roller has.
void refuse_where(TableReader& table, std::string_view key, bool meaningless, FollowerType follower,
                  std::string_view why) {
  if (!meaningless || !table.has(key)) return;
  table.fault(key, fmt::format("is given, but {} {}; remove it", in_words(follower), why));
}

void check_profile(TableReader& table, const CamProblem& problem) {
  const bool flat = is_flat(problem.follower);
  refuse_where(table, kConcave, flat, problem.follower, "touches no concave profile");
  refuse_where(table, kFace, !flat, problem.follower, "has no face");
  const auto& least = problem.constraints.profile_radius_min;
  const auto& greatest = problem.constraints.profile_radius_max;
  if (least && greatest && *least > *greatest) {
    table.fault(kLeast,
                fmt::format("is {}, more than profile_radius_max = {}; expected at most that",
                            *least, *greatest));
  }
}

void check_known(TableReader& table, std::string_view key, const CamProblem& problem, bool stress) {
  if (!table.has(key)) return;
  const std::string missing = missing_for_forces(problem, stress);
  if (missing.empty()) return;
  table.fault(key, fmt::format("is given without what it follows from; expected {}", missing));
}

// Of two contacts of constant breadth the angle of the first face is also that of the second, but
// neither the angle of rollers nor any curvature is.
bool hides_second_contact(const CamProblem& problem, bool stress) {
  return problem.second.closure == cam::Closure::constant_breadth &&
         (stress || has_opposite_roller(problem));
}

void check_contact(TableReader& table, std::string_view key, const CamProblem& problem,
                   bool stress) {
  if (!hides_second_contact(problem, stress)) return check_known(table, key, problem, stress);
  if (!table.has(key)) return;
  table.fault(key, fmt::format("is given, but with closure = \"constant-breadth\" the {} of the "
                               "second contact is not judged; remove it",
                               stress ? "curvature" : "pressure angle"));
}

void check_contact_objective(TableReader& target, std::string_view key, const CamProblem& problem,
                             bool stress) {
  const bool pair = problem.second.closure == cam::Closure::conjugate;
  if (!pair && !hides_second_contact(problem, stress)) {
    return check_known(target, key, problem, stress);
  }
  target.fault(key,
               fmt::format("is \"{}\", but with closure = \"{}\" {}; expected another objective",
                           to_string(problem.objective), to_string(problem.second.closure),
                           pair ? "only the first of both cams would be judged"
                                : "the second contact would not be judged"));
}

void read_forces(TableReader& table, const CamProblem& problem, CamConstraints& constraints) {
  check_contact(table, kForce, problem, false);
  check_known(table, kTorque, problem, false);
  const bool knife = is_knife(problem.follower);
  refuse_where(table, kStress, knife, problem.follower, "presses without limit");
  if (!knife) check_contact(table, kStress, problem, true);
  constraints.no_separation = table.boolean(kSeparation).value_or(true);
  if (!table.has(kSeparation)) return;
  if (problem.second.closure != cam::Closure::force) {
    table.fault(kSeparation, fmt::format("is given, but closure = \"{}\" lets nothing separate; "
                                         "remove it",
                                         to_string(problem.second.closure)));
    return;
  }
  check_known(table, kSeparation, problem, false);
}

// Of a face through its pivot, or one that slides, the cam pushes along the motion.
bool has_no_pressure_angle(const CamProblem& problem) {
  if (problem.follower == FollowerType::translating_flat) return true;
  return problem.follower == FollowerType::oscillating_flat &&
         problem.length(CamDimension::face_offset).given == 0.0;
}

}  // namespace

void read_cam_constraints(TableReader& constraints, CamProblem& problem) {
  read_keys(constraints, kPressureAngleKeys, problem.constraints);
  read_undercut(constraints, problem.constraints);
  read_keys(constraints, kProfileKeys, problem.constraints);
  check_profile(constraints, problem);
  read_forces(constraints, problem, problem.constraints);
}

void read_cam_objective(TableReader& target, CamProblem& problem) {
  constexpr std::string_view kObjective = "objective";
  const auto objective = target.choice<CamObjective>(kObjective);
  problem.objective = objective.value_or(problem.objective);
  switch (problem.objective) {
    case CamObjective::size:
      return;
    case CamObjective::pressure_angle:
      if (!has_no_pressure_angle(problem)) return;
      target.fault(kObjective, fmt::format("is \"pressure-angle\", which is 0 for {} for any "
                                           "cam; expected another objective",
                                           in_words(problem.follower)));
      return;
    case CamObjective::contact_force:
      return check_contact_objective(target, kObjective, problem, false);
    case CamObjective::torque:
      return check_known(target, kObjective, problem, false);
    case CamObjective::contact_stress:
      if (is_knife(problem.follower)) {
        target.fault(kObjective,
                     "is \"contact-stress\", which is infinite under a knife edge; "
                     "expected another objective, or a roller");
        return;
      }
      return check_contact_objective(target, kObjective, problem, true);
  }
}

}  // namespace cognate::problems::reading
