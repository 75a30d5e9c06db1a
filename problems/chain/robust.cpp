#include "problems/chain/robust.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/crank_angles/in_order.hpp"
#include "problems/chain/model.hpp"
#include "problems/chain/refine.hpp"
#include "problems/tolerance/dimensions.hpp"

namespace cognate::problems {
namespace {

/// Crank angles over the motion at which each transmission angle is limited while dimensions move,
/// and by how much less its cosine may be, which covers the extremes between them.
constexpr int kChecks = 36;
constexpr double kCheckMargin = 0.01;
/// Change of a parameter, in units of the target, that shows which dimension it is.
constexpr double kTried = 1e-3;

/// A dimension that can be off, the parameter that it is, and how it grows with that.
struct TolerancedParameter {
  TolerancedDimension dimension;
  std::size_t parameter;
  double rate;
};

/// A dimension that grows with a parameter, in the file's unit.
struct GrowingDimension {
  std::string name;
  double rate = 0;
};

std::vector<MechanismDimension> dimensions_of(const ScaledChain& space, const TargetScale& scale,
                                              const synthesis::ChainDesign& design) {
  return dimensions(named(*space.topology, scale.out_of(space.chain, design)));
}

/// Of each parameter the dimension that grows with it; nameless where none does, as of directions.
std::vector<GrowingDimension> growing_dimensions(const ScaledChain& space, const TargetScale& scale,
                                                 const synthesis::ChainDesign& design) {
  const auto before = dimensions_of(space, scale, design);
  std::vector<GrowingDimension> growing(design.parameters.size());
  for (std::size_t parameter = 0; parameter < growing.size(); ++parameter) {
    synthesis::ChainDesign other = design;
    other.parameters[parameter] += kTried;
    const auto after = dimensions_of(space, scale, other);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double rate = (after[i].nominal - before[i].nominal) / kTried;
      if (std::abs(rate) > 0.5 * scale.size) growing[parameter] = {before[i].name, rate};
    }
  }
  return growing;
}

/// Empty where a dimension cannot have its tolerance, or none has any.
std::vector<TolerancedParameter> toleranced_parameters(const ChainPathProblem& problem,
                                                       const TargetScale& scale,
                                                       const ScaledChain& space,
                                                       const synthesis::ChainDesign& design) {
  const auto mechanism = named(*space.topology, scale.out_of(space.chain, design));
  const auto all = toleranced(mechanism, *problem.tolerances, problem.length_unit);
  if (!all) return {};
  const auto growing = growing_dimensions(space, scale, design);
  std::vector<TolerancedParameter> found;
  for (const TolerancedDimension& dimension : all->dimensions) {
    const auto place = std::ranges::find(growing, dimension.name, &GrowingDimension::name);
    if (place == growing.end()) return {};
    found.push_back({dimension, static_cast<std::size_t>(place - growing.begin()), place->rate});
  }
  return found;
}

double sum_of_squares(const ChainPathModel& model, std::span<const double> x) {
  std::vector<double> r(static_cast<std::size_t>(model.residual_count()));
  if (!model.residuals(x, r, {}, {})) return kInfinity;
  return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
}

/// The problem of one minimum in which every dimension that can be off is a variable.
class OpenedChain {
 public:
  OpenedChain(ScaledChain space, const ChainMinimum& minimum,
              const std::vector<TolerancedParameter>& toleranced)
      : space_(std::move(space)), given_(space_.given) {
    for (const auto& [dimension, parameter, rate] : toleranced) space_.given[parameter].reset();
    space_.free.clear();
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (!space_.given[i]) space_.free.push_back(static_cast<int>(i));
      if (!given_[i]) continue;
      space_.lower[i] = std::min(space_.lower[i], *given_[i]);
      space_.upper[i] = std::max(space_.upper[i], *given_[i]);
    }
    model_ =
        std::make_shared<const ChainPathModel>(space_, minimum.design, minimum.angles,
                                               TargetPlace{}, checks(minimum.angles), kCheckMargin);
  }
  OpenedChain(const OpenedChain&) = delete;
  OpenedChain& operator=(const OpenedChain&) = delete;

  const std::shared_ptr<const ChainPathModel>& model() const { return model_; }

