#include "synthesis/search/infeasibility.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/search/deadline.hpp"

namespace cognate::synthesis {
namespace {

/// Halvings of the share that a constraint gives way by.
constexpr int kHalvings = 7;

class Explanation {
 public:
  Explanation(std::span<const char> by_degrees, const RelaxedFeasibility& feasible,
              const std::function<bool()>& is_over)
      : by_degrees_(by_degrees), feasible_(feasible), is_over_(is_over) {}

  Infeasibility find() const {
    using Finding = Infeasibility::Finding;
    if (by_degrees_.empty()) return {};
    if (is_enough({}, 0)) return {Finding::feasible, {}};
    Infeasibility alone{Finding::any_of, {}};
    for (std::size_t i = 0; i < by_degrees_.size(); ++i) {
      if (is_enough({i}, 1)) alone.ways.push_back(least({i}));
    }
    if (!alone.ways.empty()) return alone;
    const auto needed = fewest();
    if (needed.empty()) return {};
    const Infeasibility all{Finding::together, {least(needed)}};
    return is_over_() ? Infeasibility{} : all;
  }

 private:
  using Some = std::vector<std::size_t>;

  bool is_enough(const Some& some, double share) const {
    if (is_over_()) return false;
    std::vector<double> shares(by_degrees_.size());
    for (const std::size_t one : some) shares[one] = share;
    return feasible_(shares);
  }

  /// What is left of all when those that are not needed are taken back, one by one.
  Some fewest() const {
    Some needed(by_degrees_.size());
    for (std::size_t i = 0; i < needed.size(); ++i) needed[i] = i;
    if (!is_enough(needed, 1)) return {};
    for (std::size_t i = 0; i < by_degrees_.size(); ++i) {
      Some without = needed;
      std::erase(without, i);
      if (is_enough(without, 1)) needed = without;
    }
    return needed;
  }

  Concession least(const Some& some) const {
    const bool degrees =
        std::ranges::any_of(some, [&](std::size_t one) { return by_degrees_[one] != 0; });
    double low = 0, high = 1;
    for (int i = 0; degrees && i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (is_enough(some, middle) ? high : low) = middle;
    }
    return {some, high};
  }

  std::span<const char> by_degrees_;
  const RelaxedFeasibility& feasible_;
  const std::function<bool()>& is_over_;
};

/// A model some of whose inequalities may be missed.
class RelaxedModel final : public Model {
 public:
  RelaxedModel(const Model& model, std::span<const double> shares) : model_(model) {
    for (const double share : shares) slack_.push_back(share < 1 ? slack_at(share) : kInfinity);
  }

  std::span<const Variable> variables() const override { return model_.variables(); }
  int residual_count() const override { return model_.residual_count(); }
  int constraint_count() const override { return model_.constraint_count(); }
  int equality_count() const override { return model_.equality_count(); }
  Objective objective() const override { return model_.objective(); }
  std::span<const int> local_of_residual() const override { return model_.local_of_residual(); }
  int local_count() const override { return model_.local_count(); }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override {
    return model_.residuals(x, r, jacobian, local);
  }

  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    model_.constraints(x, c, jacobian);
    const auto equalities = static_cast<std::size_t>(equality_count());
    const auto n = static_cast<std::size_t>(global_count());
    for (std::size_t i = 0; i < slack_.size(); ++i) {
      double& value = c[equalities + i];
      if (slack_[i] < kInfinity) {
        value += slack_[i];
        continue;
      }
      value = 1;  // given up: met everywhere
      if (!jacobian.empty()) std::ranges::fill(jacobian.subspan((equalities + i) * n, n), 0.0);
    }
  }

 private:
  const Model& model_;
  std::vector<double> slack_;
};

}  // namespace

Infeasibility explain_infeasibility(std::span<const char> by_degrees,
                                    const RelaxedFeasibility& feasible,
                                    const std::function<bool()>& is_over) {
  return Explanation(by_degrees, feasible, is_over).find();
}

double slack_at(double share) {
  return share / (1 - share);
}

Infeasibility explain_infeasibility(const Model& model, const SearchOptions& options) {
  const Deadline deadline(options.time_limit, options.cancelled);
  const auto inequalities =
      static_cast<std::size_t>(model.constraint_count() - model.equality_count());
  const auto feasible = [&](std::span<const double> shares) {
    SearchOptions quick = options;
    quick.designs = 1;
    quick.progress = nullptr;
    quick.time_limit = deadline.remaining();
    return search(RelaxedModel(model, shares), quick).status == SearchStatus::solved;
  };
  return explain_infeasibility(std::vector<char>(inequalities, 1), feasible,
                               [&] { return deadline.reached(); });
}

}  // namespace cognate::synthesis
