/// Prints, as a Markdown table, what every published problem reaches by default settings beside
/// what was published. Usage: records [seeds].
#include "tests/oracle/records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <thread>
#include <vector>

#include "problems/read.hpp"
#include "problems/result.hpp"
#include "synthesis/search/path_screen.hpp"

namespace cognate {
namespace {

struct Row {
  std::string error;
  int reached = 0;
  double median_seconds = 0, worst_seconds = 0;
};

double squared_size(const problems::Problem& problem) {
  const auto* path = std::get_if<problems::PathProblem>(&problem);
  if (!path) return 1;
  Vec2d centre{};
  const double share = 1.0 / double(path->points.size());
  for (const Vec2d& p : path->points) centre = centre + share * p;
  double squares = 0;
  for (const Vec2d& p : path->points) squares += share * squared_norm(p - centre);
  return squares;
}

Row measure(const Record& record, int seeds) {
  const auto problem = problems::read_problem(record.file);
  if (!problem) throw std::runtime_error(record.file.string() + " cannot be read");
  Row row;
  double worst = 0;
  std::vector<double> seconds;
  for (int seed = 1; seed <= seeds; ++seed) {
    const problems::Run run{.seed = static_cast<std::uint64_t>(seed)};
    const auto result = std::visit([&](const auto& p) { return solve(p, run); }, *problem);
    seconds.push_back(result.work.seconds);
    if (result.status != problems::Status::solved) continue;
    const double error = result.designs.front().error.sum_of_squares;
    worst = std::max(worst, error);
    row.reached += reaches(record, error, squared_size(*problem));
  }
  std::sort(seconds.begin(), seconds.end());
  row.median_seconds = seconds[seconds.size() / 2];
  row.worst_seconds = seconds.back();
  row.error = record.exact ? fmt::format("{:.0e}", worst) : fmt::format("{:.9g}", worst);
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

void print(int seeds) {
  fmt::print("Sums of squares, the worst of {} seeds, on {} threads ({}).\n\n", seeds,
             std::thread::hardware_concurrency(), synthesis::screen_instruction_set());
  fmt::print("| problem | source | Cognate | reached | median s | worst s | published |\n");
  fmt::print("|---|---|---|---|---|---|---|\n");
  for (const Record& record : read_records()) {
    const Row row = measure(record, seeds);
    fmt::print("| `{}` | {} | {} | {}/{} | {:.2f} | {:.2f} | {} |\n", record.file.stem().string(),
               record.source, row.error, row.reached, seeds, row.median_seconds, row.worst_seconds,
               published(record));
  }
}

}  // namespace
}  // namespace cognate

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
  if (seeds < 1) {
    fmt::print(stderr, "usage: records [seeds]; seeds is a whole number from 1 on\n");
    return 2;
  }
  cognate::print(seeds);
}
