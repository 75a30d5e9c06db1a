#include "problems/study/read_base.hpp"

#include <fmt/core.h>

#include "problems/study/key_path.hpp"
#include "problems/task_document.hpp"
#include "problems/toml/file_text.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kBase = "base";
constexpr std::string_view kWanted = "expected the path of a problem or mechanism file";

/// The path data of a closed curve, from wherever they were read; empty where there are none.
std::string drawing_of(const Task& task) {
  const auto* const path = std::get_if<PathProblem>(&task);
  return path && path->curve ? path->curve->svg_path : "";
}

void fault_base(TableReader& study_file, const std::string& base, const Fault& first) {
  study_file.fault(kBase, fmt::format("{} has a fault of its own, at {}:{}: {}", in_quotes(base),
                                      first.line, first.column, first.message));
}

bool begins_with_atlas(const Task& task) {
  const auto* const path = std::get_if<PathProblem>(&task);
  return path && path->atlas;
}

/// Whether rows would depend on the file of a gear train beside the base.
bool names_train_file(const Task& task) {
  const auto* const machine = std::get_if<MachineProblem>(&task);
  return machine && machine->motor && machine->motor->train && !machine->motor->train->file.empty();
}

}  // namespace

std::optional<BaseFile> read_base(TableReader& study_file, const std::filesystem::path& folder,
                                  const MetricCatalogue& metrics, Study& study) {
  if (!study_file.has(kBase)) study_file.fault(kBase, fmt::format("is missing; {}", kWanted));
  const auto base = study_file.text(kBase);
  if (!base) return std::nullopt;
  const auto file = folder / *base;
  auto text = base->empty() ? tl::unexpected(fmt::format("the name is empty; {}", kWanted))
                            : text_of(file, NamedBy::other_file);
  if (!text) {
    study_file.fault(kBase, fmt::format("is {}: {}", in_quotes(*base), text.error()));
    return std::nullopt;
  }
  study.base = *base;
  study.base_text = *std::move(text);
  study.folder = file.parent_path();
  auto document = read_text(study.base_text);
  if (!document) {
    fault_base(study_file, *base, document.error().front());
    return std::nullopt;
  }
  if (is_study(*document)) {
    study_file.fault(kBase,
                     fmt::format("is {}, which is itself a study; {}", in_quotes(*base), kWanted));
    return std::nullopt;
  }
  const auto read = read_task(*document, study.folder);
  if (!read) {
    fault_base(study_file, *base, read.error().front());
    return std::nullopt;
  }
  if (begins_with_atlas(read->task)) {
    study_file.fault(
        kBase, fmt::format("is {}, which has solve.atlas, a file that its rows would depend on; "
                           "expected a base without one",
                           in_quotes(*base)));
    return std::nullopt;
  }
  if (names_train_file(read->task)) {
    study_file.fault(
        kBase,
        fmt::format("is {}, whose motor.train is a file that its rows would depend on; "
                    "expected a base with the tables of the train under [motor.train], whose "
                    "numbers can then vary too",
                    in_quotes(*base)));
    return std::nullopt;
  }
  BaseFile found{*std::move(document), {}, metrics(read->task)};
  found.number_keys = number_keys(found.document);
  study.drawing = drawing_of(read->task);
  study.length_unit =
      std::visit([](const auto& problem) { return problem.length_unit; }, read->task);
  return found;
}

}  // namespace cognate::problems::reading
