#include "app/commands/problem_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "app/commands/task_computation.hpp"
#include "app/kinds/kinds.hpp"
#include "app/study/metrics.hpp"
#include "problems/task_document.hpp"

namespace cognate::app {
namespace {

using problems::TaskAt;
using problems::TaskOrStudy;
using Faults = std::vector<problems::Fault>;
namespace reading = problems::reading;

struct Description {
  std::string operator()(const problems::Study& study) const {
    const auto plural = [](std::int64_t count, const char* of) {
      return fmt::format("{} {}{}", count, of, count == 1 ? "" : "s");
    };
    return fmt::format("a study of {}: {}, {}, {}", study.base,
                       plural(problems::design_count(study), "design"),
                       plural(std::ssize(study.variables), "variable"),
                       plural(std::ssize(study.metrics), "metric"));
  }
  std::string operator()(const problems::Task& task) const {
    return visit_kind(task, [](auto kind, const auto& problem) { return kind.describe(problem); });
  }
};

/// Where `kind` stands, else `base`, else the begin.
reading::Where place_of_kind(const reading::Table& document) {
  for (const std::string_view key : {reading::kKind, std::string_view("base")}) {
    const auto entry = std::ranges::find(document, key, &reading::Entry::key);
    if (entry != document.end()) return entry->where;
  }
  return {1, 1};
}

/// `document`, or the fault that it is a study, for which `why` is no good.
tl::expected<reading::Table, Faults> unless_study(reading::Table document, const char* why) {
  if (!reading::is_study(document)) return document;
  const auto where = place_of_kind(document);
  return tl::unexpected(Faults{{where.line, where.column, why}});
}

tl::expected<Computation, Faults> computation_of_task(TaskAt read, const Options& options) {
  std::string why = task_refusal(read.task, Command::solve);
  if (!why.empty() && !task_refusal(read.task, Command::analyze).empty()) {
    return tl::unexpected(Faults{{read.line, read.column, std::move(why)}});
  }
  return task_computation(std::move(read.task), options);
}

}  // namespace

tl::expected<TaskOrStudy, Faults> with_sound_files(TaskOrStudy read) {
  if (const auto* task = std::get_if<problems::Task>(&read)) {
    auto faults =
        visit_kind(*task, [](auto kind, const auto& problem) { return kind.faults(problem); });
    if (!faults.empty()) return tl::unexpected(std::move(faults));
  }
  return read;
}

std::string description(const TaskOrStudy& read) {
  return std::visit(Description{}, read);
}

tl::expected<std::string, Faults> check_text(std::string_view text,
                                             const std::filesystem::path& folder) {
  const auto whole = [&](const reading::Table&) {
    return problems::parse_task_or_study(text, folder, study_metrics);
  };
  const auto nameless = [&](reading::Table document) {
    constexpr const char* kWhy = "a study names a file beside it, but there is none; save it first";
    return folder.empty() ? unless_study(std::move(document), kWhy)
                          : tl::expected<reading::Table, Faults>(std::move(document));
  };
  return reading::read_text(text)
      .and_then(nameless)
      .and_then(whole)
      .and_then(with_sound_files)
      .map(description);
}

tl::expected<Computation, Faults> text_computation(std::string_view text,
                                                   const std::filesystem::path& folder,
                                                   const Options& options) {
  return reading::read_text(text)
      .and_then([](reading::Table document) {
        return unless_study(std::move(document),
                            "a study is run by 'cognate sweep', which keeps its rows in a file");
      })
      .and_then([&](const reading::Table& document) {
        return reading::with_length_unit(document, options.length_unit);
      })
      .and_then(
          [&](const reading::Table& document) { return reading::read_task(document, folder); })
      .and_then([&](TaskAt read) { return computation_of_task(std::move(read), options); });
}

}  // namespace cognate::app
