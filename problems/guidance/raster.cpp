#include "problems/guidance/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/guidance/closure.hpp"
#include "problems/guidance/designs.hpp"
#include "problems/guidance/dimensions.hpp"
#include "problems/guidance/found.hpp"
#include "problems/guidance/order.hpp"
#include "problems/guidance/raster_axes.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/raster/options.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/raster/shared_work.hpp"
#include "synthesis/raster/model_raster.hpp"

namespace cognate::problems {
namespace {

using namespace motion_dimensions;
using synthesis::DyadKind;
using synthesis::Pose;
using synthesis::RasterNumbers;
using synthesis::RasterPoint;

/// Crank angles at which the error of a pose is looked at before it is refined.
constexpr int kScannedAngles = 180;
/// How often poses out of order are put in order, each time with fewer crank angles.
constexpr int kRasterOrderings = 6;

/// How many of the best combinations are each searched as a problem of its own, where dimensions
/// are free beside the raster.
constexpr std::size_t kSearchedMotions = 16;

/// Forms with a crank angle for each pose: those of the minima, and both sides of the problem.
class MotionForms {
 public:
  MotionForms(const MotionProblem& scaled, const std::vector<MotionMinimum>& minima)
      : scaled_(scaled) {
    for (const MotionMinimum& minimum : minima) number_of(minimum.form);
    for (const double side : {1.0, -1.0}) {
      MotionForm form;
      form.sides.assign(scaled.poses.size(), side);
      form.confined_to = scaled.constraints.required_class;
      number_of(form);
    }
  }

  /// Crank angles that poses share count as several.
  std::size_t number_of(MotionForm form) {
    form.stations.clear();
    form.ends.reset();
    form.held.clear();
    form.closes_towards = form.closes_away = false;
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      if (forms_[i].sides == form.sides && forms_[i].confined_to == form.confined_to) return i;
    }
    forms_.push_back(form);
    models_.push_back(std::make_shared<const MotionModel>(scaled_, std::move(form)));
    return forms_.size() - 1;
  }

  const std::vector<MotionForm>& all() const { return forms_; }
  const MotionModel& model(std::size_t form) const { return *models_[form]; }
  std::vector<std::shared_ptr<const synthesis::Model>> models() const {
    return {models_.begin(), models_.end()};
  }

 private:
  const MotionProblem& scaled_;
  std::vector<MotionForm> forms_;
  std::vector<std::shared_ptr<const MotionModel>> models_;
};

/// Whether the constraints are met by the second dyad of a minimum as the driven one.
bool is_turned(const MotionProblem& scaled, const MotionModel& model, std::span<const double> x) {
  if (!roles_are_alike(scaled)) return false;
  const DyadPair pair = model.pair(x), turned{pair.second, pair.first};
  const auto reached = model.reached(x);
  const auto one = judge(scaled, pair, reached), other = judge(scaled, turned, reached);
  return other && (!one || other->violation < one->violation);
}

/// The dyads of a minimum, that as the first by which the constraints are met.
DyadPair driven_pair(const MotionProblem& scaled, const MotionModel& model,
                     std::span<const double> x) {
  const DyadPair pair = model.pair(x);
  return is_turned(scaled, model, x) ? DyadPair{pair.second, pair.first} : pair;
}

/// The crank angle of each pose, those that poses share written for each.
std::vector<double> angles_of_poses(const MotionModel& model, std::span<const double> x,
                                    std::size_t poses) {
  const std::vector<double> shared = model.station_angles(x);
  std::vector<double> apart;
  for (std::size_t j = 0; j < poses; ++j) apart.push_back(shared[model.station_of(j)]);
  return apart;
}

class MotionRaster final : public synthesis::ModelRaster {
 public:
  MotionRaster(const MotionProblem& problem, const MotionProblem& scaled, const MotionScale& scale,
               const MotionForms& forms, const MotionAcceptance& accepts)
      : MotionRaster(problem, scaled, scale, forms, accepts,
                     motion_axes(problem, forms.model(0), scale)) {}

  /// In each form, the crank where each pose is nearest; where these angles break the order or the
  /// circuit, also where they keep it.
  std::vector<RasterPoint> evaluate(const RasterNumbers& at,
                                    std::span<const RasterPoint> from) const override {
    std::vector<RasterPoint> all;
    for (std::size_t form = 0; form < forms_.all().size(); ++form) {
      add_points(form, at, from, all);
    }
    std::erase_if(all, [](const RasterPoint& point) { return !std::isfinite(point.objective); });
    return all;
  }

  bool accepts(const RasterPoint& point) const override { return accepts_(motion(point)); }

  bool is_given_whole() const {
    return dimensions_.size() == forms_.model(0).free_dimensions().size();
  }

