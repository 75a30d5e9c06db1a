#include "app/study/evaluator.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "app/study/design_values.hpp"
#include "problems/read.hpp"
#include "problems/study/base.hpp"
#include "problems/study/design_points.hpp"
#include "problems/study/filter.hpp"
#include "problems/study/four_bar_study.hpp"

namespace cognate::app {
namespace {

using problems::Cell;
using problems::RunStatus;
using problems::Study;
using problems::StudyBlock;
using problems::StudyFilter;

/// A filter and the place of what it looks at among the variables or the values requested.
struct FilterRange {
  const StudyFilter* filter = nullptr;
  std::size_t place = 0;
};

class GeneralEvaluator {
 public:
  GeneralEvaluator(const Study& study, std::uint64_t seed, const std::atomic<bool>* interrupted)
      : study_(study),
        seed_(seed),
        interrupted_(interrupted),
        base_(study),
        points_(study, seed),
        names_(study.metrics) {
    for (const StudyFilter& filter : study.filters) place(filter);
  }

  std::optional<StudyBlock> evaluate_block(std::int64_t first, std::int64_t count) {
    const std::size_t width = study_.variables.size();
    numbers_.resize(static_cast<std::size_t>(count) * width);
    points_.fill(first, numbers_);
    StudyBlock block;
    block.first = first;
    block.count = count;
    for (std::int64_t i = 0; i < count; ++i) {
      if (interrupted_ && interrupted_->load()) return std::nullopt;
      const auto numbers = std::span(numbers_).subspan(static_cast<std::size_t>(i) * width, width);
      auto outcome = outcome_of(numbers);
      if (!outcome) return std::nullopt;
      add_row(block, first + i, numbers, *std::move(outcome));
    }
    return block;
  }

 private:
  void place(const StudyFilter& filter) {
    const auto variable =
        std::ranges::find(study_.variables, filter.name, &problems::StudyVariable::key);
    if (variable != study_.variables.end()) {
      on_numbers_.push_back(
          {&filter, static_cast<std::size_t>(std::distance(study_.variables.begin(), variable))});
      return;
    }
    const auto found = std::ranges::find(names_, filter.name);
    on_values_.push_back({&filter, static_cast<std::size_t>(std::distance(names_.begin(), found))});
    if (found == names_.end()) names_.push_back(filter.name);
  }

  /// Empty if interrupted. Without values where the numbers decide.
  std::optional<DesignOutcome> outcome_of(std::span<const double> numbers) {
    const bool allowed = std::ranges::all_of(
        on_numbers_, [&](const FilterRange& on) { return passes(*on.filter, numbers[on.place]); });
    if (!allowed) return DesignOutcome{RunStatus::filtered, {}};
    const auto task = base_.with(numbers);
    auto outcome = task ? evaluate(*task, names_, seed_, interrupted_)
                        : std::optional(DesignOutcome{RunStatus::invalid, {}});
    if (!outcome) return std::nullopt;
    outcome->values.resize(names_.size());
    const bool passed = std::ranges::all_of(on_values_, [&](const FilterRange& on) {
      return passes(*on.filter, outcome->values[on.place]);
    });
    if (!passed) outcome->status = RunStatus::filtered;
    return outcome;
  }

  void add_row(StudyBlock& block, std::int64_t id, std::span<const double> numbers,
               DesignOutcome outcome) const {
    const bool filtered = outcome.status == RunStatus::filtered;
    if (filtered) ++block.filtered;
    if (filtered && !study_.keep_all) return;
    block.ids.push_back(id);
    block.statuses.push_back(outcome.status);
    block.cells.insert(block.cells.end(), numbers.begin(), numbers.end());
    outcome.values.resize(study_.metrics.size());
    std::ranges::move(outcome.values, std::back_inserter(block.cells));
  }

  const Study& study_;
  std::uint64_t seed_;
  const std::atomic<bool>* interrupted_;
  problems::StudyBase base_;
  problems::DesignPoints points_;
  std::vector<std::string> names_;  ///< the metrics of the study, then those of filters alone
  std::vector<FilterRange> on_numbers_, on_values_;
  std::vector<double> numbers_;
};

// So many that a block takes long enough to be worth handing out, and not so long that a stop, or
// the end of the study, is waited for.
constexpr std::int64_t kBatch = 8192;
constexpr std::int64_t kAnalyses = 64;
constexpr std::int64_t kSolves = 4;

}  // namespace

problems::BlockEvaluator general_evaluator(const Study& study, std::uint64_t seed,
                                           const std::atomic<bool>* interrupted) {
  const auto evaluator = std::make_shared<GeneralEvaluator>(study, seed, interrupted);
  return [evaluator](std::int64_t first, std::int64_t count) {
    return evaluator->evaluate_block(first, count);
  };
}

problems::BlockEvaluator study_evaluator(const problems::Study& study, std::uint64_t seed,
                                         const std::atomic<bool>* interrupted) {
  auto batches = problems::four_bar_evaluator(study, seed, interrupted);
  return batches ? *std::move(batches) : general_evaluator(study, seed, interrupted);
}

std::int64_t block_size(const problems::Study& study) {
  if (problems::four_bar_evaluator(study, 0, nullptr)) return kBatch;
  const auto base = problems::parse_task<problems::AnalysisProblem>(study.base_text);
  return base ? kAnalyses : kSolves;
}

}  // namespace cognate::app
