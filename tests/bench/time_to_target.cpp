/// How long until a published problem is solved as well as anyone is known to have solved it.
///
///     time_to_target [--seeds N] [--threads N] [--csv FILE] [PROBLEM...]
///
/// Each problem is solved by default settings with the seeds 1, 2, … N on one thread; a run that
/// misses the record is followed by one with the next seed beyond N, and their times add up. With
/// --threads the same seeds run on so many threads too, in turn with those on one, and the last
/// column is the sum of the times on one over that on these. Prints a Markdown table, and writes
/// the seconds of each seed as comma-separated values, of which plot_time_to_target.py draws the
/// time-to-target plots (Aiex, Resende & Ribeiro 2007).
#include <fmt/core.h>
#include <fmt/os.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "problems/linkage/result.hpp"
#include "tests/oracle/records.hpp"

namespace cognate {
namespace {

/// Runs after which a problem counts as not solved.
constexpr int kMostRuns = 20;

struct Settings {
  int seeds = 100, threads = 1;
  std::string csv;
  std::vector<std::string> problems;
};

struct Tries {
  double seconds = 0;
  int runs = 0;
  bool reached = false;
};

/// `stride`: from the seed of a run that missed to that of the next.
Tries solve_until_reached(const Record& record, int seed, int threads, int stride) {
  Tries tries;
  for (; !tries.reached && tries.runs < kMostRuns; ++tries.runs) {
    const auto number = static_cast<std::uint64_t>(seed + tries.runs * stride);
    const problems::Run run{.seed = number, .threads = threads};
    const auto result =
        std::visit([&](const auto& problem) { return solve(problem, run); }, record.problem);
    tries.seconds += result.work.seconds;
    tries.reached = result.status == problems::Status::solved &&
                    reaches(record, recorded_error(record, result.designs.front()));
  }
  return tries;
}

double share(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * double(sorted.size() - 1))];
}

void measure(const Record& record, const Settings& settings, fmt::ostream* csv) {
  std::vector<double> alone, together;
  int first_runs = 0, missed = 0;
  for (int seed = 1; seed <= settings.seeds; ++seed) {
    const Tries one = solve_until_reached(record, seed, 1, settings.seeds);
    first_runs += one.reached && one.runs == 1;
    missed += !one.reached;
    alone.push_back(one.seconds);
    if (csv) {
      csv->print("\"{}\",{},{},{},{:.6f}\n", record.name, seed, one.runs, int(one.reached),
                 one.seconds);
    }
    if (settings.threads == 1) continue;
    together.push_back(solve_until_reached(record, seed, settings.threads, settings.seeds).seconds);
  }
  const auto sum = [](const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0);
  };
  const double gain = together.empty() ? 1 : sum(alone) / sum(together);
  std::ranges::sort(alone);
  fmt::print("| {} | {}/{} | {} | {:.3f} | {:.3f} | {:.3f} | {} |\n", record.name, first_runs,
             settings.seeds, missed, share(alone, 0.5), share(alone, 0.95), alone.back(),
             together.empty() ? "–" : fmt::format("{:.2f}", gain));
  std::fflush(stdout);
}

void measure_all(const Settings& settings) {
  std::optional<fmt::ostream> csv;
  if (!settings.csv.empty()) {
    csv.emplace(fmt::output_file(settings.csv));
    csv->print("problem,seed,runs,reached,seconds\n");
  }
  fmt::print("| problem | first run | never | median s | 95 % s | worst s | gain by {} threads |\n",
             settings.threads);
  fmt::print("|---|---|---|---|---|---|---|\n");
  for (const Record& record : read_records()) {
    const bool wanted =
        settings.problems.empty() ||
        std::ranges::find(settings.problems, record.name) != settings.problems.end();
    if (wanted) measure(record, settings, csv ? &*csv : nullptr);
  }
}

}  // namespace
}  // namespace cognate

int main(int argc, char** argv) {
  cognate::Settings settings;
  CLI::App app("Seconds until published problems are solved to their records");
  app.add_option("--seeds", settings.seeds, "so many seeds")->check(CLI::PositiveNumber);
  app.add_option("--threads", settings.threads, "compare with so many")->check(CLI::PositiveNumber);
  app.add_option("--csv", settings.csv, "write the seconds of each seed there");
  app.add_option("problems", settings.problems, "names of published problems (default: all)");
  CLI11_PARSE(app, argc, argv);
  cognate::measure_all(settings);
}
