#include "app/kinds/gear/description.hpp"

#include <fmt/core.h>

#include "app/console/messages.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using problems::Gearing;
using problems::GearPairProblem;
using problems::to_string;

std::string titled(const std::string& title, const std::string& what) {
  return printable(title.empty() ? what : title + ": " + what);
}

/// "teeth, module", what is found.
std::string free_parts(const GearPairProblem& problem) {
  if (problem.gearing == Gearing::bevel || problem.gearing == Gearing::worm) return {};
  std::string text;
  const auto add = [&](const char* name) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
  };
  if (!problem.teeth[0]) add("teeth");
  if (!problem.module) add("module");
  if (!problem.profile_shift[0] || !problem.profile_shift[1]) add("profile shifts");
  if (!problem.centre_distance && !text.empty()) add("centre distance");
  return text;
}

std::string teeth_text(const GearPairProblem& problem) {
  if (problem.gearing == Gearing::worm) {
    return fmt::format(" of {:g} start{} and {:g} teeth", problem.worm.starts,
                       problem.worm.starts == 1 ? "" : "s", problem.worm.wheel_teeth);
  }
  if (!problem.teeth[0] || !problem.teeth[1]) return {};
  return fmt::format(" of {} and {} teeth", *problem.teeth[0], *problem.teeth[1]);
}

}  // namespace

std::string describe(const problems::GearProblem& problem) {
  const auto& gear = problem.gear.normal;
  return titled(problem.title, fmt::format("{} gear of {:g} teeth, module {:g}",
                                           to_string(problem.gearing), gear.teeth, gear.module));
}

std::string describe(const GearPairProblem& problem) {
  std::string what = fmt::format("{} gear pair{}", to_string(problem.gearing), teeth_text(problem));
  if (problem.module) what += fmt::format(", module {:g}", *problem.module);
  const std::string free = free_parts(problem);
  if (!free.empty()) what += ", free: " + free;
  return titled(problem.title, what);
}

}  // namespace cognate::app
