/// @file What the studio's server answers.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/console/options.hpp"
#include "app/studio/edited_file.hpp"
#include "app/studio/local_server.hpp"
#include "app/studio/workbench.hpp"

namespace cognate::app {

/// GET  /          the page
///      /report    that of the last result
///      /sketch    the page on which a curve is drawn
///      /mechanism the page on which a mechanism is built
///      /state     how the computation and the file stand; with ?after=N once that is no longer
///                 change N, or after 20 s
///      /file      the last version of the file: text, version
///      /template  ?name=: the text of a template
/// POST /check     {text}: what it asks for, or its faults
///      /solve     {text}: begins with it, and ends the run before; or its faults
///      /stop      {}: the run ends with what it has found
///      /export    the options of `cognate export`: files of the last result, or faults
///      /save      {text, version}: 409 where the file has another version by now
class StudioRoutes {
 public:
  /// `file` may be null.
  StudioRoutes(std::string token, std::unique_ptr<EditedFile> file, const Options& options);

  HttpAnswer answer(const HttpRequest& request);

  /// A path that leads a browser to the page once. Other users see the command lines of browsers,
  /// so the token is not for these.
  std::string invite();
  /// Whether a request has the invitation, which then is used up.
  bool is_invitation(const HttpRequest& request);

  /// Finds out whether the file has been saved. To be called in even steps of time.
  void look_at_file();

  /// Answers whoever waits, and stops what runs.
  void close();

 private:
  HttpAnswer get(const HttpRequest& request);
  HttpAnswer post(const HttpRequest& request);
  /// `body` is what it holds, an object.
  HttpAnswer post(const HttpRequest& request, const nlohmann::ordered_json& body);
  HttpAnswer page() const;
  HttpAnswer state(const HttpRequest& request);
  HttpAnswer solve(const std::string& text);
  HttpAnswer exported_answer(const nlohmann::ordered_json& asked) const;
  HttpAnswer save(const std::string& text, std::uint64_t version);
  std::filesystem::path folder() const;
  void note_change();

  const std::string token_;
  const std::unique_ptr<EditedFile> file_;
  const Options options_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t changes_ = 0;
  std::string invitation_;  ///< empty: there is none
  bool closing_ = false;

  Workbench workbench_;  // last: it reports changes until it is gone
};

}  // namespace cognate::app
