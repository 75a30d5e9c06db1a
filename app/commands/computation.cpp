#include "app/commands/computation.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/console/interrupt.hpp"
#include "app/console/messages.hpp"
#include "app/console/progress.hpp"
#include "app/console/terminal.hpp"
#include "app/documents/output_files.hpp"
#include "app/documents/result_json.hpp"
#include "app/study/cache_folder.hpp"
#include "problems/basics/enumeration.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Where the files go: that of the result first, then those of the computation in their order.
struct Outputs {
  fs::path folder;
  std::vector<std::string> names;
};

/// Nothing where the options want no files.
std::optional<Outputs> outputs_of(const fs::path& file, const Options& options,
                                  const Computation& computation) {
  if (options.json && !options.out) return std::nullopt;
  const std::string stem = file.stem().string();
  Outputs outputs{options.out.value_or("."), {stem + ".result.json"}};
  for (const auto& output : computation.files) outputs.names.push_back(stem + output.ending);
  return outputs;
}

problems::Status run(const Computation& computation, const Options& options) {
  const auto& interrupted = catch_interrupts();
  Progress progress(options.quiet, interrupted);
  progress.enter(problems::to_string(problems::Phase::search), 1);
  return computation.run(
      {.seed = options.seed,
       .threads = options.threads,
       .time_limit = options.time_limit,
       .interrupted = &interrupted,
       .cache = cache_folder(),
       .progress = [&](double share, double best) { progress.update(share, best); },
       .phase = [&](problems::Phase begun,
                    double to) { progress.enter(problems::to_string(begun), to); }});
}

FileResult write_outputs(const Outputs& outputs, const ordered_json& document,
                         const Computation& computation) {
  auto written = write_file(outputs.folder / outputs.names.front(), write_json(document));
  for (std::size_t i = 0; written && i < computation.files.size(); ++i) {
    written =
        write_file(outputs.folder / outputs.names[i + 1], computation.files[i].text(document));
  }
  return written;
}

/// The paths as the user would write them: without a leading "./".
std::string files_line(const Outputs& outputs) {
  std::vector<std::string> files;
  for (const auto& name : outputs.names) {
    files.push_back(printable((outputs.folder / name).lexically_normal().string()));
  }
  return fmt::format("wrote {}\n", problems::enumeration(files));
}

}  // namespace

ordered_json faults_document(const fs::path& file, const std::vector<problems::Fault>& faults) {
  ordered_json rows = ordered_json::array();
  for (const auto& fault : faults) {
    rows.push_back({{"line", fault.line}, {"column", fault.column}, {"message", fault.message}});
  }
  return {{"format", "cognate-check/1"},
          {"file", file.string()},
          {"valid", false},
          {"faults", std::move(rows)}};
}

ExitStatus refuse(const fs::path& file, const std::vector<problems::Fault>& faults,
                  const Options& options) {
  write_standard_error(fault_lines(file, faults));
  if (options.json) print(write_json(faults_document(file, faults)));
  return exit_bad_input;
}

ExitStatus refuse_result(const fs::path& file, const std::string& message, const Options& options) {
  write_standard_error(printable(message) + '\n');
  const std::string name = file.string() + ": ";
  const bool named = message.starts_with(name);
  if (options.json) {
    print(write_json(faults_document(file, {{1, 1, message.substr(named ? name.size() : 0)}})));
  }
  return exit_bad_input;
}

ExitStatus compute(const fs::path& file, const Options& options, const Computation& computation) {
  const auto complain_that = [](const std::string& what) {
    complain(what);
    return exit_bad_input;
  };
  const auto outputs = outputs_of(file, options, computation);
  if (outputs) {
    const auto ready = prepare_folder(outputs->folder, outputs->names);
    if (!ready) return complain_that(ready.error());
  }
  const auto status = run(computation, options);
  if (computation.is_abandoned && computation.is_abandoned()) return exit_done;
  const auto document = computation.document();
  if (!document) {
    complain("a fault of Cognate's own: " + document.error());
    return exit_own_fault;
  }
  if (outputs) {
    const auto written = write_outputs(*outputs, *document, computation);
    if (!written) return complain_that(written.error());
  }
  if (status == problems::Status::interrupted) complain(computation.when_interrupted);

  std::string text;
  if (options.json) {
    text = write_json(*document);
  } else if (!options.quiet) {
    const Screen screen = standard_output();
    text = fitted(computation.table(screen) + files_line(*outputs), screen);
  }
  const ExitStatus printed = print(text);
  return printed == exit_done ? computation.exit_status() : printed;
}

}  // namespace cognate::app
