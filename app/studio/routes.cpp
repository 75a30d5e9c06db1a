#include "app/studio/routes.hpp"

#include <fmt/core.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <tl/expected.hpp>
#include <utility>

#include "app/commands/computation.hpp"
#include "app/commands/problem_text.hpp"
#include "app/report/filled_page.hpp"
#include "app/report/page.hpp"
#include "app/studio/pages.hpp"
#include "app/studio/taking.hpp"
#include "app/studio/templates.hpp"
#include "app/studio/token.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

constexpr std::chrono::seconds kLongestWait{20};
constexpr const char* kFirstTemplate = "new/path-generation";

/// What the pages on which one draws are told: that the studio takes their problems.
const ordered_json kServed = {{"studio", true}};

const char* phase_word(RunState::Phase phase) {
  using Phase = RunState::Phase;
  switch (phase) {
    case Phase::idle:
      return "idle";
    case Phase::solving:
      return "solving";
    case Phase::done:
      return "done";
    case Phase::failed:
      return "failed";
  }
  return "";
}

ordered_json part_json(const RunProgress& progress) {
  const auto now = RunProgress::Clock::now();
  const auto left = progress.left(now);
  return {{"name", progress.part().words},
          {"seconds", progress.seconds_in_part(now)},
          {"left", left ? ordered_json(*left) : ordered_json()},
          {"is_last", progress.part().end == 1}};
}

ordered_json to_json(const RunState& state) {
  const RunProgress& progress = state.progress;
  const double best = progress.best();
  return {{"run", state.run},
          {"phase", phase_word(state.phase)},
          {"share", progress.share()},
          {"part", part_json(progress)},
          {"best", std::isfinite(best) ? ordered_json(best) : ordered_json()},
          {"seconds", state.seconds},
          {"status", state.status},
          {"message", state.message},
          {"report", state.report},
          {"designs", state.designs}};
}

ordered_json to_json(const FileVersion& version) {
  return {{"version", version.number}, {"text", version.text}};
}

HttpAnswer faults_answer(const std::vector<problems::Fault>& faults) {
  return json_answer(200, faults_document("", faults));
}

HttpAnswer checked(const std::string& text, const std::filesystem::path& folder) {
  const auto sound = check_text(text, folder);
  if (!sound) return faults_answer(sound.error());
  return json_answer(200, {{"format", "cognate-check/1"},
                           {"valid", true},
                           {"problem", *sound},
                           {"faults", ordered_json::array()}});
}

/// The object that the body of a request holds; the error says what is wrong with it.
tl::expected<ordered_json, std::string> object_in(const std::string& body) {
  try {
    auto document = ordered_json::parse(body);
    if (document.is_object()) return document;
    return tl::unexpected(
        fmt::format("the body is JSON of the type {}; expected an object", document.type_name()));
  } catch (const ordered_json::out_of_range&) {
    return tl::unexpected(
        std::string("a number in the body is greater than any of double precision; expected one "
                    "below 1.8e308"));
  } catch (const ordered_json::parse_error& error) {
    return tl::unexpected(
        fmt::format("the body is no JSON at its byte {}; expected a JSON object", error.byte));
  }
}

HttpAnswer no_page() {
  return error_answer(404, "no such page");
}

HttpAnswer template_answer(const HttpRequest& request) {
  const auto name = request.query.find("name");
  const auto text = name == request.query.end() ? std::nullopt : template_text(name->second);
  return text ? json_answer(200, {{"text", *text}}) : no_page();
}

/// The whole number under `key` of the query.
std::optional<std::uint64_t> number_in(const HttpRequest& request, const char* key) {
  const auto found = request.query.find(key);
  if (found == request.query.end()) return std::nullopt;
  const std::string& text = found->second;
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole ? std::optional(number) : std::nullopt;
}

}  // namespace

StudioRoutes::StudioRoutes(std::string token, std::unique_ptr<EditedFile> file,
                           const Options& options)
    : token_(std::move(token)), file_(std::move(file)), options_(options), workbench_(options) {
  workbench_.on_change([this] { note_change(); });
}

std::filesystem::path StudioRoutes::folder() const {
  return file_ ? file_->path().parent_path() : std::filesystem::path();
}

void StudioRoutes::note_change() {
  const std::lock_guard lock(mutex_);
  ++changes_;
  changed_.notify_all();
}

std::string StudioRoutes::invite() {
  const std::lock_guard lock(mutex_);
  invitation_ = random_token();
  return "/open?invitation=" + invitation_;
}

