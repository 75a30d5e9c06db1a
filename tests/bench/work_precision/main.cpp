/// How precise each solver is after how much work, on the library's problems of each kind.
///
///     work_precision [--seconds S] [--seeds N] [--csv FILE] [PROBLEM...]
///
/// Every solver is started again and again, from starts of each strategy, until its seconds are
/// spent; `auto` is the program's own search with 1, 2, 4, … starts. All run on one thread. Prints
/// a Markdown table, and writes every improvement as comma-separated values: seconds and the excess
/// of the best design's error over the least known (of the target's squared size, where that is 0).
/// plot_work_precision.py draws them.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>

#include "problems/basics/names.hpp"
#include "problems/read.hpp"
#include "problems/search/solver_origin.hpp"
#include "synthesis/optimise/solver.hpp"
#include "tests/bench/work_precision/contest.hpp"
#include "tests/oracle/records.hpp"
#include "tests/support/folders.hpp"

namespace cognate::bench {
namespace {

using Clock = std::chrono::steady_clock;
using synthesis::Solver;

constexpr double kNone = std::numeric_limits<double>::infinity();
/// What counts as having reached the least error known.
constexpr double kReached = 1e-6;

struct Settings {
  double seconds = 1;
  int seeds = 3;
  std::string csv;
  std::vector<std::string> problems;
};

struct Improvement {
  double seconds, error;
};

/// One solver with one strategy on one problem, for each seed its improvements.
struct History {
  std::string solver, starts;
  std::vector<std::vector<Improvement>> seeds;

