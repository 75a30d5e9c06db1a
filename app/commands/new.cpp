#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/commands/starters.hpp"
#include "app/console/messages.hpp"
#include "app/documents/output_files.hpp"
#include "app/documents/result_json.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

ExitStatus complain_of(const std::string& what) {
  complain(what);
  return exit_bad_input;
}

/// "cognate solve ": the command that takes a file, as its first comment says it.
std::string_view next_command(std::string_view text) {
  const auto from = text.find("cognate ");
  return text.substr(from, text.find(' ', text.find(' ', from) + 1) + 1 - from);
}

}  // namespace

ExitStatus new_command(const std::string& kind, const Options& options) {
  const auto found = std::ranges::find(starters(), kind, &Starter::kind);
  if (found == starters().end()) return complain_of(unknown_kind(kind));
  const std::string name = kind + ".toml";
  const fs::path folder = options.out.value_or("."), file = folder / name;
  if (const auto ready = prepare_folder(folder, {name}); !ready) return complain_of(ready.error());
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error))) {
    return complain_of(printable(file.lexically_normal().string()) +
                       ": is there already; move it, or choose a folder with --out");
  }
  if (const auto written = write_file(file, found->text); !written) {
    return complain_of(written.error());
  }
  const std::string path = file.lexically_normal().string();
  if (options.json) return print(write_json({{"format", "cognate-new/1"}, {"files", {path}}}));
  if (options.quiet) return exit_done;
  return print(
      fmt::format("wrote {0}; next: {1}{0}\n", printable(path), next_command(found->text)));
}

std::string unknown_kind(const std::string& kind) {
  std::vector<std::string_view> known;
  for (const Starter& starter : starters()) known.push_back(starter.kind);
  const auto meant = problems::reading::nearest(kind, known);
  return fmt::format("{} is no kind of problem{}; allowed are {}",
                     problems::reading::in_quotes(kind),
                     meant ? fmt::format(", perhaps for \"{}\"", *meant) : "",
                     problems::reading::quoted_list(known));
}

}  // namespace cognate::app
