// What a user of the library can get wrong: every problem is either refused with faults or solved.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "problems/cam/result.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/gear/result.hpp"
#include "problems/linkage/result.hpp"
#include "problems/machine/result.hpp"
#include "problems/read.hpp"
#include "problems/train/result.hpp"
#include "tests/support/folders.hpp"
#include "tests/unit/library/corruption.hpp"

namespace cognate::problems::validate_test {
namespace {

std::vector<std::filesystem::path> worked_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kLibraryFolder)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Every problem of the library, one after the other.
template <class Use>
void for_each_worked_problem(const Use& use) {
  for (const auto& file : worked_files()) {
    SCOPED_TRACE(file.filename().string());
    if (const auto task = read_task(file)) std::visit(use, *task);  // a study is none
  }
}

/// The numbers of a file: where each begins, and its length.
std::vector<std::pair<std::size_t, std::size_t>> numbers_of(const std::string& text) {
  constexpr std::string_view kDigits = "0123456789.";
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t at = text.find_first_of(kDigits); at != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_not_of(kDigits, at), text.size());
    all.emplace_back(at, end - at);
    at = text.find_first_of(kDigits, end);
  }
  return all;
}

Result answer(const PathProblem& p, const Run& run) {
  return solve(p, run);
}
Result answer(const ChainPathProblem& p, const Run& run) {
  return solve(p, run);
}
Result answer(const ChainFunctionProblem& p, const Run& run) {
  return solve(p, run);
}
Result answer(const ChainMotionProblem& p, const Run& run) {
  return solve(p, run);
}
Result answer(const DwellProblem& p, const Run& run) {
  return solve(p, run);
}
Result answer(const LegProblem& p, const Run& run) {
  return solve(p, run);
}
Result answer(const FunctionProblem& p, const Run& run) {
  return solve(p, run);
}
Result answer(const MotionProblem& p, const Run& run) {
  return solve(p, run);
}
Result answer(const QuickReturnProblem& p, const Run& run) {
  return solve(p, run);
}
Result answer(const StraightLineProblem& p, const Run& run) {
  return solve(p, run);
}
CamResult answer(const CamProblem& p, const Run& run) {
  return solve(p, run);
}
GearPairResult answer(const GearPairProblem& p, const Run& run) {
  return solve(p, run);
}
GearTrainResult answer(const GearTrainProblem& p, const Run& run) {
  return solve(p, run);
}
GearResult answer(const GearProblem& p, const Run& run) {
  return analyse(p, run);
}
AnalysisResult answer(const AnalysisProblem& p, const Run& run) {
  return analyse(p, run);
}
MachineResult answer(const MachineProblem& p, const Run& run) {
  return run_machine(p, run);
}

/// Whether every four-bar found has dimensions that are numbers.
bool is_finite(const Result& result) {
  return std::ranges::all_of(result.designs, [](const Design& design) {
    if (!design.mechanism.four_bar()) return true;
    const FourBar& f = four_bar(design);
    const double all[] = {f.pivot_a.x, f.pivot_a.y, f.pivot_d.x, f.pivot_d.y,
                          f.crank,     f.coupler,   f.rocker};
    return std::ranges::all_of(all, [](double x) { return std::isfinite(x); });
  });
}
bool is_finite(const CamResult& result) {
  return std::ranges::all_of(result.designs, [](const CamDesign& design) {
    return std::isfinite(design.cam.system.follower.dimensions.base_radius);
  });
}
template <class Other>
bool is_finite(const Other&) {
  return true;
}

/// Problems that would exceed any time limit.
bool is_short(const AnalysisProblem& p) {
  return p.drive.steps <= 1000;
}
bool is_short(const MachineProblem& p) {
  return p.run.steps <= 1000;
}
template <class Other>
bool is_short(const Other&) {
  return true;
}

TEST(Validate, EveryWorkedProblemIsValid) {
  int count = 0;
  for_each_worked_problem([&](const auto& problem) {
    for (const std::string& fault : validate(problem)) ADD_FAILURE() << fault;
    ++count;
  });
  EXPECT_GT(count, 50);
}