  /// A combination as a problem of its own, its dimensions given.
  MotionProblem given_at(const RasterNumbers& at) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < dimensions_.size(); ++i) values.push_back(variable_at(at, i));
    return with_dimensions(scaled_, dimensions_, values);
  }

  /// A minimum of that problem in each form it may be of: with its own crank angles, or, the roles
  /// of its dyads exchanged, with those that are nearest.
  std::vector<RasterPoint> points_of(const MotionProblem& given, const RasterNumbers& at,
                                     const MotionMinimum& minimum) const {
    const MotionModel own(given, minimum.form);
    const std::vector<double>& x = minimum.solution.x;
    if (own.reached(x).empty()) return {};
    const DyadPair pair = driven_pair(given, own, x);
    const std::vector<double> sides = form_of(scaled_, pair).sides;
    std::vector<RasterPoint> points;
    for (std::size_t form = 0; form < forms_.all().size(); ++form) {
      if (forms_.all()[form].sides != sides) continue;
      if (is_turned(given, own, x)) {
        add_points(form, at, std::array{in_form(form, pair)}, points);
        continue;
      }
      std::vector<double> here = in_form(form, pair).x;
      place(at, here);
      points.push_back(point(
          static_cast<int>(form),
          forms_.model(form).with_angles(here, angles_of_poses(own, x, scaled_.poses.size()))));
    }
    return points;
  }

  RasterMotion motion(const RasterPoint& point) const {
    const MotionModel& model = forms_.model(static_cast<std::size_t>(point.form));
    RasterMotion made{exact(scale_.out_of(model.pair(point.x)), point), model.reached(point.x),
                      point.objective};
    for (Pose& pose : made.reached) pose = scale_.out_of(pose);
    return made;
  }

 private:
  MotionRaster(const MotionProblem& problem, const MotionProblem& scaled, const MotionScale& scale,
               const MotionForms& forms, const MotionAcceptance& accepts, MotionAxes axes)
      : ModelRaster(std::move(axes.axes), std::move(axes.variables), forms.models(),
                    {.feasibility = kMotionFeasibility}),
        problem_(problem),
        scaled_(scaled),
        scale_(scale),
        forms_(forms),
        accepts_(accepts),
        dimensions_(std::move(axes.dimensions)) {}

  RasterPoint in_form(std::size_t form, const DyadPair& pair) const {
    RasterPoint made;
    made.form = static_cast<int>(form);
    made.x = forms_.model(form).variables_of(pair);
    return made;
  }

  void add_points(std::size_t form, const RasterNumbers& at, std::span<const RasterPoint> from,
                  std::vector<RasterPoint>& all) const {
    const MotionModel& model = forms_.model(form);
    RasterPoint start;
    start.form = static_cast<int>(form);
    start.x = start_variables(model, from);
    place(at, start.x);
    if (!scan(model, start.x)) return;
    for (RasterPoint& found : relax({at, at}, std::span(&start, 1))) {
      all.push_back(found);
      if (auto ordered = put_in_order(form, at, found)) all.push_back(*std::move(ordered));
    }
  }

  /// What is not on the raster as in the nearest point known, or where its bounds are.
  static std::vector<double> start_variables(const MotionModel& model,
                                             std::span<const RasterPoint> from) {
    const auto globals = static_cast<std::size_t>(model.global_count());
    std::vector<double> x(model.variables().size());
    for (std::size_t i = 0; i < globals; ++i) {
      x[i] = from.empty() ? std::clamp(0.0, model.variables()[i].lower, model.variables()[i].upper)
                          : from.front().x[i];
    }
    return x;
  }

  /// The crank angle of each pose where, of evenly spread ones, it is nearest; false where the
  /// linkage closes at none.
  bool scan(const MotionModel& model, std::vector<double>& x) const {
    const auto globals = static_cast<std::size_t>(model.global_count());
    std::vector<double> least(scaled_.poses.size(), kInfinity);
    for (int k = 0; k < kScannedAngles; ++k) {
      const double angle = kTurn * k / kScannedAngles;
      const auto body = model.body_at(x, angle);
      if (!body) continue;
      for (std::size_t j = 0; j < least.size(); ++j) {
        const double error = squared_miss(*body, scaled_.poses[j]);
        if (error >= least[j]) continue;
        least[j] = error;
        x[globals + j] = angle;
      }
    }
    return least.front() < kInfinity;
  }

  double squared_miss(const Pose& body, const Pose& pose) const {
    const double turned = scaled_.angle_weight * std::remainder(body.angle - pose.angle, kTurn);
    return squared_norm(body.at - pose.at) + turned * turned;
  }

  /// The same combination with crank angles that keep order and circuit; each pose has its own
  /// again. Empty where they are kept as they are, and where they cannot be.
  std::optional<RasterPoint> put_in_order(std::size_t form, const RasterNumbers& at,
                                          const RasterPoint& found) const {
    const Constraints& constraints = scaled_.constraints;
    if (!constraints.no_order_defect && !constraints.no_circuit_defect) return std::nullopt;
    OrderedMotion ordered{forms_.all()[form], found.x};
    bool is_moved = false;
    for (int round = 0; round < kRasterOrderings; ++round) {
      auto next = in_order(scaled_, ordered);
      if (!next || !refit(at, *next)) break;
      ordered = *std::move(next);
      is_moved = true;
    }
    if (!is_moved) return std::nullopt;
    const MotionModel shared(scaled_, ordered.form);
    return point(static_cast<int>(form),
                 forms_.model(form).with_angles(
                     ordered.x, angles_of_poses(shared, ordered.x, scaled_.poses.size())));
  }

  /// The crank angles of a form with shared ones, and what is not on the raster.
  bool refit(const RasterNumbers& at, OrderedMotion& ordered) const {
    const auto shared = std::make_shared<const MotionModel>(scaled_, ordered.form);
    const ModelRaster one({axes().begin(), axes().end()}, axis_variables(), {shared},
                          {.feasibility = kMotionFeasibility});
    RasterPoint start;
    start.x = ordered.x;
    const auto found = one.relax({at, at}, std::span(&start, 1));
    if (found.empty()) return false;
    ordered.x = found.front().x;
    return true;
  }

  /// Without the rounding of the scale.
  DyadPair exact(const DyadPair& rounded, const RasterPoint& point) const {
    std::array<double, MotionModel::dimensions> v{};
    const auto set = [&](int begin, const synthesis::GuidingDyad& dyad) {
      const auto five = second_dyad(dyad);
      std::ranges::copy(five, v.begin() + begin);
    };
    set(0, rounded.first);
    set(kSecond, rounded.second);
    for (std::size_t i = 0; i < dimensions_.size(); ++i) {
      const auto& values = axes()[i].values;
      v[static_cast<std::size_t>(dimensions_[i])] = values.at(values.nearest(point.values[i]));
    }
    const auto dyad = [&](int begin) {
      SecondDyad five;
      std::copy_n(v.begin() + begin, five.size(), five.begin());
      return guiding_dyad(DyadKind::rr, five, problem_.poses.front());
    };
    return {dyad(0), dyad(kSecond)};
  }

  const MotionProblem& problem_;
  const MotionProblem& scaled_;
  const MotionScale& scale_;
  const MotionForms& forms_;
  const MotionAcceptance& accepts_;
  std::vector<int> dimensions_;
};

}  // namespace

