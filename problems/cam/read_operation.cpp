#include "problems/cam/read_operation.hpp"

#include <fmt/core.h>

#include "problems/cam/rules.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kMassKey = "mass", kInertia = "inertia", kSpring = "spring_rate",
                           kPreload = "preload", kLoad = "load", kSpeed = "speed";

bool read_inertia(TableReader& follower, CamProblem& problem) {
  const bool swings = is_oscillating(problem.follower);
  const std::string_view key = swings ? kInertia : kMassKey;
  const std::string_view other = swings ? kMassKey : kInertia;
  if (follower.contains(other)) {
    follower.know({other});
    follower.fault(other, swings
                              ? "is given, but the follower oscillates; expected inertia about its "
                                "pivot"
                              : "is given, but the follower translates; expected mass");
  }
  problem.operation.inertia = follower.number(key, kMass).value_or(0);
  return follower.has(key);
}

// Whether any of the keys is there.
bool read_masses_and_forces(TableReader& follower, CamProblem& problem) {
  cam::Operation& operation = problem.operation;
  bool any = read_inertia(follower, problem);
  operation.spring_rate = follower.number(kSpring, kMass).value_or(0);
  operation.load = follower.number(kLoad, kQuantity).value_or(0);
  problem.preload = follower.number(kPreload, kMass);
  // A form closed follower needs none to stay in contact.
  if (problem.second.closure != cam::Closure::force && !problem.preload) problem.preload = 0;
  operation.preload = problem.preload.value_or(0);
  for (const std::string_view key : {kSpring, kLoad, kPreload}) any = follower.has(key) || any;
  return any;
}

void require(TableReader& contact, std::string_view key, std::string_view wanted) {
  if (!contact.has(key)) contact.fault(key, fmt::format("is missing; expected {}", wanted));
}

void read_contact(TableReader& contact, CamProblem& problem) {
  constexpr std::string_view kWidth = "width", kElasticity = "elasticity", kRatios = "poisson";
  require(contact, kWidth, "the width of the line of contact");
  require(contact, kElasticity, "[E1, E2], Young's moduli of cam and follower,");
  const auto width = contact.number(kWidth, kLinkLength);
  const auto elasticity = contact.two(kElasticity, kPositive, "[E1, E2]");
  const auto poisson = contact.two(kRatios, kPoisson, "[nu1, nu2]");
  ContactMaterials materials;
  double sum = 0;
  for (int i = 0; i < 2; ++i) {
    if (elasticity) materials.elasticity[i] = (*elasticity)[i];
    if (poisson) materials.poisson[i] = (*poisson)[i];
    const double ratio = materials.poisson[i];
    sum += (1 - ratio * ratio) / materials.elasticity[i];
  }
  if (!width || !elasticity) return;
  problem.operation.width = *width;
  problem.operation.modulus_sum = sum;
  problem.materials = materials;
}

bool judges_forces(const CamProblem& problem) {
  const CamConstraints& c = problem.constraints;
  return c.contact_force_max || c.torque_max || c.contact_stress_max ||
         problem.objective == CamObjective::contact_force ||
         problem.objective == CamObjective::torque ||
         problem.objective == CamObjective::contact_stress;
}

std::string joined(const std::vector<std::string>& keys) {
  std::string text;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == keys.size() ? " and " : ", ") + keys[i];
  }
  return text;
}

}  // namespace

void read_cam_operation(TableReader& document, TableReader& follower, CamProblem& problem) {
  TableReader drive = document.table("drive");
  const auto speed = drive.turning_speed(kSpeed, kTurningSpeed);
  problem.operation.speed = speed.value_or(0);
  problem.has_operation = read_masses_and_forces(follower, problem);
  if (problem.operation.inertia > 0 && !drive.has_speed(kSpeed)) {
    drive.fault(kSpeed, fmt::format("is missing, without which follower.{} presses on nothing; "
                                    "expected {}",
                                    is_oscillating(problem.follower) ? kInertia : kMassKey,
                                    kTurningSpeed.allowed));
  }
  drive.finish();
  if (!document.has("contact")) return;
  TableReader contact = document.table("contact");
  if (is_knife(problem.follower)) {
    document.fault("contact",
                   "is given, but a knife edge presses without limit; remove it, or "
                   "take a roller");
  }
  if (!problem.has_operation) {
    document.fault("contact", fmt::format("is given, but nothing presses the follower on the cam; "
                                          "expected {} as well",
                                          missing_for_forces(problem, false)));
  }
  read_contact(contact, problem);
  contact.finish();
  problem.has_contact = problem.has_operation && problem.materials.has_value();
}

void check_preload(TableReader& follower, const CamProblem& problem) {
  if (problem.preload || problem.free_motion.empty() || !judges_forces(problem)) return;
  follower.fault(
      kPreload,
      "is missing; expected a number, since forces are limited and angles or shares of the motion "
      "are free (the least preload would change with the motion)");
}

std::string missing_for_forces(const CamProblem& problem, bool stress) {
  std::vector<std::string> keys;
  if (!problem.has_operation) {
    keys.push_back(fmt::format("follower.{} (with drive.speed), spring_rate, preload or load",
                               is_oscillating(problem.follower) ? kInertia : kMassKey));
  }
  if (stress && !problem.materials) {
    keys.emplace_back("contact.width");
    keys.emplace_back("contact.elasticity");
  }
  return joined(keys);
}

}  // namespace cognate::problems::reading
