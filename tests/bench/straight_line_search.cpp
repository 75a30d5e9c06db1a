/// Prints, as a Markdown table, how surely and how fast straight lines are found: for each problem
/// and many seeds the best figure of all, the share of seeds that come within a thousandth of it,
/// and the median time to the end of the search. Usage: straight_line_search [seeds [threads]].
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems {
namespace {

constexpr double kNear = 1e-3;

double quantity(const Design& design, const std::string& name) {
  for (const Quantity& f : design.metrics.quantities) {
    if (f.name == name) return std::get<double>(f.value);
  }
  return 0;
}

struct Outcome {
  double figure = 1e300;
  double seconds = 0;
};

/// δ/L where it is minimised, else the size over the length.
Outcome run_once(const StraightLineProblem& problem, std::uint64_t seed, int threads) {
  Run run;
  run.seed = seed;
  run.threads = threads;
  const Result result = solve(problem, run);
  Outcome outcome{1e300, result.work.seconds};
  if (result.status != Status::solved) return outcome;
  const bool sized = problem.goal->deviation || problem.goal->deviation_relative;
  outcome.figure = quantity(result.designs[0], sized ? "size_over_length" : "deviation_relative");
  return outcome;
}

void report(const std::filesystem::path& file, int seeds, int threads) {
  const auto read = read_task(file);
  if (!read) return;
  const auto& problem = std::get<StraightLineProblem>(*read);
  std::vector<Outcome> all;
  for (int seed = 1; seed <= seeds; ++seed) {
    all.push_back(run_once(problem, static_cast<std::uint64_t>(seed), threads));
  }
  const double best = std::ranges::min(all, {}, &Outcome::figure).figure;
  const auto near = std::ranges::count_if(
      all, [&](const Outcome& one) { return one.figure <= best * (1 + kNear) + 1e-12; });
  std::ranges::sort(all, {}, &Outcome::seconds);
  fmt::print("| {} | {:.6g} | {} of {} | {:.2f} s |\n", file.stem().string(), best, near, seeds,
             all[all.size() / 2].seconds);
  std::fflush(stdout);
}

}  // namespace
}  // namespace cognate::problems

int main(int count, char** words) {
  const int seeds = count > 1 ? std::max(1, std::atoi(words[1])) : 20;
  const int threads = count > 2 ? std::max(1, std::atoi(words[2])) : 2;
  const auto library = std::filesystem::path(cognate::kLibraryFolder) / "straight-line";
  fmt::print("| problem | best figure | seeds within 0.1 % of it | median time |\n");
  fmt::print("|---|---|---|---|\n");
  for (const char* name : {"hoeken", "chebyshev", "roberts", "watt", "evans", "smallest"}) {
    cognate::problems::report(library / fmt::format("search-{}.toml", name), seeds, threads);
  }
}
