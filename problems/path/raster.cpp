#include "problems/path/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/four_bar_raster.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/crank_sense.hpp"
#include "problems/path/found.hpp"
#include "problems/path/order.hpp"
#include "problems/path/ordered_model.hpp"
#include "problems/path/pivot_model.hpp"
#include "problems/raster/options.hpp"
#include "synthesis/raster/model_raster.hpp"

namespace cognate::problems {
namespace {

using synthesis::RasterNumbers;
using synthesis::RasterPoint;

/// Phases from which a timed path begins at each combination, whose phase alone is free.
constexpr int kPhases = 8;

/// How many of the best combinations are each searched as a problem of its own, where dimensions
/// are free beside the raster.
constexpr std::size_t kSearched = 16;

/// What is chosen before dimensions: a model of its own.
struct PathForm {
  Assembly assembly;
  bool clockwise;
  std::optional<RequiredClass> confined_to;
  std::shared_ptr<const PathModel> model;
  std::shared_ptr<const PivotPathModel> by_pivots;  ///< where pivots are on the raster

  std::shared_ptr<const synthesis::Model> as_model() const {
    if (by_pivots) return by_pivots;
    return model;
  }
  std::vector<double> inwards(std::span<const double> x) const {
    return by_pivots ? by_pivots->inwards(x) : std::vector<double>(x.begin(), x.end());
  }
  std::vector<double> outwards(std::span<const double> x) const {
    return by_pivots ? by_pivots->outwards(x) : std::vector<double>(x.begin(), x.end());
  }
};

/// The problem restricted to a form, as `model_of` has it.
PathProblem confined(const PathProblem& scaled, const std::optional<RequiredClass>& to) {
  PathProblem problem = scaled;
  problem.constraints.required_class = to;
  return problem;
}

PathForm form_of(const PathProblem& scaled, const PathMinimum& minimum) {
  const PathProblem problem = confined(scaled, minimum.confined_to);
  PathForm form{minimum.assembly, minimum.clockwise, minimum.confined_to, nullptr, nullptr};
  form.model = std::make_shared<const PathModel>(problem, minimum.assembly, minimum.clockwise);
  if (has_pivot_raster(*problem.raster, problem.given)) {
    form.by_pivots =
        std::make_shared<const PivotPathModel>(problem, minimum.assembly, minimum.clockwise);
  }
  return form;
}

/// The forms of the minima, and the others that the file allows.
class PathForms {
 public:
  PathForms(const PathProblem& scaled, const std::vector<PathMinimum>& minima) : scaled_(scaled) {
    for (const PathMinimum& minimum : minima) number_of(minimum);
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
      if (scaled.given.assembly && *scaled.given.assembly != assembly) continue;
      for (const bool clockwise : {false, true}) {
        PathMinimum one;
        one.assembly = assembly;
        one.clockwise = clockwise;
        one.confined_to = scaled.constraints.required_class;
        if (allows(clockwise) && !knows(one)) number_of(one);
      }
    }
  }

  std::size_t number_of(const PathMinimum& minimum) {
    const bool clockwise = minimum.clockwise && has_senses();
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      const PathForm& form = forms_[i];
      if (form.assembly == minimum.assembly && form.clockwise == clockwise &&
          form.confined_to == minimum.confined_to) {
        return i;
      }
    }
    PathMinimum one = minimum;
    one.clockwise = clockwise;
    forms_.push_back(form_of(scaled_, one));
    return forms_.size() - 1;
  }

  const std::vector<PathForm>& all() const { return forms_; }

  /// The numbers of those of its assembly and sense.
  std::vector<int> like(const PathMinimum& minimum) const {
    const bool clockwise = minimum.clockwise && has_senses();
    std::vector<int> alike;
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      const bool is_alike =
          forms_[i].assembly == minimum.assembly && forms_[i].clockwise == clockwise;
      if (is_alike) alike.push_back(static_cast<int>(i));
    }
    return alike;
  }

 private:
  /// Whether the sense in which increments are counted belongs to the model; else it belongs to the
  /// places of the points, or the file fixes it.
  bool has_senses() const {
    return scaled_.timing != Timing::free && scaled_.crank_reference == CrankReference::first;
  }

  bool allows(bool clockwise) const {
    if (!has_senses()) return !clockwise;
    const CrankSense sense = clockwise ? CrankSense::cw : CrankSense::ccw;
    return scaled_.crank_sense == CrankSense::either || scaled_.crank_sense == sense;
  }

  bool knows(const PathMinimum& one) const {
    return std::ranges::any_of(forms_, [&](const PathForm& form) {
      return form.assembly == one.assembly && form.clockwise == one.clockwise;
    });
  }

  const PathProblem& scaled_;
  std::vector<PathForm> forms_;
};