TEST(Validate, WhatIsReadIsValid) {
  constexpr int kEach = 20;
  constexpr std::string_view kNumbers[] = {
      "0", "1", "2", "0.5", "1e-3", "90", "180", "7.3", "1e29", "1e-29", "33.3333333333333"};
  std::mt19937_64 random(11);
  int accepted = 0;
  for (const auto& file : worked_files()) {
    SCOPED_TRACE(file.filename().string());
    std::ifstream stream(file);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const auto numbers = numbers_of(text);
    for (int i = 0; i < kEach; ++i) {
      const auto& [at, length] = numbers[random() % numbers.size()];
      std::string changed = text;
      changed.replace(at, length, kNumbers[random() % std::size(kNumbers)]);
      const auto task = parse_task(changed);
      if (!task) continue;
      ++accepted;
      const auto check = [&](const auto& problem) {
        for (const std::string& fault : validate(problem)) ADD_FAILURE() << fault << changed;
      };
      std::visit(check, *task);
    }
  }
  EXPECT_GT(accepted, 1000);
}

TEST(Validate, SaysWhatTheReaderSays) {
  const auto read = parse_task(
      "kind = 'path-generation'\n[target]\npoints = [[0, 0], [1, 2], [3, 1]]\n"
      "timing = 'prescribed'\ncrank_deg = [0, 40]\n[mechanism]\ncrank = -1\n");
  ASSERT_FALSE(read);
  PathProblem problem;
  problem.points = {{0, 0}, {1, 2}, {3, 1}};
  problem.timing = Timing::prescribed;
  problem.crank_angles = {0, 0.7};
  problem.given.crank = -1;
  const auto faults = validate(problem);
  ASSERT_EQ(faults.size(), read.error().size());
  for (const Fault& fault : read.error()) {
    EXPECT_EQ(std::ranges::count(faults, fault.message), 1) << fault.message;
  }
  const Result result = solve(problem, {});
  EXPECT_EQ(result.status, Status::invalid);
  EXPECT_TRUE(result.designs.empty());
  EXPECT_EQ(result.notes, faults);
}

TEST(Validate, ReportsWhatNoFileCanSay) {
  FunctionProblem function;
  EXPECT_EQ(validate(function),
            std::vector<std::string>{
                "target has no function y(x); expected one in addition to its text or table"});
  PathProblem path;
  path.points = {{0, 0}, {1, 2}, {3, 1}};
  path.timing = Timing::mixed;
  path.crank_angles = {0, 1, 2};
  EXPECT_EQ(validate(path).front(),
            "has_crank_angle has 0 entries for 3 points; expected one for each point");
}

TEST(Validate, FillsInWhatAFileMayLeaveOut) {
  FunctionProblem problem;
  FunctionOfX square;
  square.y = [](double x) { return x * x; };
  square.domain = {0, 1};
  square.input_range = 1.0;
  square.output_range = 1.0;
  problem.target = square;
  problem.solve.starts = 20;
  EXPECT_TRUE(validate(problem).empty());
  const Result result = solve(problem, {});
  EXPECT_EQ(result.status, Status::solved);
  ASSERT_FALSE(result.designs.empty());
  EXPECT_LT(result.designs.front().error.rms, 0.01);
}

TEST(Validate, CorruptedProblemsAreRefusedOrAnswered) {
  constexpr int kEach = 60, kAnswered = 20;
  std::mt19937_64 random(7);
  int valid = 0, refused = 0, answered = 0;
  for_each_worked_problem([&](const auto& problem) {
    auto copy = problem;
    Corruption none(SIZE_MAX, random);
    show(none, copy);
    for (int i = 0; i < kEach; ++i) {
      auto spoilt = problem;
      Corruption corruption(random() % none.count(), random);
      show(corruption, spoilt);
      const auto faults = validate(spoilt);
      if (!faults.empty()) {
        ++refused;
        using Spoilt = std::decay_t<decltype(spoilt)>;
        if constexpr (!std::is_same_v<Spoilt, AnalysisProblem>) {  // analyse checks nothing
          if (i % kAnswered == 0) {
            EXPECT_EQ(answer(spoilt, {}).notes, faults);
          }
        }
        continue;
      }
      if (++valid % kAnswered != 0 || !is_short(spoilt)) continue;
      problems::Run run;
      run.threads = 1;
      run.time_limit = 0.02;
      EXPECT_TRUE(is_finite(answer(spoilt, run)));
      ++answered;
    }
  });
  std::printf("%d refused, %d valid, of which %d answered\n", refused, valid, answered);
  EXPECT_GT(refused, 1000);
  EXPECT_GT(valid, 1000);
}

}  // namespace
}  // namespace cognate::problems::validate_test
