// Studies of four-bars in batches against the analysis of each design by itself, whose curves are
// sampled in another way, and against their own filters applied afterwards.
#include "problems/study/four_bar_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "problems/evaluation/curve_metrics.hpp"
#include "problems/study/base.hpp"
#include "problems/study/design_points.hpp"

namespace cognate::problems::four_bar_study_test {
namespace {

constexpr const char* kBase = R"(
kind = "analysis"
[mechanism]
type = "four-bar"
fixed_pivots = [[0.5, -1.0], [3.5, 0.0]]
crank = 1.0
coupler = 3.0
rocker = 2.5
coupler_point = [1.0, 1.0]
[drive]
start_deg = 40
)";

StudyVariable varied(const std::string& key, KeyPath path, double from, double to) {
  StudyVariable variable;
  variable.key = key;
  variable.path = std::move(path);
  variable.range = Range{from, to};
  return variable;
}

std::vector<std::string> all_metrics() {
  std::vector<std::string> names = {"class",
                                    "change_point",
                                    "crank_turns_fully",
                                    "mobility",
                                    "moves_as",
                                    "output",
                                    "transmission_angle_deg.min",
                                    "transmission_angle_deg.max",
                                    "transmission_angle_deg.acute_min",
                                    "time_ratio",
                                    "output_swing_deg"};
  for (const CurveMetric& metric : curve_metrics()) names.emplace_back(metric.key);
  return names;
}

/// Five dimensions at random; a few cannot be assembled, a few are no linkages.
Study random_study(std::int64_t samples) {
  using namespace std::string_literals;
  Study study;
  study.base_text = kBase;
  study.variables = {varied("mechanism.crank", {"mechanism"s, "crank"s}, -0.1, 4),
                     varied("mechanism.coupler", {"mechanism"s, "coupler"s}, 0.3, 4),
                     varied("mechanism.rocker", {"mechanism"s, "rocker"s}, 0.3, 4),
                     varied("mechanism.fixed_pivots[1][1]",
                            {"mechanism"s, "fixed_pivots"s, std::size_t{1}, std::size_t{1}}, -3, 1),
                     varied("mechanism.coupler_point[0]",
                            {"mechanism"s, "coupler_point"s, std::size_t{0}}, -1, 3)};
  study.sampling = Sampling::random;
  study.samples = samples;
  study.metrics = all_metrics();
  return study;
}

/// Whole numbers, among which are change points of every kind.
Study grid_study() {
  using namespace std::string_literals;
  Study study;
  study.base_text = kBase;
  study.variables = {
      {.key = "mechanism.crank", .path = {"mechanism"s, "crank"s}},
      {.key = "mechanism.coupler", .path = {"mechanism"s, "coupler"s}},
      {.key = "mechanism.rocker", .path = {"mechanism"s, "rocker"s}},
      {.key = "d", .path = {"mechanism"s, "fixed_pivots"s, std::size_t{1}, std::size_t{1}}}};
  for (auto& variable : study.variables) variable.values = {1, 2, 3};
  study.variables.back().values = {-1};  // the frame is 3 long
  study.metrics = all_metrics();
  return study;
}

StudyBlock evaluate(const Study& study, std::int64_t first, std::int64_t count) {
  const auto evaluator = four_bar_evaluator(study, 3, nullptr);
  EXPECT_TRUE(evaluator.has_value());
  return evaluator ? (*evaluator)(first, count).value() : StudyBlock{};
}

std::string text(const Cell& cell) {
  const auto* const word = std::get_if<std::string>(&cell);
  return word ? *word : std::holds_alternative<double>(cell) ? "a number" : "nothing";
}

/// How near a value has to be: angles at dead points go with the root of roundings, lengths of
/// curves hold 1e-9, what is sampled of them a little less.
double tolerance(const std::string& name, double value) {
  const double relative = name.starts_with("fourier_phase") ? 1e-3 : 1e-6;
  return relative * std::max(std::abs(value), 1.0) + (name.ends_with("_deg.min") ? 1e-5 : 0);
}

void expect_equal(const std::string& name, const Cell& cell,
                  const std::variant<double, std::string, bool>& quantity, std::int64_t id) {
  if (const auto* const truth = std::get_if<bool>(&quantity)) {
    EXPECT_EQ(text(cell), *truth ? "true" : "false") << name << " of " << id;
  } else if (const auto* const word = std::get_if<std::string>(&quantity)) {
    EXPECT_EQ(text(cell), *word) << name << " of " << id;
  } else {
    const double expected = std::get<double>(quantity);
    ASSERT_EQ(text(cell), "a number") << name << " of " << id << ", which is " << expected;
    double value = std::get<double>(cell);
    if (name.starts_with("fourier_phase")) {
      value = expected + std::remainder(value - expected, 360);
    }
    EXPECT_NEAR(value, expected, tolerance(name, expected)) << name << " of " << id;
  }
}

/// Holds every row against `analyse`; returns how many designs came out in which way.
std::map<std::string, int> compare(const Study& study, const StudyBlock& block) {
  std::map<std::string, int> seen;
  StudyBase base(study);
  DesignPoints points(study, 3);
  const std::size_t variables = study.variables.size();
  const std::size_t columns = variables + study.metrics.size();
  EXPECT_EQ(block.cells.size(), block.ids.size() * columns);
  std::vector<double> values(variables);
  for (std::size_t row = 0; row < block.ids.size(); ++row) {
    const std::int64_t id = block.ids[row];
    points.fill(id, values);
    const auto task = base.with(values);
    if (!task) {
      EXPECT_EQ(block.statuses[row], RunStatus::invalid);
      ++seen["invalid"];
      continue;
    }
    auto problem = std::get<AnalysisProblem>(*task);
    problem.output.curve = true;
    const auto result = analyse(problem, Run{.threads = 1});
    const bool solved = result.status == Status::solved;
    EXPECT_EQ(block.statuses[row], solved ? RunStatus::solved : RunStatus::no_solution) << id;
    for (std::size_t k = 0; k < study.metrics.size(); ++k) {
      const std::string& name = study.metrics[k];
      const Cell& cell = block.cells[row * columns + variables + k];
      const auto quantity = std::ranges::find(result.quantities, name, &Quantity::name);
      if (!solved || quantity == result.quantities.end()) {
        EXPECT_EQ(text(cell), "nothing") << name << " of " << id;
      } else {
        expect_equal(name, cell, quantity->value, id);
        if (name == "class") ++seen[text(cell)];
        if (name == "change_point") ++seen["change point " + text(cell)];
      }
    }
    if (!solved) ++seen["not assembled"];
  }
  return seen;
}

TEST(FourBarStudy, RandomDesignsAreAsAnalysisHasThem) {
  const Study study = random_study(300);
  const StudyBlock block = evaluate(study, 0, 300);
  EXPECT_EQ(block.ids.size(), 300U);
  auto seen = compare(study, block);
  for (const char* kind : {"invalid", "not assembled", "crank-rocker", "double-crank",
                           "rocker-crank", "double-rocker", "triple-rocker"}) {
    EXPECT_GT(seen[kind], 2) << kind;
  }
}

// Of cranks that do not turn fully the drive's rows may miss the range, or all but one may.
TEST(FourBarStudy, RowsOfTheDriveAreAsAnalysisHasThem) {
  for (const char* drive : {"start_deg = 4000", "start_deg = 10\nend_deg = 3790\nsteps = 3",
                            "start_deg = 90\nend_deg = -3600\nsteps = 4"}) {
    Study study = random_study(100);
    study.base_text.replace(study.base_text.find("start_deg = 40"), 14, drive);
    study.metrics = {"class", "crank_turns_fully"};
    const auto seen = compare(study, evaluate(study, 0, 100));
    EXPECT_GT(seen.at("double-rocker"), 2) << drive;
    EXPECT_GT(seen.at("not assembled"), 2) << drive;
  }
}

TEST(FourBarStudy, ChangePointsAreAsAnalysisHasThem) {
  Study study = grid_study();
  study.variables.back().values = {-1};
  auto text = study.base_text;
  text.replace(text.find("[3.5, 0.0]"), 10, "[3.5, -1.0]");
  study.base_text = text;
  const StudyBlock block = evaluate(study, 0, 27);
  auto seen = compare(study, block);
  EXPECT_GT(seen["change point true"], 8);
  EXPECT_GT(seen["change point false"], 4);
}

StudyFilter at_least(const std::string& name, double min) {
  StudyFilter filter;
  filter.name = name;
  filter.min = min;
  return filter;
}

bool passes(const StudyFilter& filter, const Cell& cell) {
  if (const auto* const number = std::get_if<double>(&cell)) {
    return *number >= filter.min && *number <= filter.max;
  }
  const auto* const word = std::get_if<std::string>(&cell);
  return word && std::ranges::find(filter.words, *word) != filter.words.end();
}

TEST(FourBarStudy, FiltersKeepWhatPassesThemAfterwards) {
  const Study open = random_study(300);
  const StudyBlock all = evaluate(open, 0, 300);
  const auto columns = study_columns(open);
  StudyFilter turning{.name = "class", .words = {"crank-rocker", "double-crank"}};
  StudyFilter rotating{.name = "crank_turns_fully", .words = {"false"}};
  StudyFilter swinging{.name = "transmission_angle_deg.min", .min = 10, .max = 60};
  StudyFilter quick{.name = "time_ratio", .min = 1.1, .max = 1.6};
  StudyFilter smooth{.name = "cusps", .max = 0};
  const std::vector<std::vector<StudyFilter>> cases = {
      {turning},
      {rotating},
      {swinging},
      {quick},
      {at_least("transmission_angle_deg.acute_min", 30)},
      {at_least("transmission_angle_deg.max", 120), at_least("mechanism.crank", 0.5)},
      {at_least("output_swing_deg", 60)},
      {smooth, at_least("double_points", 1), at_least("curve_length", 4)},
      {at_least("straight_length_over_longest_link", 0.15), turning},
      {at_least("fourier.m1", 0.2), at_least("curve_width_min", 0.5)}};
  for (const auto& filters : cases) {
    std::vector<std::int64_t> wanted;
    for (std::size_t row = 0; row < all.ids.size(); ++row) {
      const bool keep = std::ranges::all_of(filters, [&](const StudyFilter& filter) {
        const auto column = std::ranges::find(columns, filter.name) - columns.begin();
        return passes(filter, all.cells[row * columns.size() + static_cast<std::size_t>(column)]);
      });
      if (keep) wanted.push_back(all.ids[row]);
    }
    Study study = open;
    study.filters = filters;
    study.metrics = {"curve_length"};
    const StudyBlock block = evaluate(study, 0, 300);
    EXPECT_EQ(block.ids, wanted) << filters.front().name;
    EXPECT_EQ(block.filtered, 300 - static_cast<std::int64_t>(wanted.size()));
    EXPECT_GT(wanted.size(), 3U) << filters.front().name;
    EXPECT_LT(wanted.size(), 400U) << filters.front().name;
    study.keep_all = true;
    const StudyBlock whole = evaluate(study, 0, 300);
    EXPECT_EQ(whole.ids.size(), 300U);
    EXPECT_EQ(whole.filtered, block.filtered);
    EXPECT_EQ(std::ranges::count(whole.statuses, RunStatus::filtered), block.filtered);
  }
}

TEST(FourBarStudy, RowsDoNotDependOnHowBlocksAreCut) {
  const Study study = random_study(300);
  const StudyBlock whole = evaluate(study, 0, 300);
  StudyBlock parts;
  for (const auto& [first, count] : {std::pair{0, 7}, {7, 150}, {157, 143}}) {
    const StudyBlock part = evaluate(study, first, count);
    parts.ids.insert(parts.ids.end(), part.ids.begin(), part.ids.end());
    parts.cells.insert(parts.cells.end(), part.cells.begin(), part.cells.end());
  }
  EXPECT_EQ(parts.ids, whole.ids);
  EXPECT_EQ(parts.cells, whole.cells);
}

TEST(FourBarStudy, LeavesOtherStudiesToOthers) {
  const auto takes = [](const Study& study) {
    return four_bar_evaluator(study, 1, nullptr).has_value();
  };
  EXPECT_TRUE(takes(random_study(10)));
  Study other = random_study(10);
  other.metrics.emplace_back("closure_residual");
  EXPECT_FALSE(takes(other));
  other = random_study(10);
  other.variables.push_back(varied("drive.start_deg", {"drive", "start_deg"}, 0, 90));
  EXPECT_FALSE(takes(other));
  other = random_study(10);
  other.base_text += "end_deg = 90\n";
  EXPECT_FALSE(takes(other));
  other = random_study(10);
  other.filters.push_back(at_least("torque_N_m.max", 0));
  EXPECT_FALSE(takes(other));
}

TEST(FourBarStudy, EndsWhenInterrupted) {
  const Study study = random_study(200);
  const std::atomic<bool> interrupted = true;
  const auto evaluator = four_bar_evaluator(study, 1, &interrupted);
  ASSERT_TRUE(evaluator.has_value());
  EXPECT_FALSE((*evaluator)(0, 200).has_value());
}

}  // namespace
}  // namespace cognate::problems::four_bar_study_test