std::vector<std::shared_ptr<const synthesis::Model>> models_of(const PathForms& forms) {
  std::vector<std::shared_ptr<const synthesis::Model>> models;
  for (const PathForm& form : forms.all()) models.push_back(form.as_model());
  return models;
}

/// Where the dimensions are among the variables of `model`, or of its PivotPathModel.
FourBarRaster axes_of(const PathProblem& problem, const PathModel& model, const PathScale& scale) {
  const auto free = model.free_dimensions();
  const auto place = [&](PathModel::Dimension dimension) {
    const auto found = std::ranges::find(free, static_cast<int>(dimension));
    return found == free.end() ? -1 : static_cast<int>(found - free.begin());
  };
  const Given& given = problem.given;
  const bool by_pivots = has_pivot_raster(*problem.raster, given);
  const bool anchor_is_d = given.pivot_d && !given.pivot_a;
  const std::array anchor{by_pivots ? place(PathModel::anchor_x) : -1,
                          by_pivots ? place(PathModel::anchor_y) : -1};
  const std::array other{by_pivots ? place(PathModel::frame) : -1,
                         by_pivots ? place(PathModel::angle) : -1};
  const auto& [a_x, a_y] = anchor_is_d ? other : anchor;
  const auto& [d_x, d_y] = anchor_is_d ? anchor : other;
  return four_bar_raster(*problem.raster, given, problem.bounds,
                         {place(PathModel::crank), place(PathModel::coupler),
                          place(PathModel::rocker), place(PathModel::frame),
                          place(PathModel::point_u), place(PathModel::point_v), a_x, a_y, d_x, d_y},
                         {scale.centre, scale.size});
}

class PathRaster final : public synthesis::ModelRaster {
 public:
  PathRaster(const PathProblem& problem, const PathProblem& scaled, const PathScale& scale,
             const PathForms& forms, const PathAcceptance& accepts)
      : PathRaster(scaled, scale, forms, accepts,
                   axes_of(problem, *forms.all().front().model, scale)) {}

  /// At each form, with points that are not timed where they come nearest in order, and a timed
  /// path from several phases.
  std::vector<RasterPoint> evaluate(const RasterNumbers& at,
                                    std::span<const RasterPoint> from) const override {
    std::vector<RasterPoint> all;
    const auto keep = [&](RasterPoint point) {
      if (std::isfinite(point.objective)) all.push_back(std::move(point));
    };
    std::vector<RasterPoint> starts = starts_of(from);
    for (RasterPoint& start : starts) place(at, start.x);
    const bool are_placed = assigns_places(scaled_);
    if (!are_placed || frees_more_) starts = relax({at, at}, starts);
    for (RasterPoint& found : starts) {
      if (!are_placed) {
        keep(std::move(found));
      } else {
        for (const bool clockwise : {false, true}) place_points(found, clockwise, keep);
      }
    }
    return all;
  }

  bool accepts(const RasterPoint& point) const override { return accepts_(design(point)); }

  /// Whether nothing but crank angles and their phase is left beside the raster.
  bool is_given_whole() const { return !frees_more_; }

  /// A combination as a problem of its own, its dimensions given.
  PathProblem given_at(const RasterNumbers& at) const {
    PathProblem given = scaled_;
    for (std::size_t i = 0; i < dimensions_.size(); ++i) {
      give_dimension(given.given, dimensions_[i], variable_at(at, i));
    }
    return given;
  }

  /// A minimum of that problem, in each form it may be of.
  std::vector<RasterPoint> points_of(const PathProblem& given, const RasterNumbers& at,
                                     const PathMinimum& minimum) const {
    const PathModel own = model_of(given, minimum);
    const FourBar linkage = own.linkage(minimum.solution.x);
    const auto angles = own.crank_angles(minimum.solution.x);
    std::vector<RasterPoint> points;
    for (const int form : forms_.like(minimum)) {
      const PathForm& one = forms_.all()[static_cast<std::size_t>(form)];
      std::vector<double> x = one.outwards(one.model->variables_of(linkage, angles));
      place(at, x);
      points.push_back(point(form, std::move(x)));
    }
    return points;
  }

  RasterPath design(const RasterPoint& point) const {
    const PathForm& form = forms_.all()[static_cast<std::size_t>(point.form)];
    const std::vector<double> x = form.inwards(point.x);
    RasterPath made{scale_.out_of(form.model->linkage(x)), form.model->crank_angles(x)};
    for (std::size_t i = 0; i < dimensions_.size(); ++i) {
      // Without the rounding of the scale.
      const auto& values = axes()[i].values;
      set_dimension(made.linkage, dimensions_[i], values.at(values.nearest(point.values[i])));
    }
    return made;
  }