bool StudioRoutes::is_invitation(const HttpRequest& request) {
  const auto given = request.query.find("invitation");
  if (request.path != "/open" || given == request.query.end()) return false;
  const std::lock_guard lock(mutex_);
  if (invitation_.empty() || !is_same_secret(given->second, invitation_)) return false;
  invitation_.clear();
  return true;
}

void StudioRoutes::look_at_file() {
  if (file_ && file_->look()) note_change();
}

void StudioRoutes::close() {
  workbench_.stop();
  const std::lock_guard lock(mutex_);
  closing_ = true;
  changed_.notify_all();
}

HttpAnswer StudioRoutes::answer(const HttpRequest& request) {
  return request.method == "GET" ? get(request) : post(request);
}

HttpAnswer StudioRoutes::get(const HttpRequest& request) {
  const std::string& path = request.path;
  if (path == "/") return page();
  if (path == "/open") {
    return {.status = 303, .headers = {{"Location", "/?token=" + token_}}};
  }
  if (path == "/state") return state(request);
  if (path == "/template") return template_answer(request);
  if (path == "/sketch") return page_answer(filled_page(sketch_page(), kServed, ""));
  if (path == "/mechanism") return page_answer(filled_page(build_page(), kServed, "mm"));
  if (path == "/file" && file_) return json_answer(200, to_json(file_->version()));
  const auto report = path == "/report" ? workbench_.report() : nullptr;
  return report && !report->empty() ? page_answer(*report) : no_page();
}

HttpAnswer StudioRoutes::post(const HttpRequest& request) {
  const auto given = object_in(request.body);
  return given ? post(request, *given) : error_answer(400, given.error());
}

HttpAnswer StudioRoutes::post(const HttpRequest& request, const ordered_json& body) {
  if (request.path == "/stop") {
    workbench_.stop();
    return json_answer(200, ordered_json::object());
  }
  if (request.path == "/export") return exported_answer(body);
  const auto given = body.find("text");
  if (given == body.end() || !given->is_string()) {
    return error_answer(400, "text: expected a string");
  }
  const auto& text = given->get_ref<const std::string&>();
  if (request.path == "/check") return checked(text, folder());
  if (request.path == "/solve") return solve(text);
  if (request.path != "/save" || !file_) return no_page();
  const auto version = body.find("version");
  if (version == body.end() || !version->is_number_unsigned()) {
    return error_answer(400, "version: expected a whole number");
  }
  return save(text, version->get<std::uint64_t>());
}

HttpAnswer StudioRoutes::page() const {
  ordered_json templates_json = ordered_json::array();
  for (const auto& each : templates()) {
    templates_json.push_back({{"name", each.name}, {"title", each.title}});
  }
  ordered_json data = file_
                          ? to_json(file_->version())
                          : ordered_json{{"version", 0}, {"text", *template_text(kFirstTemplate)}};
  data["file"] = file_ ? ordered_json(file_->path().string()) : ordered_json();
  data["templates"] = std::move(templates_json);
  data["taking"] = taking_choices();
  return page_answer(filled_page(studio_page(), data, ""));
}

HttpAnswer StudioRoutes::state(const HttpRequest& request) {
  const auto after = number_in(request, "after");
  std::uint64_t change = 0;
  {
    std::unique_lock lock(mutex_);
    if (after) {
      changed_.wait_for(lock, kLongestWait, [&] { return closing_ || changes_ != *after; });
    }
    if (closing_) return error_answer(503, "the studio is closing");
    change = changes_;
  }
  // Read after the count: what changes meanwhile comes again.
  ordered_json document = {{"change", change}};
  document.update(to_json(workbench_.state()));
  document["file_version"] = file_ ? file_->version().number : 0;
  return json_answer(200, document);
}

HttpAnswer StudioRoutes::solve(const std::string& text) {
  const auto run = workbench_.solve(text, folder());
  return run ? json_answer(200, {{"run", *run}}) : faults_answer(run.error());
}

HttpAnswer StudioRoutes::exported_answer(const ordered_json& asked) const {
  const auto result = workbench_.result();
  if (!result) return error_answer(404, "nothing has been solved yet");
  const std::string stem = file_ ? file_->path().stem().string() : "problem";
  return json_answer(200, taken(*result, asked, stem, options_));
}

HttpAnswer StudioRoutes::save(const std::string& text, std::uint64_t version) {
  const auto saved = file_->save(text, version);
  if (saved) {
    note_change();
    return json_answer(200, {{"version", saved->number}});
  }
  return error_answer(saved.error().is_conflict ? 409 : 500, saved.error().message);
}

}  // namespace cognate::app