  RobustStart start(const std::vector<TolerancedParameter>& toleranced) const {
    RobustStart start;
    start.model = model_;
    start.x = model_->start();
    const auto variables = model_->variables();
    for (std::size_t i = 0; i < variables.size(); ++i) {
      const bool is_given = i < space_.free.size() && given_[free_parameter(i)].has_value();
      start.lower.push_back(is_given ? start.x[i] : variables[i].lower);
      start.upper.push_back(is_given ? start.x[i] : variables[i].upper);
    }
    for (const auto& [dimension, parameter, rate] : toleranced) {
      const auto place = std::ranges::find(space_.free, static_cast<int>(parameter));
      start.dimensions.push_back(dimension);
      start.variables.push_back(
          {.variable = static_cast<int>(place - space_.free.begin()), .scale = rate});
    }
    return start;
  }

  /// Brings the crank to where each point that is not timed is nearest, in order; false where the
  /// chain cannot be assembled there.
  bool place(std::vector<double>& x) const {
    if (space_.timed()) return true;
    ScaledChain fixed = space_;
    const synthesis::ChainDesign design = model_->design(x);
    fixed.given.assign(design.parameters.begin(), design.parameters.end());
    fixed.free.clear();
    std::vector<std::vector<double>> starts = ordered_angles(fixed, design);
    starts.push_back(model_->angles(x));
    double least = kInfinity;
    for (const std::vector<double>& angles : starts) {
      const ChainPathModel placed(fixed, design, angles, {}, {});
      const auto solution = synthesis::solve(synthesis::Solver::gauss_newton, placed, angles,
                                             {.tolerance = 1e-12, .max_iterations = 60});
      const double objective = sum_of_squares(placed, solution.x);
      if (!(objective < least)) continue;
      least = objective;
      std::ranges::copy(solution.x, x.end() - static_cast<std::ptrdiff_t>(solution.x.size()));
    }
    return std::isfinite(least);
  }

  ChainMinimum minimum(const std::vector<double>& x) const {
    return {&space_, model_->design(x), model_->angles(x), std::sqrt(sum_of_squares(*model_, x))};
  }

 private:
  std::size_t free_parameter(std::size_t variable) const {
    return static_cast<std::size_t>(space_.free[variable]);
  }

  /// Over the motion that the limit is of.
  std::vector<TransmissionCheck> checks(const std::vector<double>& angles) const {
    double from = 0, to = kTurn;
    if (!space_.over_turn) {
      const auto& all = space_.timed() ? space_.crank_angles : angles;
      const auto [least, greatest] = std::ranges::minmax(all);
      const double origin = space_.timed() ? angles.front() : 0;
      from = origin + least;
      to = origin + greatest;
    }
    std::vector<TransmissionCheck> found;
    for (const int joint : space_.joints) {
      for (int k = 0; k < kChecks; ++k) {
        found.push_back({joint, from + (to - from) * k / (kChecks - 1)});
      }
    }
    return found;
  }

  ScaledChain space_;
  std::vector<std::optional<double>> given_;  ///< by the file
  std::shared_ptr<const ChainPathModel> model_;
};

}  // namespace

RobustTask robust_chain_task(const ChainPathProblem& problem, const TargetScale& scale,
                             const std::vector<ScaledChain>& spaces,
                             const std::vector<ChainMinimum>& minima,
                             const VerifiedChain& verified) {
  RobustTask task;
  task.share = *problem.solve.robust;
  task.distribution = problem.tolerances->distribution;
  task.components = 2;
  // The residuals of the model are divided by the root of their number.
  task.scale.assign(problem.points.size(), std::sqrt(double(problem.points.size())));
  task.unit = scale.size;
  using Opened = std::map<const synthesis::Model*, std::shared_ptr<const OpenedChain>>;
  auto opened = std::make_shared<Opened>();
  for (const ChainMinimum& minimum : minima) {
    if (!verified(minimum)) continue;
    const auto space = std::ranges::find(spaces, minimum.problem->topology,
                                         [](const ScaledChain& one) { return one.topology; });
    const auto toleranced = toleranced_parameters(problem, scale, *space, minimum.design);
    if (toleranced.empty()) {
      task.lacks_tolerances = true;
      continue;
    }
    auto chain = std::make_shared<const OpenedChain>(*space, minimum, toleranced);
    task.starts.push_back(chain->start(toleranced));
    opened->emplace(chain->model().get(), std::move(chain));
  }
  task.place = [opened](const RobustStart& start, std::vector<double>& x) {
    return opened->at(start.model.get())->place(x);
  };
  task.design = [opened, verified](const RobustStart& start, const std::vector<double>& x) {
    auto design = verified(opened->at(start.model.get())->minimum(x));
    if (design) design->origin = "robust";
    return design;
  };
  return task;
}

}  // namespace cognate::problems
