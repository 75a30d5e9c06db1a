/// Prints, as a Markdown table, what every published problem reaches by default settings beside
/// what was published. Usage: records [seeds [part of a problem's name]].
#include "tests/oracle/records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/lanes/path_screen.hpp"

namespace cognate {
namespace {

/// Degrees where the largest error counts.
std::string shown(const Record& record, double error) {
  if (record.exact) return fmt::format("{:.0e}", error);
  return record.largest ? fmt::format("{:.9g}°", error * 180 / kPi) : fmt::format("{:.9g}", error);
}

struct Row {
  std::string error;
  int reached = 0;
  double median_seconds = 0, worst_seconds = 0;
};

Row measure(const Record& record, int seeds) {
  Row row;
  double worst = 0;
  std::vector<double> seconds;
  for (int seed = 1; seed <= seeds; ++seed) {
    const problems::Run run{.seed = static_cast<std::uint64_t>(seed)};
    const auto result = std::visit([&](const auto& p) { return solve(p, run); }, record.problem);
    seconds.push_back(result.work.seconds);
    if (result.status != problems::Status::solved) continue;
    const double error = recorded_error(record, result.designs.front());
    worst = std::max(worst, error);
    row.reached += reaches(record, error);
  }
  std::sort(seconds.begin(), seconds.end());
  row.median_seconds = seconds[seconds.size() / 2];
  row.worst_seconds = seconds.back();
  row.error = shown(record, worst);
  return row;
}

std::string published(const Record& record) {
  std::string text;
  for (const PublishedError& entry : record.published) {
    text += text.empty() ? "" : "; ";
    text += fmt::format("{:.4g} ({}", entry.error, entry.method);
    text += entry.evaluations ? fmt::format(", {} evaluations)", *entry.evaluations) : ")";
  }
  return text.empty() ? "–" : text;
}

/// The problems whose name contains `part`.
void print(int seeds, std::string_view part) {
  fmt::print(
      "# Published problems\n\n"
      "What `build/release/tests/records {}` printed: sums of squares (largest errors where they\n"
      "are in degrees), the worst of {} seeds by default settings, on {} threads ({}). Reached "
      "are\n"
      "seeds that end within 1e-6 of the best known error, of exact ones within rounding of 0.\n\n",
      seeds, seeds, std::thread::hardware_concurrency(), synthesis::screen_instruction_set());
  fmt::print(
      "| problem | source | best known | Cognate | reached | median s | worst s | "
      "published |\n");
  fmt::print("|---|---|---|---|---|---|---|---|\n");
  for (const Record& record : read_records()) {
    if (record.name.find(part) == std::string::npos) continue;
    const Row row = measure(record, seeds);
    fmt::print("| {} | {} | {} | {} | {}/{} | {:.2f} | {:.2f} | {} |\n", record.name, record.source,
               record.exact ? "0" : shown(record, record.best_known), row.error, row.reached, seeds,
               row.median_seconds, row.worst_seconds, published(record));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace cognate

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
  if (seeds < 1) {
    fmt::print(stderr,
               "usage: records [seeds [part of a name]]; seeds is a whole number from 1 on\n");
    return 2;
  }
  cognate::print(seeds, argc > 2 ? argv[2] : "");
}
