/// @file What every command that computes does about its computation: steers it, writes its files,
/// prints, and says how it ended.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/console/messages.hpp"
#include "app/console/options.hpp"
#include "app/console/screen.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"

namespace cognate::app {

/// A file that a command writes beside NAME.result.json: NAME followed by `ending`. `text` is made
/// of the result document.
struct OutputFile {
  std::string ending;
  std::function<std::string(const nlohmann::ordered_json& document)> text;
};

/// What one command does differently from another; called in the order in which it stands here.
struct Computation {
  std::function<problems::Status(const problems::Run& run)> run;
  std::function<tl::expected<nlohmann::ordered_json, std::string>()> document;
  std::vector<OutputFile> files;
  std::string when_interrupted;  ///< said after an interrupt: what is reported nevertheless
  std::function<std::string(const Screen& screen)> table;
  std::function<ExitStatus()> exit_status;
  std::function<bool()>
      is_abandoned;  ///< whether nobody waits for the result any more; may be empty
};

/// The document `cognate-check/1` of a file with faults.
nlohmann::ordered_json faults_document(const std::filesystem::path& file,
                                       const std::vector<problems::Fault>& faults);

/// Says the faults of `file` on standard error, with `--json` also as that document on standard
/// output; the status is that of bad input.
ExitStatus refuse(const std::filesystem::path& file, const std::vector<problems::Fault>& faults,
                  const Options& options);

/// The same of a file that is no result, or lacks what is asked of it: `message` begins with its
/// name.
ExitStatus refuse_result(const std::filesystem::path& file, const std::string& message,
                         const Options& options);

/// Runs `computation` of the problem in `file` as `options` say: with progress and interrupts,
/// writes NAME.result.json and its files, NAME being the file's stem, and prints the table (with
/// `--json` the document, with `--quiet` nothing). Whether the files can be written is found out
/// before anything is computed; with `--json` they are written only where `--out` is given.
ExitStatus compute(const std::filesystem::path& file, const Options& options,
                   const Computation& computation);

}  // namespace cognate::app