  double least() const {
    double least = kNone;
    for (const auto& seed : seeds) {
      if (!seed.empty()) least = std::min(least, seed.back().error);
    }
    return least;
  }
};

double spent(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void note(std::vector<Improvement>& history, double seconds, double error) {
  if (std::isfinite(error) && (history.empty() || error < history.back().error)) {
    history.push_back({seconds, error});
  }
}

std::vector<Improvement> race(const Contest& contest, synthesis::Solver solver, Starts how,
                              std::uint64_t seed, double seconds) {
  constexpr int kIterations = 1000;
  std::vector<Improvement> history;
  std::mt19937_64 random(seed);
  const auto begin = Clock::now();
  const Draw draw = contest.begin(how);
  while (spent(begin) < seconds) {
    const auto attempt = draw(random);
    if (!attempt) continue;
    if (!can_solve(solver, *attempt->model)) return {};
    const auto solution = solve(solver, *attempt->model, attempt->start,
                                {.tolerance = 1e-13,
                                 .max_iterations = kIterations,
                                 .time_limit = seconds - spent(begin),
                                 .seed = seed});
    note(history, spent(begin), attempt->error(solution.x));
  }
  return history;
}

std::vector<Improvement> race_of_auto(const Contest& contest, std::uint64_t seed, double seconds) {
  std::vector<Improvement> history;
  double last = 0;
  for (int starts = 1; last < 0.5 * seconds; starts *= 2) {
    const auto begin = Clock::now();
    const double error = contest.solve(starts, {.seed = seed, .threads = 1});
    last = spent(begin);
    note(history, last, error);
  }
  return history;
}

std::vector<History> run(const Contest& contest, const Settings& settings) {
  std::vector<History> histories;
  for (const auto& [name, solver] : problems::names<synthesis::Solver>()) {
    for (const auto how : {Starts::screened, Starts::random}) {
      const bool automatic = solver == synthesis::Solver::automatic;
      if (automatic && how == Starts::random) continue;
      History history{std::string(name), how == Starts::random ? "random" : "screened", {}};
      for (int seed = 1; seed <= settings.seeds; ++seed) {
        history.seeds.push_back(automatic ? race_of_auto(contest, seed, settings.seconds)
                                          : race(contest, solver, how, seed, settings.seconds));
      }
      if (std::isfinite(history.least())) histories.push_back(std::move(history));
    }
  }
  return histories;
}

/// Errors as excess over the least known, in the unit where that is 0.
void make_relative(const Contest& contest, std::vector<History>& histories) {
  double best = contest.best_known.value_or(kNone);
  if (!contest.best_known) {
    for (const History& history : histories) best = std::min(best, history.least());
  }
  const double unit = best > 0 ? best : contest.unit;
  for (History& history : histories) {
    for (auto& seed : history.seeds) {
      for (Improvement& improvement : seed) improvement.error = (improvement.error - best) / unit;
    }
  }
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

void print_row(const Contest& contest, const History& history) {
  std::vector<double> times, ends;
  for (const auto& seed : history.seeds) {
    const auto reached =
        std::ranges::find_if(seed, [](const Improvement& at) { return at.error <= kReached; });
    times.push_back(reached == seed.end() ? kNone : reached->seconds);
    ends.push_back(seed.empty() ? kNone : std::max(seed.back().error, 0.0));
  }
  const double time = median(times);
  fmt::print("| {} | {} | {} | {} | {:.1e} |\n", contest.name, history.solver, history.starts,
             std::isfinite(time) ? fmt::format("{:.3f}", time) : "–", median(ends));
}

std::vector<Contest> contests(const Settings& settings) {
  std::vector<Contest> all;
  const auto wanted = [&](const std::string& name) {
    return settings.problems.empty() ||
           std::ranges::find(settings.problems, name) != settings.problems.end();
  };
  for (const Record& record : read_records()) {
    // Variants and the many functions of one kind only where they are requested.
    const bool is_one_of_many =
        record.name.find('(') != record.name.npos || record.source == "classical";
    if (!wanted(record.name) || (is_one_of_many && settings.problems.empty())) continue;
    if (const auto* path = std::get_if<problems::PathProblem>(&record.problem)) {
      all.push_back(path_contest(*path, record.name));
    } else if (const auto* function = std::get_if<problems::FunctionProblem>(&record.problem)) {
      all.push_back(function_contest(*function, record.name));
    } else {
      continue;
    }
    all.back().best_known = record.best_known;
  }
  const std::filesystem::path logarithm =
      std::filesystem::path(kLibraryFolder) / "function/log10-refined.toml";
  const auto problem = problems::read_task(logarithm);
  for (const bool minimax : {false, true}) {
    if (!problem) break;
    auto function = std::get<problems::FunctionProblem>(*problem);
    if (minimax) function.objective = problems::FunctionObjective::minimax;
    const std::string name = minimax ? "log10-minimax" : "log10-refined";
    if (wanted(name)) all.push_back(function_contest(function, name));
  }
  return all;
}

int run_all(const Settings& settings) {
  std::ofstream csv;
  if (!settings.csv.empty()) csv.open(settings.csv);
  csv << "problem,kind,solver,starts,seed,seconds,excess\n";
  fmt::print("| problem | solver | starts | s to {} | excess at the end |\n|---|---|---|---|---|\n",
             kReached);
  for (const Contest& contest : contests(settings)) {
    std::vector<History> histories = run(contest, settings);
    make_relative(contest, histories);
    for (const History& history : histories) {
      print_row(contest, history);
      for (std::size_t seed = 0; seed < history.seeds.size(); ++seed) {
        for (const Improvement& at : history.seeds[seed]) {
          csv << fmt::format("{},\"{}\",{},{},{},{:.6f},{:.6e}\n", contest.name, contest.kind,
                             history.solver, history.starts, seed + 1, at.seconds, at.error);
        }
      }
    }
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace cognate::bench

int main(int argc, char** argv) {
  CLI::App app("Run time against error of every solver and strategy of starts");
  cognate::bench::Settings settings;
  app.add_option("--seconds", settings.seconds, "For each solver, strategy and seed")
      ->check(CLI::PositiveNumber);
  app.add_option("--seeds", settings.seeds, "How often each is run")->check(CLI::PositiveNumber);
  app.add_option("--csv", settings.csv, "Where to write every improvement");
  app.add_option("problems", settings.problems, "Files of the library by their stems; default all");
  CLI11_PARSE(app, argc, argv);
  return cognate::bench::run_all(settings);
}
