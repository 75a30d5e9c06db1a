#include "problems/cam/read_follower.hpp"

#include <fmt/core.h>

#include "problems/cam/rules.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

using cam::Closure;
using cam::FollowerType;

constexpr std::string_view kType = "type", kSide = "side", kClosure = "closure",
                           kBreadth = "breadth", kArms = "arms_deg";

void read_side(TableReader& follower, CamProblem& problem) {
  const auto side = follower.choice<cam::ArmSide>(kSide);
  if (follower.has(kSide) && !is_oscillating(problem.follower)) {
    follower.fault(
        kSide, fmt::format("is given, but {} has no arm; remove it", in_words(problem.follower)));
  }
  problem.side = side.value_or(problem.side);
}

// Empty where `type` can be closed so; else what can.
std::string_view only_for(Closure closure, FollowerType type) {
  const bool roller =
      type == FollowerType::translating_roller || type == FollowerType::oscillating_roller;
  switch (closure) {
    case Closure::force:
      return {};
    case Closure::groove:
    case Closure::conjugate:
      return roller ? "" : "expected a roller, translating or oscillating";
    case Closure::constant_breadth:
      return type == FollowerType::translating_flat || type == FollowerType::translating_roller
                 ? ""
                 : "expected a translating flat face or a translating roller";
  }
  return {};
}

void read_breadth(TableReader& follower, CamProblem& problem) {
  SecondContact& second = problem.second;
  const bool swings = is_oscillating(problem.follower);
  const auto breadth = follower.number(kBreadth, kLinkLength);
  const auto angle = follower.number(kArms, kArmsAngle);
  const bool two =
      second.closure == Closure::conjugate || second.closure == Closure::constant_breadth;
  if (follower.has(kBreadth) && (!two || swings)) {
    follower.fault(kBreadth,
                   "is given, but belongs to a translating follower with closure = \"conjugate\" "
                   "or \"constant-breadth\"; remove it");
  }
  if (follower.has(kArms) && (!two || !swings)) {
    follower.fault(kArms,
                   "is given, but belongs to an oscillating follower with closure = "
                   "\"conjugate\"; remove it");
  }
  if (two && swings && !follower.has(kArms)) {
    follower.fault(kArms, fmt::format("is missing; expected the angle between the two arms, {}",
                                      kArmsAngle.allowed));
  }
  second.breadth = breadth;
  if (angle) second.arms_angle = radians(*angle);
}

void read_closure(TableReader& follower, CamProblem& problem) {
  const auto closure = follower.choice<Closure>(kClosure);
  problem.second.closure = closure.value_or(Closure::force);
  if (follower.has(kClosure) && !closure) {  // what else belongs to it cannot be known
    follower.know({kBreadth, kArms});
    return;
  }
  const std::string_view wanted = only_for(problem.second.closure, problem.follower);
  if (!wanted.empty()) {
    follower.fault(kClosure, fmt::format("is \"{}\", which {} does not have; {}",
                                         to_string(problem.second.closure),
                                         in_words(problem.follower), wanted));
    follower.know({kBreadth, kArms});
    return;
  }
  read_breadth(follower, problem);
}

}  // namespace

std::string_view in_words(FollowerType type) {
  switch (type) {
    case FollowerType::translating_roller:
      return "a translating roller";
    case FollowerType::translating_flat:
      return "a translating flat face";
    case FollowerType::translating_knife:
      return "a translating knife edge";
    case FollowerType::oscillating_roller:
      return "an oscillating roller";
    case FollowerType::oscillating_flat:
      return "an oscillating flat face";
    case FollowerType::oscillating_knife:
      return "an oscillating knife edge";
  }
  return {};
}

bool has_opposite_roller(const CamProblem& problem) {
  return problem.second.closure == Closure::constant_breadth &&
         problem.follower == FollowerType::translating_roller;
}

bool read_follower(TableReader& follower, CamProblem& problem) {
  if (!follower.has(kType)) {
    std::vector<std::string_view> types;
    for (const auto& named : names<FollowerType>()) types.push_back(named.name);
    follower.fault(kType, fmt::format("is missing; expected {}", quoted_list(types)));
    return false;
  }
  const auto type = follower.choice<FollowerType>(kType);
  if (!type) return false;
  problem.follower = *type;
  read_side(follower, problem);
  read_closure(follower, problem);
  return true;
}

}  // namespace cognate::problems::reading
