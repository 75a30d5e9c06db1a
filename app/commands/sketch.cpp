#include <nlohmann/json.hpp>

#include "analysis/mechanism/followed_motion.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/console/messages.hpp"
#include "app/documents/json_values.hpp"
#include "app/documents/output_files.hpp"
#include "app/documents/result_json.hpp"
#include "app/report/filled_page.hpp"
#include "app/report/page.hpp"
#include "problems/evaluation/as_drawn.hpp"
#include "problems/read.hpp"

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

/// How many the unit of the file has. Without one lengths are those of the sheet, or metres where
/// forces are computed.
double millimetres(const problems::AnalysisProblem& problem) {
  const bool has_unit = problem.length_unit || has_forces(problem);
  return has_unit ? 1000 * problems::metres(problem.length_unit) : 1;
}

/// Where masses and loads are where the drive begins, by the names of their bodies.
nlohmann::ordered_json places_of(const problems::AnalysisProblem& problem) {
  const auto& bodies = problem.mechanism.bodies;
  MechanismMotion<0> motion(problem.mechanism.mechanism);
  move_followed(motion, problem.drive.start);
  const auto place = [&](const Attached<double>& at) {
    const Vec2d point = motion.point(at)[0];
    return nlohmann::ordered_json::array({point.x, point.y});
  };
  auto centres = nlohmann::ordered_json::object();
  for (std::size_t i = 1; i < problem.inertias.size(); ++i) {
    centres[bodies[i]] = place({static_cast<int>(i), problem.inertias[i].centre});
  }
  auto loads = nlohmann::ordered_json::array();
  for (const problems::LoadRule& load : problem.loads) {
    loads.push_back(
        {{"body", bodies[static_cast<std::size_t>(load.at.body)]}, {"at", place(load.at)}});
  }
  return {{"centres", std::move(centres)}, {"loads", std::move(loads)}};
}

/// What the page begins with: nothing, or the mechanism of a file by its joints as drawn.
tl::expected<nlohmann::ordered_json, ExitStatus> beginning(const std::string& file,
                                                           const Options& options) {
  auto data = nlohmann::ordered_json::object();
  if (file.empty()) return data;
  const auto problem = problems::read_task<problems::AnalysisProblem>(file);
  if (!problem) return tl::unexpected(refuse(file, problem.error(), options));
  const auto drawn = problems::written_as_drawn(*problem);
  if (!drawn) {
    complain(printable(file) + ": " + drawn.error());
    return tl::unexpected(exit_bad_input);
  }
  data["problem"] = to_json(*drawn);
  data["places"] = places_of(*problem);
  data["millimetres"] = millimetres(*problem);
  data["left_out"] = problem->tolerances.has_value() || problem->layers.has_value();
  return data;
}

/// Writes the page to `file`; nothing is replaced.
FileResult write_page(const Page& page, const nlohmann::ordered_json& data, const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  auto ready = prepare_folder(folder, {file.filename().string()});
  if (!ready) return ready;
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error))) {
    return tl::unexpected(printable(file.string()) +
                          ": is there already; move it, or choose another name with --out");
  }
  return write_file(file, filled_page(page.text(), data, page.length_unit));
}

}  // namespace

ExitStatus sketch_command(bool mechanism, const std::string& given, const Options& options) {
  const Page& page = mechanism || !given.empty() ? kMechanismPage : kCurvePage;
  const fs::path file = options.out.value_or(page.name).lexically_normal();
  if (!file.has_filename()) {
    complain(printable(file.string()) + ": is a folder; --out expects the name of a file");
    return exit_bad_input;
  }
  const auto data = beginning(given, options);
  if (!data) return data.error();
  if (const auto written = write_page(page, *data, file); !written) {
    complain(written.error());
    return exit_bad_input;
  }
  const std::string path = file.string();
  if (options.json) return print(write_json({{"format", "cognate-sketch/1"}, {"files", {path}}}));
  if (options.quiet) return exit_done;
  return print("wrote " + printable(path) + "; open it in a browser\n");
}

}  // namespace cognate::app
