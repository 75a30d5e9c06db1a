#include "problems/task_document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "problems/cam/read.hpp"
#include "problems/evaluation/read.hpp"
#include "problems/function/read.hpp"
#include "problems/gear/read.hpp"
#include "problems/gear/read_pair.hpp"
#include "problems/guidance/read.hpp"
#include "problems/machine/read.hpp"
#include "problems/path/read.hpp"
#include "problems/quick_return/read.hpp"
#include "problems/straight_line/read.hpp"
#include "problems/toml/file_text.hpp"
#include "problems/toml/nearest.hpp"
#include "problems/toml/table_reader.hpp"
#include "problems/toml/text_check.hpp"

namespace cognate::problems::reading {
namespace {

using Faults = std::vector<Fault>;
using Folder = std::filesystem::path;

// The kinds of design problems, then the other ones.
constexpr std::string_view kTaskKinds[] = {"path-generation",
                                           "function-generation",
                                           "motion-generation",
                                           "quick-return",
                                           "straight-line",
                                           "cam",
                                           "gear",
                                           "gear-pair",
                                           "analysis",
                                           "machine"};

constexpr std::string_view kBase = "base";

tl::unexpected<Faults> refusal(std::string message) {
  return tl::unexpected(Faults{{1, 1, std::move(message)}});
}

bool is_blank(std::string_view text) {
  return std::ranges::all_of(
      text, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
}

// A study asks for many tasks and is none itself.
void fault_study(TableReader& document) {
  const std::string_view place = document.has(kKind) ? kKind : kBase;
  document.fault(place, fmt::format("{}, which 'cognate sweep' runs; one of {} is wanted here",
                                    place == kKind ? "is \"study\"" : "makes this a study",
                                    quoted_list(kTaskKinds)));
}

// The document's kind, one of kTaskKinds; empty, with a fault, where it has none.
std::optional<std::string_view> read_kind(TableReader& document) {
  if (!document.has(kKind)) {
    document.fault(kKind, fmt::format("is missing; allowed are {}", quoted_list(kTaskKinds)));
    return std::nullopt;
  }
  const auto kind = document.text(kKind);
  if (!kind) return std::nullopt;
  const auto found = std::ranges::find(kTaskKinds, *kind);
  if (found != std::end(kTaskKinds)) return *found;
  std::vector<std::string_view> known(std::begin(kTaskKinds), std::end(kTaskKinds));
  known.push_back(kStudyKind);
  const auto meant = nearest(*kind, known);
  document.fault(
      kKind, fmt::format("is {}{}; available are {}", in_quotes(*kind),
                         meant ? ", perhaps for " + in_quotes(*meant) : "", quoted_list(known)));
  return std::nullopt;
}

Problem read_design_problem(std::string_view kind, TableReader& document, const Folder& folder) {
  if (kind == "path-generation") return read_path_problem(document, folder);
  if (kind == "motion-generation") return read_motion_problem(document);
  if (kind == "quick-return") return read_quick_return_problem(document);
  if (kind == "straight-line") return read_straight_line_problem(document);
  return read_function_problem(document);
}

Task read_of_kind(std::string_view kind, TableReader& document, const Folder& folder) {
  if (kind == "analysis") return read_analysis_problem(document);
  if (kind == "cam") return read_cam_problem(document);
  if (kind == "gear") return read_gear_problem(document);
  if (kind == "gear-pair") return read_gear_pair_problem(document);
  if (kind == "machine") return read_machine_problem(document);
  return read_design_problem(kind, document, folder);
}

struct GiveTitle {
  const std::string& title;

  void operator()(Problem& problem) const { std::visit(*this, problem); }
  template <class Other>
  void operator()(Other& problem) const {
    problem.title = title;
  }
};

std::optional<PlacedTask> read_document(TableReader& document, const Folder& folder) {
  const auto kind = read_kind(document);
  const std::string title = document.text("title").value_or("");
  if (!kind) return std::nullopt;
  PlacedTask read{read_of_kind(*kind, document, folder), document.where(kKind)};
  std::visit(GiveTitle{title}, read.task);
  document.finish();
  return read;
}

}  // namespace

tl::expected<Table, Faults> read_text(std::string_view text) {
  if (text.size() > kMostBytes) {
    return refusal(fmt::format("the text has {} bytes; at most 8 MiB are allowed", text.size()));
  }
  if (const auto fault = check_is_text(text)) return tl::unexpected(Faults{*fault});
  if (is_blank(text)) {
    return refusal(fmt::format("the file is empty; a problem begins with kind = one of {}",
                               quoted_list(kTaskKinds)));
  }
  if (const auto fault = check_key_depth(text)) return tl::unexpected(Faults{*fault});
  auto table = parse_document(text);
  if (!table) return tl::unexpected(Faults{table.error()});
  return *std::move(table);
}

tl::expected<PlacedTask, Faults> read_task(const Table& document, const Folder& folder) {
  FaultList faults;
  TableReader reader(document, faults);
  if (is_study(document)) {
    fault_study(reader);
    return tl::unexpected(std::move(faults).sorted());
  }
  auto read = read_document(reader, folder);
  if (!faults.empty() || !read) return tl::unexpected(std::move(faults).sorted());
  return *std::move(read);
}

bool is_study(const Table& document) {
  const auto kind = std::ranges::find(document, kKind, &Entry::key);
  if (kind == document.end())
    return std::ranges::find(document, kBase, &Entry::key) != document.end();
  const auto* word = std::get_if<std::string>(&kind->node.value);
  return word && *word == kStudyKind;
}

}  // namespace cognate::problems::reading
