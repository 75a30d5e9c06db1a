#include "app/study/study_evaluator.hpp"

#include <variant>

#include "app/study/general_evaluator.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

constexpr std::int64_t kSolves = 4;
constexpr std::int64_t kAnalyses = 64;

}  // namespace

problems::BlockEvaluator study_evaluator(const problems::Study& study, std::uint64_t seed,
                                         const std::atomic<bool>* interrupted) {
  return general_evaluator(study, seed, interrupted);
}

std::int64_t block_size(const problems::Study& study) {
  const auto base = problems::parse_task(study.base_text);
  const bool analyses = base && std::holds_alternative<problems::AnalysisProblem>(*base);
  return analyses ? kAnalyses : kSolves;
}

}  // namespace cognate::app
