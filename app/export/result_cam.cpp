#include "app/export/result_cam.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/export/toml_text.hpp"
#include "problems/cam/second_contact.hpp"
#include "problems/cam/variables.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::CamProblem;

/// The problem file that gives the mechanism of `given` and leaves nothing free.
ordered_json problem_tables(const ResultDesign& given) {
  constexpr std::array<std::string_view, 7> kOfMechanism = {
      "base_radius", "offset",   "roller_radius", "centre_distance",
      "arm",         "rotation", "face_offset"};
  ordered_json tables = head_of(given, "cam");
  tables["follower"] = ordered_json::object();
  for (const auto& [key, value] : given.table["mechanism"].items()) {
    if (key == "type" || key == "preload") continue;
    if (key == "follower") {
      tables["follower"]["type"] = value;
    } else if (key == "motion") {
      tables["motion"] = value;
    } else {
      const bool dimension = std::ranges::find(kOfMechanism, key) != kOfMechanism.end();
      tables[dimension ? "mechanism" : "follower"][key] = value;
    }
  }
  return tables;
}

bool is_whole(const CamProblem& problem) {
  return problem.free_motion.empty() &&
         std::ranges::all_of(problem.lengths, [](const problems::CamLength& length) {
           return !length.used || length.given;
         });
}

/// The cam of a problem without unknowns; nothing where there is none.
std::optional<problems::CamDesign> made_of(const CamProblem& problem) {
  const auto programme = cam::programme_of(problem.motion);
  if (!programme) return std::nullopt;
  problems::CamDesign made;
  made.cam = {problems::CamVariables(problem).system<double>({}), *programme};
  if (!std::isfinite(made.cam.system.start)) return std::nullopt;
  if (problem.second.closure == cam::Closure::conjugate) {
    made.second = problems::conjugate_cam(made.cam, problem.second);
    if (!made.second) return std::nullopt;
  }
  made.motion = problem.motion;
  return made;
}

}  // namespace

tl::expected<ResultCam, std::string> result_cam(const ResultDesign& given) {
  const auto refuse = [&](std::string_view what) {
    return tl::unexpected(
        fmt::format("{}: designs[{}].mechanism: {}", given.name, given.design - 1, what));
  };
  const auto problem = problems::parse_task<problems::CamProblem>(toml_text(problem_tables(given)));
  if (!problem) return refuse(problem.error().front().message);
  if (!is_whole(*problem)) {
    return refuse("it is not whole; expected a table with every dimension of the follower");
  }
  auto cam = made_of(*problem);
  if (!cam) {
    return refuse("its dimensions cannot be put together; expected a cam that exists");
  }
  return ResultCam{*problem, *std::move(cam)};
}

}  // namespace cognate::app