RasterMotionResult search_motion_raster(const MotionProblem& problem, const MotionProblem& scaled,
                                        const MotionScale& scale,
                                        const std::vector<MotionMinimum>& minima,
                                        const MotionAcceptance& accepts, const Run& run,
                                        const Deadline& deadline, Work& work) {
  MotionForms forms(scaled, {});
  std::vector<std::pair<std::size_t, std::vector<double>>> starts;
  for (const MotionMinimum& minimum : minima) {
    const MotionModel model(scaled, minimum.form);
    if (model.reached(minimum.solution.x).empty()) continue;
    const DyadPair pair = driven_pair(scaled, model, minimum.solution.x);
    const std::size_t form = forms.number_of(form_of(scaled, pair));
    starts.emplace_back(form, forms.model(form).variables_of(pair));
  }
  const MotionRaster raster(problem, scaled, scale, forms, accepts);
  std::vector<RasterPoint> from;
  for (auto& [form, x] : starts) {
    from.push_back(raster.point(static_cast<int>(form), std::move(x)));
  }
  auto options = raster_options(problem.solve, *problem.raster, run, deadline);
  options.feasibility = kMotionFeasibility;
  options.met = kMetExactly;
  options.searched = kSearchedMotions;
  SharedWork shared(work);
  const Run alone = of_one_combination(run);
  if (!raster.is_given_whole()) {
    options.search = [&](const RasterNumbers& at) {
      const MotionProblem given = raster.given_at(at);
      const auto found = shared.counted([&](Work& own) {
        return search_motions(given, {}, given.solve.starts, synthesis::chosen(given.solve.solver),
                              given.solve.tolerance.value_or(kMotionTolerance), alone, deadline,
                              own);
      });
      std::vector<RasterPoint> points;
      for (const MotionMinimum& minimum : found.minima) {
        std::ranges::move(raster.points_of(given, at, minimum), std::back_inserter(points));
      }
      return points;
    };
  }
  RasterMotionResult result;
  result.search = synthesis::search_raster(raster, from, options);
  // What is free beside the raster was fitted from starts: another may lead to less.
  result.search.is_enumerated = result.search.is_enumerated && raster.is_given_whole();
  for (const RasterPoint& point : result.search.designs) {
    result.designs.push_back(raster.motion(point));
  }
  return result;
}

}  // namespace cognate::problems
