#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <tl/expected.hpp>
#include <utility>

#include "app/commands/commands.hpp"
#include "app/console/messages.hpp"
#include "app/documents/output_files.hpp"
#include "app/documents/result_json.hpp"
#include "app/study/checksum.hpp"
#include "app/study/database.hpp"
#include "app/study/read_columns.hpp"
#include "app/study/read_rows.hpp"
#include "app/study/schema.hpp"
#include "problems/study/design_text.hpp"
#include "problems/study/key_path.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// NAME of NAME.study.db and NAME.study.h5.
std::string study_stem_of(const fs::path& file) {
  const fs::path stem = file.stem();
  return stem.extension() == ".study" ? stem.stem().string() : stem.string();
}

/// As much of the study as its file contains, which is all that the text of a design depends on.
problems::Study stored_study(SqliteDatabase& database) {
  problems::Study study;
  study.base_text = database.text("SELECT value FROM study WHERE name = 'base'");
  for (const auto& key : stored_names(database, "variables")) {
    const auto path = problems::reading::parse_key_path(key);
    study.variables.push_back({.key = key, .path = path.value_or(problems::KeyPath())});
  }
  study.metrics = stored_names(database, "metrics");
  return study;
}

/// The base file with the numbers of the design, or what is wrong.
tl::expected<std::string, std::string> text_of(const fs::path& file, std::int64_t id) {
  const auto name = file.string();
  try {
    auto database = study_rows(file, {.first = id, .most = 1});
    if (database.integer("PRAGMA application_id") != kStudyApplicationId) {
      return tl::unexpected(
          fmt::format("'{}' is no study file; expected NAME.study.db or NAME.study.h5", name));
    }
    const auto study = stored_study(database);
    const auto row = row_of(database, study, id);
    if (!row) {
      return tl::unexpected(
          fmt::format("'{}' has no row {}; the ids of its rows are those of {}", name, id,
                      is_columns_file(file) ? "the column runs/id" : "SELECT id FROM runs"));
    }
    check_rows(database, id);
    std::vector<double> values;
    for (std::size_t i = 0; i < study.variables.size(); ++i) {
      values.push_back(std::get<double>(row->cells[i]));
    }
    return problems::design_text(study, values);
  } catch (const SqliteError& error) {
    return tl::unexpected(fmt::format("cannot read '{}' as a study file: {}", name, error.what()));
  } catch (const StudyFileError& error) {
    return tl::unexpected(std::string(error.what()));
  } catch (const nlohmann::json::exception&) {
    return tl::unexpected(fmt::format("'{}' is damaged: it has no names of its columns", name));
  } catch (const std::bad_variant_access&) {
    return tl::unexpected(fmt::format("'{}' is damaged: row {} has no numbers", name, id));
  }
}

}  // namespace

ExitStatus export_row_command(const fs::path& file, std::int64_t row, const Options& options) {
  const auto complain_that = [](const std::string& what) {
    complain(what);
    return exit_bad_input;
  };
  const auto text = text_of(file, row);
  if (!text) return complain_that(text.error());
  const fs::path folder = options.out.value_or(".");
  const auto name = fmt::format("{}.{}.toml", study_stem_of(file), row);
  auto written = prepare_folder(folder, {name});
  if (written) written = write_file(folder / name, *text);
  if (!written) return complain_that(written.error());
  const auto path = (folder / name).lexically_normal().string();
  if (options.json) {
    const ordered_json document = {
        {"format", "cognate-export/1"}, {"study", file.string()}, {"row", row}, {"files", {path}}};
    return print(write_json(document));
  }
  return options.quiet ? exit_done : print("wrote " + printable(path) + '\n');
}

}  // namespace cognate::app
