#include "app/kinds/cam/description.hpp"

#include <fmt/core.h>

#include "app/console/messages.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using problems::to_string;

/// "base_radius and offset", the lengths that are found; empty where all are given.
std::string free_lengths(const problems::CamProblem& problem) {
  std::string text;
  for (const auto& dimension : problems::names<problems::CamDimension>()) {
    const auto& length = problem.length(dimension.value);
    if (length.used && !length.given) {
      text += fmt::format("{}{}", text.empty() ? "" : ", ", dimension.name);
    }
  }
  return text;
}

}  // namespace

std::string describe(const problems::CamProblem& problem) {
  const std::size_t segments = problem.motion.size();
  std::string what = fmt::format("cam of a follower {}, {} segment{} of motion",
                                 to_string(problem.follower), segments, segments == 1 ? "" : "s");
  const std::string lengths = free_lengths(problem);
  if (!lengths.empty()) what += ", free: " + lengths;
  const std::size_t free = problem.free_motion.size();
  if (free > 0) what += fmt::format(", {} free value{} of the motion", free, free == 1 ? "" : "s");
  return printable(problem.title.empty() ? what : problem.title + ": " + what);
}

}  // namespace cognate::app
