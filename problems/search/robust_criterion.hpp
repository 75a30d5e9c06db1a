/// @file What a search for robust designs makes least.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "problems/search/robust.hpp"

namespace cognate::problems {

/// A figure of the error over the tolerances: a quantile, or the worst case.
class RobustCriterion {
 public:
  virtual ~RobustCriterion() = default;

  /// The figure as the search sees it, in the model's unit; infinite without a value.
  virtual double seen(const RobustStart& start, std::span<const double> x) const = 0;
  /// Where a descent from `x` has the least figure, the nominal sum of squares within `most`.
  virtual std::vector<double> descend(const RobustStart& start, std::vector<double> x,
                                      std::optional<double> most) const = 0;
  /// The figure in the file's unit, of any point of a front and of its two ends: by more than the
  /// search has seen.
  virtual double judged(const RobustStart& start, std::span<const double> x) const = 0;
  virtual double reported(const RobustStart& start, std::span<const double> x) const = 0;
};

/// How many samples the points of a front are judged by, and its ends are reported by.
inline constexpr std::size_t kJudgedSamples = 30'000, kReportedSamples = 1'000'000;

/// That of `task`, which must outlive it, as the others.
std::unique_ptr<RobustCriterion> robust_criterion(const RobustTask& task, const Run& run,
                                                  const Deadline& deadline);
std::unique_ptr<RobustCriterion> quantile_criterion(const RobustTask& task, const Run& run,
                                                    const Deadline& deadline);
std::unique_ptr<RobustCriterion> worst_case_criterion(const RobustTask& task,
                                                      const Deadline& deadline);

}  // namespace cognate::problems
