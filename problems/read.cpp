#include "problems/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "problems/reading/analysis_problem.hpp"
#include "problems/reading/cam_problem.hpp"
#include "problems/reading/document.hpp"
#include "problems/reading/function_problem.hpp"
#include "problems/reading/motion_problem.hpp"
#include "problems/reading/nearest.hpp"
#include "problems/reading/path_problem.hpp"
#include "problems/reading/quick_return_problem.hpp"
#include "problems/reading/straight_line_problem.hpp"
#include "problems/reading/table_reader.hpp"
#include "problems/reading/text_check.hpp"

namespace cognate::problems {
namespace {

using reading::FaultList;
using reading::TableReader;

using Faults = std::vector<Fault>;

// Where files beside the problem file are; empty where there is no such file.
using Folder = std::filesystem::path;

constexpr std::size_t kMostBytes = 8U << 20U;

// The kinds of design problems, then the other ones.
constexpr std::string_view kAvailableKinds[] = {"path-generation",   "function-generation",
                                                "motion-generation", "quick-return",
                                                "straight-line",     "cam",
                                                "analysis"};
constexpr std::string_view kLaterKinds[] = {"study"};

constexpr std::string_view kKind = "kind";

// What a file asks for, and where it says so.
struct Reading {
  Task task;
  reading::Where kind;
};

tl::unexpected<Faults> refusal(std::string message) {
  return tl::unexpected(Faults{{1, 1, std::move(message)}});
}

bool is_blank(std::string_view text) {
  return std::ranges::all_of(
      text, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
}

// The document's kind, one of kAvailableKinds; empty, with a fault, where it has none.
std::optional<std::string_view> read_kind(TableReader& document) {
  if (!document.has(kKind)) {
    document.fault(
        kKind, fmt::format("is missing; allowed are {}", reading::quoted_list(kAvailableKinds)));
    return std::nullopt;
  }
  const auto kind = document.text(kKind);
  if (!kind) return std::nullopt;
  const auto found = std::ranges::find(kAvailableKinds, *kind);
  if (found != std::end(kAvailableKinds)) return *found;
  if (std::ranges::find(kLaterKinds, *kind) != std::end(kLaterKinds)) {
    document.fault(kKind,
                   fmt::format("{} is not available in this version; available are {}",
                               reading::in_quotes(*kind), reading::quoted_list(kAvailableKinds)));
    return std::nullopt;
  }
  std::vector<std::string_view> known(std::begin(kAvailableKinds), std::end(kAvailableKinds));
  known.insert(known.end(), std::begin(kLaterKinds), std::end(kLaterKinds));
  const auto meant = reading::nearest(*kind, known);
  document.fault(kKind, fmt::format("is {}{}; available are {}", reading::in_quotes(*kind),
                                    meant ? ", perhaps for " + reading::in_quotes(*meant) : "",
                                    reading::quoted_list(kAvailableKinds)));
  return std::nullopt;
}

Problem read_design_problem(std::string_view kind, TableReader& document, const Folder& folder) {
  if (kind == "path-generation") return reading::read_path_problem(document, folder);
  if (kind == "motion-generation") return reading::read_motion_problem(document);
  if (kind == "quick-return") return reading::read_quick_return_problem(document);
  if (kind == "straight-line") return reading::read_straight_line_problem(document);
  return reading::read_function_problem(document);
}

std::optional<Reading> read_document(TableReader& document, const Folder& folder) {
  const auto kind = read_kind(document);
  const std::string title = document.text("title").value_or("");
  if (!kind) return std::nullopt;
  Reading read{{}, document.where(kKind)};
  if (*kind == "analysis") {
    AnalysisProblem problem = reading::read_analysis_problem(document);
    problem.title = title;
    read.task = std::move(problem);
  } else if (*kind == "cam") {
    CamProblem problem = reading::read_cam_problem(document);
    problem.title = title;
    read.task = std::move(problem);
  } else {
    Problem problem = read_design_problem(*kind, document, folder);
    std::visit([&](auto& any) { any.title = title; }, problem);
    read.task = std::move(problem);
  }
  document.finish();
  return read;
}

tl::expected<Reading, Faults> parse(std::string_view text, const Folder& folder = {}) {
  if (text.size() > kMostBytes) {
    return refusal(fmt::format("the text has {} bytes; at most 8 MiB are allowed", text.size()));
  }
  if (const auto fault = reading::check_is_text(text)) return tl::unexpected(Faults{*fault});
  if (is_blank(text)) {
    return refusal(fmt::format("the file is empty; a problem begins with kind = one of {}",
                               reading::quoted_list(kAvailableKinds)));
  }
  if (const auto fault = reading::check_key_depth(text)) return tl::unexpected(Faults{*fault});
  const auto table = reading::parse_document(text);
  if (!table) return tl::unexpected(Faults{table.error()});

  FaultList faults;
  TableReader document(*table, faults);
  auto read = read_document(document, folder);
  if (!faults.empty() || !read) return tl::unexpected(std::move(faults).sorted());
  return *std::move(read);
}

tl::expected<Task, Faults> any_task(Reading read) {
  return std::move(read.task);
}

// What is asked for where nothing of this kind was wanted: a fault at the file's `kind`.
template <class Wanted>
tl::expected<Wanted, Faults> only(Reading read, std::string_view wanted) {
  if (auto* task = std::get_if<Wanted>(&read.task)) return std::move(*task);
  constexpr std::string_view kAsked[] = {
      "is that of a design problem, which 'cognate solve' solves",
      "is \"analysis\": there is nothing to solve, 'cognate analyze' evaluates this mechanism",
      "is \"cam\": 'cognate solve' designs a cam, and evaluates one whose dimensions are all "
      "given"};
  return tl::unexpected(
      Faults{{read.kind.line, read.kind.column,
              fmt::format("kind {}; {} is wanted", kAsked[read.task.index()], wanted)}});
}

tl::expected<Problem, Faults> only_problem(Reading read) {
  return only<Problem>(std::move(read), "the design problem of a linkage");
}

tl::expected<AnalysisProblem, Faults> only_analysis(Reading read) {
  return only<AnalysisProblem>(std::move(read), "kind = \"analysis\" with a whole [mechanism]");
}

tl::expected<CamProblem, Faults> only_cam(Reading read) {
  return only<CamProblem>(std::move(read), "kind = \"cam\"");
}

tl::expected<std::string, Faults> text_of(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    return refusal(
        "the file does not exist or cannot be reached; the path of a problem file is wanted");
  }
  if (std::filesystem::is_directory(status)) {
    return refusal("this is a directory; the path of a problem file is wanted");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return refusal("the file cannot be opened; a file that can be read is wanted");
  // One byte more than allowed is enough to refuse, however large the file: a pipe has no size.
  std::string text(kMostBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) return refusal("the file cannot be read to its end; a whole file is wanted");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kMostBytes) {
    return refusal("the file is larger than 8 MiB; at most 8 MiB are allowed");
  }
  return text;
}

tl::expected<Reading, Faults> read(const std::filesystem::path& file) {
  std::error_code error;
  const auto folder = std::filesystem::absolute(file, error).parent_path();
  return text_of(file).and_then([&](const std::string& text) { return parse(text, folder); });
}

}  // namespace

tl::expected<Task, Faults> parse_task(std::string_view text) {
  return parse(text).and_then(any_task);
}

tl::expected<Problem, Faults> parse_problem(std::string_view text) {
  return parse(text).and_then(only_problem);
}

tl::expected<AnalysisProblem, Faults> parse_analysis(std::string_view text) {
  return parse(text).and_then(only_analysis);
}

tl::expected<CamProblem, Faults> parse_cam(std::string_view text) {
  return parse(text).and_then(only_cam);
}

tl::expected<Task, Faults> read_task(const std::filesystem::path& file) {
  return read(file).and_then(any_task);
}

tl::expected<Problem, Faults> read_problem(const std::filesystem::path& file) {
  return read(file).and_then(only_problem);
}

tl::expected<AnalysisProblem, Faults> read_analysis(const std::filesystem::path& file) {
  return read(file).and_then(only_analysis);
}

tl::expected<CamProblem, Faults> read_cam(const std::filesystem::path& file) {
  return read(file).and_then(only_cam);
}

}  // namespace cognate::problems
