#include "problems/function/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/function/found.hpp"
#include "problems/function/length_ranges.hpp"
#include "problems/function/model.hpp"
#include "problems/linkage/linkage_keys.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/raster/options.hpp"
#include "synthesis/raster/model_raster.hpp"

namespace cognate::problems {
namespace {

using synthesis::RasterNumbers;
using synthesis::RasterPoint;

/// How many of the best combinations are each searched as a problem of its own, where lengths are
/// free beside the raster.
constexpr std::size_t kSearched = 48;
/// Input start angles from which each combination is begun, where the file leaves them open.
constexpr int kInputStarts = 12;

synthesis::Objective objective_of(const FunctionProblem& problem) {
  return problem.objective == FunctionObjective::minimax ? synthesis::Objective::max_abs
                                                         : synthesis::Objective::sum_of_squares;
}

/// What is chosen before dimensions: assembly and class.
struct FunctionForm {
  Assembly assembly;
  const FunctionProblem* problem;
  std::shared_ptr<const FunctionModel> model;
};

/// The forms of the minima, and both assemblies of the problem itself.
class FunctionForms {
 public:
  FunctionForms(const ConfinedFunctions& confined, const FunctionSamples& wanted,
                const std::vector<FunctionDesign>& minima)
      : confined_(confined), wanted_(wanted) {
    for (const FunctionDesign& minimum : minima) number_of(minimum.generator);
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
      const auto& given = confined.plain().given.assembly;
      if (!given || *given == assembly) number_of(assembly, confined.plain());
    }
  }

  std::size_t number_of(const FunctionGenerator& generator) {
    return number_of(generator.assembly, confined_.of(generator.links));
  }

  const std::vector<FunctionForm>& all() const { return forms_; }

  /// The numbers of those of an assembly.
  std::vector<int> of(Assembly assembly) const {
    std::vector<int> alike;
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      if (forms_[i].assembly == assembly) alike.push_back(static_cast<int>(i));
    }
    return alike;
  }

 private:
  std::size_t number_of(Assembly assembly, const FunctionProblem& problem) {
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      if (forms_[i].assembly == assembly && forms_[i].problem == &problem) return i;
    }
    forms_.push_back(
        {assembly, &problem,
         std::make_shared<const FunctionModel>(problem, wanted_, assembly, objective_of(problem))});
    return forms_.size() - 1;
  }

  const ConfinedFunctions& confined_;
  const FunctionSamples& wanted_;
  std::vector<FunctionForm> forms_;
};

struct FunctionAxes {
  std::vector<const LinkKey*> links;
  std::vector<synthesis::RasterAxis> axes;
  std::vector<synthesis::AxisVariable> variables;
  bool is_whole = true;  ///< whether no other length is free
};

FunctionAxes axes_of(const FunctionProblem& problem) {
  FunctionAxes all;
  const auto ranges = length_ranges(problem);
  int place = 0;
  for (std::size_t i = 0; i < kLinkKeys.size(); ++i) {
    if (ranges[i].min == ranges[i].max) continue;
    const int variable = place++;
    const RasterRule* rule = problem.raster->rule(kLinkKeys[i].key);
    if (rule == nullptr) {
      all.is_whole = false;
      continue;
    }
    all.links.push_back(&kLinkKeys[i]);
    all.axes.push_back({std::string(kLinkKeys[i].key), values_within(*rule, ranges[i], ranges[i])});
    all.variables.push_back({.variable = variable, .is_logarithm = true});
  }
  return all;
}

std::vector<std::shared_ptr<const synthesis::Model>> models_of(const FunctionForms& forms) {
  std::vector<std::shared_ptr<const synthesis::Model>> models;
  for (const FunctionForm& form : forms.all()) models.push_back(form.model);
  return models;
}

class FunctionRaster final : public synthesis::ModelRaster {
 public:
  FunctionRaster(const FunctionProblem& problem, const FunctionSamples& wanted,
                 const FunctionForms& forms, const FunctionAcceptance& accepts)
      : FunctionRaster(problem, wanted, forms, accepts, axes_of(problem)) {}

  /// From points that are known and, where start angles are free, from several of the input's in
  /// each form, the output's then following to first order.
  std::vector<RasterPoint> evaluate(const RasterNumbers& at,
                                    std::span<const RasterPoint> from) const override {
    std::vector<RasterPoint> starts(from.begin(), from.end());
    for (std::size_t form = 0; form < forms_.all().size(); ++form) add_starts(form, at, starts);
    return relax({at, at}, starts);
  }

  bool accepts(const RasterPoint& point) const override { return accepts_(design(point)); }

  /// Whether nothing but start angles is left beside the raster.
  bool is_given_whole() const { return is_given_whole_; }

