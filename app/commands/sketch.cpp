#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/console/messages.hpp"
#include "app/documents/output_files.hpp"
#include "app/documents/result_json.hpp"
#include "app/report/filled_page.hpp"
#include "app/report/page.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

/// A page of its name, with the unit of its lengths.
struct Page {
  const char* name;
  std::string (*text)();
  const char* length_unit;
};

constexpr Page kCurvePage{"sketch.html", sketch_page, ""};
constexpr Page kMechanismPage{"mechanism.html", build_page, "mm"};

/// Writes the page to `file`; nothing is replaced.
FileResult write_page(const Page& page, const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const auto ready = prepare_folder(folder, {file.filename().string()});
  if (!ready) return ready;
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error))) {
    return tl::unexpected(printable(file.string()) +
                          ": is there already; move it, or choose another name with --out");
  }
  return write_file(
      file, filled_page(page.text(), nlohmann::ordered_json::object(), page.length_unit));
}

}  // namespace

ExitStatus sketch_command(bool mechanism, const Options& options) {
  const Page& page = mechanism ? kMechanismPage : kCurvePage;
  const fs::path file = options.out.value_or(page.name).lexically_normal();
  if (!file.has_filename()) {
    complain(printable(file.string()) + ": is a folder; --out expects the name of a file");
    return exit_bad_input;
  }
  if (const auto written = write_page(page, file); !written) {
    complain(written.error());
    return exit_bad_input;
  }
  const std::string path = file.string();
  if (options.json) return print(write_json({{"format", "cognate-sketch/1"}, {"files", {path}}}));
  if (options.quiet) return exit_done;
  return print("wrote " + printable(path) + "; open it in a browser\n");
}

}  // namespace cognate::app
