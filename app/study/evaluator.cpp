#include "app/study/evaluator.hpp"

#include <utility>

#include "app/study/general_evaluator.hpp"
#include "problems/read.hpp"
#include "problems/study/four_bar_study.hpp"

namespace cognate::app {
namespace {

// So many that a block takes long enough to be worth handing out, and not so long that a stop, or
// the end of the study, is waited for.
constexpr std::int64_t kBatch = 8192;
constexpr std::int64_t kAnalyses = 64;
constexpr std::int64_t kSolves = 4;

}  // namespace

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
