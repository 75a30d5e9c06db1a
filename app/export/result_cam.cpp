#include "app/export/result_cam.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/export/toml_text.hpp"
#include "problems/cam/cam_variables.hpp"
#include "problems/cam/second_contact.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using problems::CamProblem;

constexpr std::size_t kMostBytes = 256U << 20U;
constexpr int kDeepest = 64;  // no result nests its values further

tl::unexpected<std::string> refusal(const std::string& name, std::string_view what) {
  return tl::unexpected(fmt::format("{}: {}", name, what));
}

tl::expected<std::string, std::string> text_of(const fs::path& file) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (!fs::exists(status)) {
    return refusal(file.string(),
                   "the file does not exist or cannot be reached; the path of a result file is "
                   "wanted");
  }
  if (fs::is_directory(status)) {
    return refusal(file.string(), "this is a directory; the path of a result file is wanted");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    return refusal(file.string(), "the file cannot be opened; a file that can be read is wanted");
  }
  std::string text;
  std::array<char, 1 << 16> part{};
  while (stream.read(part.data(), part.size()) || stream.gcount() > 0) {
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > kMostBytes) {
      return refusal(file.string(), "the file is larger than 256 MiB; at most 256 MiB are allowed");
    }
  }
  if (stream.bad()) {
    return refusal(file.string(), "the file cannot be read to its end; a whole file is wanted");
  }
  return text;
}

/// What the parser says without its own prefix: "[json.exception.…] parse error at line …: ".
std::string reason(const std::string& message) {
  const auto column = message.find(": ");
  return column == std::string::npos ? message : message.substr(column + 2);
}

/// The line and the column of byte `byte`, counted from 1.
std::string place(std::string_view text, std::size_t byte) {
  const auto before = text.substr(0, std::min(text.size(), byte > 0 ? byte - 1 : 0));
  const auto line = std::ranges::count(before, '\n') + 1;
  const auto begin = before.rfind('\n');
  return fmt::format("{}:{}", line,
                     begin == std::string_view::npos ? before.size() + 1 : before.size() - begin);
}

tl::expected<ordered_json, std::string> parse_json(std::string_view text, const std::string& name) {
  bool too_deep = false;
  const auto keep = [&](int depth, ordered_json::parse_event_t, ordered_json&) {
    too_deep = too_deep || depth > kDeepest;
    return !too_deep;
  };
  try {
    ordered_json document = ordered_json::parse(text, keep);
    if (!too_deep) return document;
    return refusal(name, "its values are nested too deep; a cognate-result/1 is wanted");
  } catch (const ordered_json::parse_error& error) {
    return refusal(
        fmt::format("{}:{}", name, place(text, error.byte)),
        fmt::format("not valid JSON: {}; a cognate-result/1 is wanted", reason(error.what())));
  } catch (const ordered_json::exception& error) {
    return refusal(name, fmt::format("not valid JSON: {}; a cognate-result/1 is wanted",
                                     reason(error.what())));
  }
}

/// The string under `key`; empty where there is none.
std::string text_under(const ordered_json& table, const char* key) {
  if (!table.is_object()) return {};
  const auto found = table.find(key);
  return found != table.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// The table `mechanism` of the design wanted.
tl::expected<ordered_json, std::string> mechanism_of(const ordered_json& document, int design,
                                                     const std::string& name) {
  if (text_under(document, "format") != "cognate-result/1") {
    return refusal(name,
                   "this is no result of Cognate; a document with \"format\": "
                   "\"cognate-result/1\" is wanted");
  }
  const std::string kind = text_under(document.value("problem", ordered_json()), "kind");
  if (kind != "cam") {
    return refusal(name, fmt::format("this is the result of a problem of kind \"{}\", whose export "
                                     "is not available in this version; available is that of cams",
                                     kind));
  }
  const auto designs = document.value("designs", ordered_json());
  if (!designs.is_array() || designs.empty()) {
    return refusal(name, "this result has no design; a result with a cam is wanted");
  }
  const auto index = static_cast<std::size_t>(design - 1);
  if (index >= designs.size()) {
    return refusal(name, fmt::format("there is no design {}; allowed is --design from 1 to {}",
                                     design, designs.size()));
  }
  if (designs[index].is_object()) {
    const auto found = designs[index].find("mechanism");
    if (found != designs[index].end() && text_under(*found, "type") == "cam") return *found;
  }
  return refusal(name,
                 fmt::format("designs[{}] has no mechanism of type \"cam\"; one is wanted", index));
}

/// The problem file that gives `mechanism` and leaves nothing free.
ordered_json problem_tables(const ordered_json& mechanism) {
  constexpr std::array<std::string_view, 7> kOfMechanism = {
      "base_radius", "offset",   "roller_radius", "centre_distance",
      "arm",         "rotation", "face_offset"};
  ordered_json tables = {{"kind", "cam"}, {"follower", ordered_json::object()}};
  for (const auto& [key, value] : mechanism.items()) {
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

tl::expected<ResultCam, std::string> parse_result_cam(std::string_view text, int design,
                                                      const std::string& name) {
  const auto document = parse_json(text, name);
  if (!document) return tl::unexpected(document.error());
  const auto mechanism = mechanism_of(*document, design, name);
  if (!mechanism) return tl::unexpected(mechanism.error());
  const auto refuse = [&](std::string_view what) {
    return refusal(name, fmt::format("designs[{}].mechanism: {}", design - 1, what));
  };
  const auto problem = problems::parse_cam(toml_text(problem_tables(*mechanism)));
  if (!problem) return refuse(problem.error().front().message);
  if (!is_whole(*problem)) {
    return refuse("it is not whole; a table with every dimension of the follower is wanted");
  }
  auto cam = made_of(*problem);
  if (!cam) {
    return refuse("its dimensions cannot be put together; a cam that exists is wanted");
  }
  return ResultCam{*problem, *std::move(cam)};
}

tl::expected<ResultCam, std::string> read_result_cam(const fs::path& file, int design) {
  const auto text = text_of(file);
  if (!text) return tl::unexpected(text.error());
  return parse_result_cam(*text, design, file.string());
}

}  // namespace cognate::app
