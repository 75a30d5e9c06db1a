#include "problems/guidance/placed_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/guidance/closure.hpp"
#include "problems/guidance/order.hpp"

namespace cognate::problems {
namespace {

/// Steps at most, and the step in radians at which a crank stands.
constexpr int kCrankSteps = 60;
constexpr double kCrankStands = 1e-13;
/// How often poses out of order are put in order, each time with fewer crank angles.
constexpr int kOrderings = 6;

/// Gauss–Newton steps of every local variable of a motion, each halved until its own error falls.
class CrankDescent {
 public:
  explicit CrankDescent(const MotionModel& model)
      : model_(model),
        globals_(static_cast<std::size_t>(model.global_count())),
        r_(static_cast<std::size_t>(model.residual_count())),
        jacobian_(r_.size() * globals_),
        local_(r_.size()) {}

  /// False where the linkage does not close at `x`.
  bool descend(std::vector<double>& x) {
    if (!evaluate(x)) return false;
    std::vector<double> cost = cost_, step = step_, next = x;
    for (int round = 0; round < kCrankSteps; ++round) {
      for (std::size_t k = 0; k < step.size(); ++k) next[globals_ + k] = x[globals_ + k] + step[k];
      const bool closes = evaluate(next);
      double greatest = 0;
      for (std::size_t k = 0; k < step.size(); ++k) {
        greatest = std::max(greatest, std::abs(step[k]));
        if (!closes || cost_[k] > cost[k]) {
          step[k] /= 2;
          continue;
        }
        x[globals_ + k] = next[globals_ + k];
        cost[k] = cost_[k];
        step[k] = step_[k];
      }
      if (greatest <= kCrankStands) break;
    }
    return true;
  }

 private:
  /// Error and step of each local variable at `x`.
  bool evaluate(const std::vector<double>& x) {
    if (!model_.residuals(x, r_, jacobian_, local_)) return false;
    const std::size_t count = x.size() - globals_;
    cost_.assign(count, 0.0);
    step_.assign(count, 0.0);
    std::vector<double> square(count, 0.0);
    for (std::size_t row = 0; row < r_.size(); ++row) {
      const int place = model_.local_of_residual()[row];
      if (place < 0) continue;
      const auto k = static_cast<std::size_t>(place);
      cost_[k] += r_[row] * r_[row];
      step_[k] -= local_[row] * r_[row];
      square[k] += local_[row] * local_[row];
    }
    for (std::size_t k = 0; k < count; ++k) step_[k] = square[k] > 0 ? step_[k] / square[k] : 0;
    return true;
  }

  const MotionModel& model_;
  std::size_t globals_;
  std::vector<double> r_, jacobian_, local_, cost_, step_;
};

bool descend_cranks(const MotionProblem& problem, OrderedMotion& motion) {
  const MotionModel model(problem, motion.form);
  return CrankDescent(model).descend(motion.x);
}

}  // namespace

std::vector<double> along_arc(const DyadPair& pair, std::vector<double> crank_angles) {
  for (const CrankRange& arc :
       closing_arcs(pair.second.kind, pair.first, second_dyad(pair.second))) {
    std::vector<double> along;
    for (const double angle : crank_angles) {
      along.push_back(arc.from + in_one_turn(angle - arc.from));
    }
    if (*std::ranges::max_element(along) <= arc.to) return along;
  }
  return crank_angles;
}

MotionForm unpooled_form(const MotionProblem& problem, const DyadPair& pair,
                         std::span<const double> crank_angles) {
  MotionForm form = form_of(problem, pair);
  if (!MotionModel(problem, form).limits_driven_range()) return form;
  form.stations.resize(problem.poses.size());
  std::iota(form.stations.begin(), form.stations.end(), 0);
  if (problem.constraints.no_order_defect) return form;
  const auto [least, greatest] = std::ranges::minmax_element(crank_angles);
  form.ends = {static_cast<std::size_t>(least - crank_angles.begin()),
               static_cast<std::size_t>(greatest - crank_angles.begin())};
  return form;
}

std::optional<std::vector<double>> placed_cranks(const MotionProblem& problem,
                                                 const MotionForm& form, std::vector<double> x) {
  OrderedMotion motion{form, std::move(x)};
  if (!descend_cranks(problem, motion)) return std::nullopt;
  for (int round = 0; round < kOrderings; ++round) {
    auto next = in_order(problem, motion);
    if (!next || !descend_cranks(problem, *next)) break;
    motion = *std::move(next);
  }
  const MotionModel pooled(problem, motion.form);
  const auto angles = pooled.station_angles(motion.x);
  std::vector<double> apart;
  for (std::size_t j = 0; j < problem.poses.size(); ++j) {
    apart.push_back(angles[pooled.station_of(j)]);
  }
  return MotionModel(problem, form).with_angles(motion.x, apart);
}

}  // namespace cognate::problems