 private:
  PathRaster(const PathProblem& scaled, const PathScale& scale, const PathForms& forms,
             const PathAcceptance& accepts, FourBarRaster axes)
      : ModelRaster(std::move(axes.axes), axes.variables, models_of(forms),
                    {.feasibility = kPathFeasibility}),
        scaled_(scaled),
        scale_(scale),
        forms_(forms),
        accepts_(accepts),
        dimensions_(std::move(axes.dimensions)) {
    const PathModel& model = *forms.all().front().model;
    const auto free = model.free_dimensions();
    const auto phase = std::ranges::find(free, static_cast<int>(PathModel::phase));
    if (phase != free.end()) phase_ = static_cast<std::size_t>(phase - free.begin());
    const std::size_t found = dimensions_.size() + (phase_ ? 1 : 0);
    frees_more_ = found < static_cast<std::size_t>(model.global_count());
  }

  /// Of each form, what is not on the raster as in points that are known; of timed paths with
  /// several phases too.
  std::vector<RasterPoint> starts_of(std::span<const RasterPoint> from) const {
    std::vector<RasterPoint> starts;
    for (std::size_t form = 0; form < forms_.all().size(); ++form) {
      for (RasterPoint& start : known_of(static_cast<int>(form), from)) {
        starts.push_back(start);
        for (int k = 0; phase_ && k < kPhases; ++k) {
          start.x[*phase_] = kTurn * k / kPhases;
          starts.push_back(start);
        }
      }
    }
    return starts;
  }

  /// The points that are known of a form, as what is free beside the raster may be otherwise in
  /// each; else one. Where there are none, another form's.
  std::vector<RasterPoint> known_of(int form, std::span<const RasterPoint> from) const {
    std::vector<RasterPoint> known;
    for (const RasterPoint& point : from) {
      if (point.form == form && (frees_more_ || known.empty())) known.push_back(point);
    }
    if (known.empty() && !from.empty()) known.push_back(from.front());
    for (RasterPoint& point : known) point.form = form;
    return known;
  }

  template <class Keep>
  void place_points(const RasterPoint& point, bool clockwise, const Keep& keep) const {
    const PathForm& form = forms_.all()[static_cast<std::size_t>(point.form)];
    const bool is_open = leaves_sense_open(scaled_);
    const CrankSense sense = clockwise ? CrankSense::cw : CrankSense::ccw;
    const bool allowed = scaled_.crank_sense == CrankSense::either || scaled_.crank_sense == sense;
    if (is_open ? !allowed : clockwise != form.clockwise) return;
    const PathProblem problem = confined(scaled_, form.confined_to);
    const OrderedPathModel ordered(problem, *form.model, clockwise);
    const auto whole = ordered.whole(form.inwards(point.x));
    if (whole) keep(this->point(point.form, form.outwards(whole->x)));
  }

  const PathProblem& scaled_;
  const PathScale& scale_;
  const PathForms& forms_;
  const PathAcceptance& accepts_;
  std::vector<FourBarDimension> dimensions_;
  bool frees_more_ = false;  ///< variables beside those of the raster, crank angles and phase
  std::optional<std::size_t> phase_;  ///< of timed paths, where it is free
};

}  // namespace

RasterPathResult search_path_raster(const PathProblem& problem, const PathProblem& scaled,
                                    const PathScale& scale, const std::vector<PathMinimum>& minima,
                                    const PathAcceptance& accepts, const PathSearcher& search,
                                    const Run& run, const Deadline& deadline) {
  PathForms forms(scaled, minima);
  const PathRaster raster(problem, scaled, scale, forms, accepts);
  std::vector<RasterPoint> from;
  for (const PathMinimum& minimum : minima) {
    const std::size_t form = forms.number_of(minimum);
    from.push_back(
        raster.point(static_cast<int>(form), forms.all()[form].outwards(minimum.solution.x)));
  }
  auto options = raster_options(problem.solve, *problem.raster, run, deadline);
  options.feasibility = kPathFeasibility;
  options.met = kMetExactly;
  options.searched = kSearched;
  if (!raster.is_given_whole()) {
    options.search = [&](const RasterNumbers& at) {
      const PathProblem given = raster.given_at(at);
      std::vector<RasterPoint> points;
      for (const PathMinimum& minimum : search(given)) {
        std::ranges::move(raster.points_of(given, at, minimum), std::back_inserter(points));
      }
      return points;
    };
  }
  RasterPathResult result;
  result.search = synthesis::search_raster(raster, from, options);
  // What is free beside the raster was fitted from starts: another may lead to less.
  result.search.is_enumerated = result.search.is_enumerated && raster.is_given_whole();
  for (const RasterPoint& point : result.search.designs) {
    result.designs.push_back(raster.design(point));
  }
  return result;
}

}  // namespace cognate::problems