  /// A combination as a problem of its own, its lengths given.
  FunctionProblem given_at(const RasterNumbers& at) const {
    FunctionProblem given = problem_;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      given.given.*links_[i]->given = axes()[i].values.at(at[i]);
    }
    return given;
  }

  /// A minimum of that problem, in each form it may be of.
  std::vector<RasterPoint> points_of(const RasterNumbers& at,
                                     const FunctionGenerator& minimum) const {
    std::vector<RasterPoint> points;
    for (const int form : forms_.of(minimum.assembly)) {
      const FunctionModel& model = *forms_.all()[static_cast<std::size_t>(form)].model;
      std::vector<double> x = model.variables_of(minimum);
      place(at, x);
      points.push_back(point(form, std::move(x)));
    }
    return points;
  }

  FunctionGenerator design(const RasterPoint& point) const {
    FunctionGenerator made =
        forms_.all()[static_cast<std::size_t>(point.form)].model->generator(point.x);
    for (std::size_t i = 0; i < links_.size(); ++i) {
      // Without the rounding of the logarithm.
      const auto& values = axes()[i].values;
      made.links.*links_[i]->length = values.at(values.nearest(point.values[i]));
    }
    return made;
  }

 private:
  FunctionRaster(const FunctionProblem& problem, const FunctionSamples& wanted,
                 const FunctionForms& forms, const FunctionAcceptance& accepts, FunctionAxes axes)
      : ModelRaster(std::move(axes.axes), std::move(axes.variables), models_of(forms),
                    {.feasibility = kFunctionFeasibility}),
        problem_(problem),
        wanted_(wanted),
        forms_(forms),
        accepts_(accepts),
        links_(std::move(axes.links)),
        is_given_whole_(axes.is_whole) {}

  void add_starts(std::size_t form, const RasterNumbers& at,
                  std::vector<RasterPoint>& starts) const {
    const FunctionModel& model = *forms_.all()[form].model;
    RasterPoint start;
    start.form = static_cast<int>(form);
    std::vector<double> x(model.variables().size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto& [name, lower, upper, scale] = model.variables()[i];
      x[i] = std::isfinite(lower) && std::isfinite(upper) ? 0.5 * (lower + upper) : 0;
    }
    place(at, x);
    const bool is_given = problem_.input_start || problem_.start != FunctionStart::free;
    const int count = is_given ? 1 : kInputStarts;
    for (int k = 0; k < count; ++k) {
      FunctionGenerator generator = model.generator(x);
      if (!is_given) generator.input_start = kTurn * k / count;
      if (!problem_.output_start && problem_.start == FunctionStart::free) {
        const auto output = best_output_start(generator, wanted_.samples);
        if (!output) continue;
        generator.output_start = *output;
      }
      start.x = model.variables_of(generator);
      starts.push_back(start);
    }
  }

  const FunctionProblem& problem_;
  const FunctionSamples& wanted_;
  const FunctionForms& forms_;
  const FunctionAcceptance& accepts_;
  std::vector<const LinkKey*> links_;
  bool is_given_whole_;
};

}  // namespace

RasterFunctionResult search_function_raster(const FunctionProblem& problem,
                                            const FunctionSamples& wanted,
                                            const std::vector<FunctionDesign>& minima,
                                            const FunctionAcceptance& accepts,
                                            const FunctionSearcher& search, const Run& run,
                                            const Deadline& deadline) {
  const ConfinedFunctions confined(problem);
  FunctionForms forms(confined, wanted, minima);
  const FunctionRaster raster(problem, wanted, forms, accepts);
  std::vector<RasterPoint> from;
  for (const FunctionDesign& minimum : minima) {
    const std::size_t form = forms.number_of(minimum.generator);
    from.push_back(raster.point(static_cast<int>(form),
                                forms.all()[form].model->variables_of(minimum.generator)));
  }
  const bool is_minimax = problem.objective == FunctionObjective::minimax;
  auto options = raster_options(problem.solve, *problem.raster, run, deadline);
  options.feasibility = kFunctionFeasibility;
  options.met = is_minimax ? std::sqrt(kMetExactly) : kMetExactly;
  options.searched = kSearched;
  if (!raster.is_given_whole()) {
    options.search = [&](const RasterNumbers& at) {
      std::vector<RasterPoint> points;
      for (const FunctionDesign& minimum : search(raster.given_at(at))) {
        std::ranges::move(raster.points_of(at, minimum.generator), std::back_inserter(points));
      }
      return points;
    };
  }
  RasterFunctionResult result;
  result.search = synthesis::search_raster(raster, from, options);
  // Lengths that are free beside the raster were fitted from starts: another may lead to less.
  result.search.is_enumerated = result.search.is_enumerated && raster.is_given_whole();
  for (const RasterPoint& point : result.search.designs) {
    result.designs.push_back(raster.design(point));
  }
  return result;
}

}  // namespace cognate::problems
