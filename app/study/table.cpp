#include <fmt/core.h>

#include <variant>

#include "app/console/messages.hpp"
#include "app/console/paint.hpp"
#include "app/console/rate_estimate.hpp"
#include "app/console/text_table.hpp"
#include "app/study/metrics.hpp"
#include "app/study/summary.hpp"

namespace cognate::app {
namespace {

std::string counted_designs(std::int64_t count) {
  return grouped(count) + (count == 1 ? " design" : " designs");
}

std::string end_words(const problems::Study& study, const StudySummary& summary) {
  const auto of = fmt::format("{} of {}", grouped(summary.counts.evaluated),
                              counted_designs(problems::design_count(study)));
  const auto kept = fmt::format("{} kept", grouped(summary.counts.kept));
  switch (summary.end) {
    case StudyEnd::interrupted:
      return fmt::format("interrupted: {} evaluated, {}", of, kept);
    case StudyEnd::time_limit:
      return fmt::format("stopped at the time limit: {} evaluated, {}", of, kept);
    default:
      return fmt::format("done: {} evaluated, {}", counted_designs(summary.counts.evaluated), kept);
  }
}

Colour end_colour(const StudySummary& summary) {
  if (summary.counts.kept == 0) return Colour::red;
  return summary.end == StudyEnd::done ? Colour::green : Colour::yellow;
}

/// "12 filtered, 3 infeasible": what came out otherwise than solved.
std::string counts_words(const StudyCounts& counts) {
  std::string text;
  const auto add = [&](std::int64_t count, const char* what) {
    if (count > 0) text += (text.empty() ? "" : ", ") + fmt::format("{} {}", grouped(count), what);
  };
  add(counts.filtered, "did not pass the filters");
  add(counts.infeasible, "infeasible");
  add(counts.no_solution, "without solution");
  add(counts.invalid, "refused as input");
  return text;
}

std::string cell_text(const problems::Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.6g}", *number);
  if (const auto* word = std::get_if<std::string>(&cell)) return printable(*word);
  return "–";
}

Column column_of(const StudyRows& rows, std::size_t index) {
  const auto width = rows.columns.size();
  const auto& name = rows.columns[index];
  const auto unit = metric_unit(name);
  Column column{.heading = printable(name) + (unit.empty() ? "" : " [" + unit + "]"),
                .align = Align::right};
  for (std::size_t row = 0; row < rows.ids.size(); ++row) {
    const auto& cell = rows.cells[row * width + index];
    if (std::holds_alternative<std::string>(cell)) column.align = Align::left;
    column.cells.push_back(cell_text(cell));
  }
  return column;
}

std::string best_table(const problems::Study& study, const StudyRows& rows, const Screen& screen) {
  if (rows.ids.empty()) return "";
  std::vector<Column> columns{{.heading = "row", .align = Align::right}};
  for (const auto id : rows.ids) columns[0].cells.push_back(fmt::format("{}", id));
  for (std::size_t i = 0; i < rows.columns.size(); ++i) columns.push_back(column_of(rows, i));
  std::string text = study.objectives.size() > 1
                         ? "\nOn the Pareto front, in the order of the first objective:"
                         : "\nThe best:";
  return text + table_text(columns, screen);
}

}  // namespace

std::string describe_study(const problems::Study& study) {
  std::string varied;
  for (const auto& variable : study.variables) {
    varied += (varied.empty() ? "" : ", ") + variable.key;
  }
  return printable(fmt::format("{}: {} of {}, {} varied",
                               study.title.empty() ? "study" : study.title,
                               counted_designs(problems::design_count(study)), study.base, varied));
}

std::string study_table(const problems::Study& study, const StudySummary& summary,
                        const Screen& screen) {
  auto text = paint(describe_study(study), Colour::bold, screen.colour) + '\n';
  text += paint(end_words(study, summary), end_colour(summary), screen.colour) + '\n';
  const auto counts = counts_words(summary.counts);
  if (!counts.empty()) text += counts + '\n';
  text += best_table(study, summary.best, screen);
  for (const auto& note : summary.notes) text += "note: " + printable(note) + '\n';
  if (summary.evaluated == 0) return text;
  const double rate = static_cast<double>(summary.evaluated) / summary.seconds;
  return text + fmt::format("\n{:.3g} s on {} thread{}, {:.3g} designs/s\n", summary.seconds,
                            summary.threads, summary.threads == 1 ? "" : "s", rate);
}

}  // namespace cognate::app
