#include "problems/tolerance/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/travel.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/mechanism/joint_names.hpp"
#include "problems/tolerance/allocate.hpp"
#include "problems/tolerance/clearance.hpp"
#include "problems/tolerance/dead_points.hpp"
#include "problems/tolerance/dimensions.hpp"
#include "problems/tolerance/extremes.hpp"
#include "problems/tolerance/sampled.hpp"
#include "synthesis/tolerance/worst_case.hpp"

namespace cognate::problems {
namespace {

/// Where exact and linear worst case differ by more than this share, a note says so.
constexpr double kNonlinear = 0.05;

bool is_drive_slider(const NamedMechanism& mechanism) {
  return driven_by_length(mechanism.mechanism.drive);
}

double shown_drive(const NamedMechanism& mechanism, double drive) {
  return is_drive_slider(mechanism) ? drive : degrees(drive);
}

/// A dimension that `[tolerance]` names and this mechanism does not have.
std::optional<std::string> unknown_dimension(const NamedMechanism& mechanism,
                                             const Tolerances& tolerances) {
  const std::vector<std::string> groups = dimension_groups(mechanism);
  for (const auto& [name, value] : tolerances.dimensions) {
    if (std::ranges::find(groups, name) == groups.end()) return name;
  }
  return std::nullopt;
}

std::string dead_point_refusal(const NamedMechanism& mechanism, const DeadPoint& dead) {
  const std::string at =
      fmt::format("{} at {:.6g}{}", dyad_names(mechanism)[dead.dyad],
                  shown_drive(mechanism, dead.drive), is_drive_slider(mechanism) ? "" : " deg");
  return fmt::format(
      "the links of {} are in line, a change point or dead point of the nominal mechanism: with "
      "any change of a dimension the motion is another one or ends there, so that sensitivities "
      "and worst cases do not exist; of the samples those that can be assembled are counted",
      at);
}

std::string dead_point_note(const NamedMechanism& mechanism, const DeadPoint& dead) {
  return fmt::format(
      "within the tolerances {} comes to a dead point near {:.6g}{}: some mechanisms end their "
      "motion there, and figures of first order mean little about it",
      dyad_names(mechanism)[dead.dyad], shown_drive(mechanism, dead.drive),
      is_drive_slider(mechanism) ? "" : " deg");
}

/// The figures of the quantities, one after the other.
class FigureMaker {
 public:
  FigureMaker(const TolerancedMechanism& toleranced, const ToleranceQuestion& question)
      : toleranced_(toleranced), question_(question) {
    for (const TolerancedDimension& dimension : toleranced.dimensions) {
      box_.push_back({-dimension.deviation.minus, dimension.deviation.plus});
    }
    for (const ToleranceQuantity& quantity : question.quantities) {
      responses_.push_back(quantity.response);
    }
  }

  std::span<const synthesis::Interval> box() const { return box_; }

  void differentiate() {
    table_.emplace(sensitivities(toleranced_.mechanism, responses_, question_.stations));
    for (std::size_t q = 0; q < responses_.size(); ++q) {
      const auto& normal = question_.quantities[q].normal;
      for (std::size_t s = 0; s < normal.size(); ++s) {
        table_->value(s, q) = {dot(table_->value(s, q), normal[s]), 0};
        for (Vec2d& rate : table_->rates(s, q)) rate = {dot(rate, normal[s]), 0};
      }
    }
  }

  ToleranceFigures figures(std::size_t q) const {
    const ToleranceQuantity& quantity = question_.quantities[q];
    ToleranceFigures result;
    result.name = quantity.name;
    result.angle = is_angular(quantity.response.type);
    result.is_point = quantity.is_distance();
    result.judged = quantity.judged;
    result.along = quantity.normal;
    for (std::size_t s = 0; s < question_.stations.size(); ++s) {
      result.positions.push_back(position(q, s));
    }
    result.worst = greatest(result, &PositionFigures::linear);
    contribute(q, result);
    set_extremes(toleranced_.mechanism, question_, q, box_, *table_, result);
    return result;
  }

  const SensitivityTable& table() const { return *table_; }

 private:
  static std::size_t greatest(const ToleranceFigures& figures, double PositionFigures::*of) {
    std::size_t worst = 0;
    double most = -1;
    for (std::size_t s = 0; s < figures.positions.size(); ++s) {
      const PositionFigures& at = figures.positions[s];
      const double size = figures.is_point ? at.*of : std::abs(at.*of);
      if (size > most) {
        most = size;
        worst = s;
      }
    }
    return worst;
  }

  PositionFigures position(std::size_t q, std::size_t s) const {
    const ToleranceQuantity& quantity = question_.quantities[q];
    const auto rates = table_->rates(s, q);
    PositionFigures at;
    double high = 0, low = 0, squares = 0;
    std::vector<Vec2d> arms;
    Vec2d base{};
    if (quantity.is_distance() && !quantity.target.empty()) {
      base = table_->value(s, q) - quantity.target[s];
    }
    at.nominal = norm(base);
    for (std::size_t i = 0; i < rates.size(); ++i) {
      const TolerancedDimension& dimension = toleranced_.dimensions[i];
      const auto& [plus, minus] = dimension.deviation;
      high += std::max(rates[i].x * plus, -rates[i].x * minus);
      low += std::min(rates[i].x * plus, -rates[i].x * minus);
      squares += squared_norm(dimension.half_width() * rates[i]);
      base = base + dimension.middle() * rates[i];
      arms.push_back(dimension.half_width() * rates[i]);
    }
    at.rss = std::sqrt(squares);
    at.low = at.high = std::numeric_limits<double>::quiet_NaN();
    if (quantity.is_distance()) {
      arms.push_back(base);
      at.linear = synthesis::farthest_corner(std::move(arms));
    } else {
      at.linear = std::max(high, -low);
      at.nominal = quantity.offset.empty() ? 0 : quantity.offset[s];
    }
    return at;
  }

  void contribute(std::size_t q, ToleranceFigures& result) const {
    double total = 0;
    for (std::size_t i = 0; i < toleranced_.dimensions.size(); ++i) {
      Contribution one{.dimension = toleranced_.dimensions[i].name};
      for (std::size_t s = 0; s < question_.stations.size(); ++s) {
        const Vec2d& rate = table_->rates(s, q)[i];
        const double size = norm(rate);
        if (size > std::abs(one.largest)) {
          one.largest = result.is_point ? size : rate.x;
          one.largest_at = s;
        }
        if (s == result.worst) one.sensitivity = result.is_point ? size : rate.x;
      }
      one.amount = std::abs(one.sensitivity) * toleranced_.dimensions[i].half_width();
      total += one.amount;
      result.contributions.push_back(std::move(one));
    }
    for (Contribution& one : result.contributions) one.share = total > 0 ? one.amount / total : 0;
    std::ranges::stable_sort(result.contributions, std::greater{}, &Contribution::amount);
  }

  const TolerancedMechanism& toleranced_;
  const ToleranceQuestion& question_;
  std::vector<synthesis::Interval> box_;
  std::vector<Response> responses_;
  std::optional<SensitivityTable> table_;
};

/// That exact and linear worst case are far from each other.
void note_nonlinear(const ToleranceFigures& figures, std::vector<std::string>& notes) {
  const PositionFigures& at = figures.positions[figures.worst_exact];
  if (!figures.exact || !std::isfinite(at.high)) return;
  const double exact = figures.is_point ? at.high : std::max(at.high, -at.low);
  // Where nothing is left of the exact one, the tolerances are rounding of the dimensions.
  if (!(exact > 0) || !(std::abs(exact - at.linear) > kNonlinear * exact)) return;
  notes.push_back(fmt::format(
      "{}: the worst case of first order is {:+.1f} % off the exact one where that is greatest; "
      "trust the exact figures",
      figures.name, 100 * (at.linear - exact) / exact));
}

/// Of which quantities the exact worst case is not known, unless a dead point is why.
void note_inexact(const std::vector<ToleranceFigures>& all, std::vector<std::string>& notes) {
  std::vector<std::string> names;
  for (const ToleranceFigures& figures : all) {
    if (!figures.exact) names.push_back(figures.name);
  }
  if (names.empty()) return;
  notes.push_back(fmt::format(
      "{}: the exact worst case was not found within the effort allowed, only that of first order",
      fmt::join(names, ", ")));
}

/// From radians to degrees.
void to_degrees(ToleranceFigures& figures) {
  if (!figures.angle) return;
  constexpr double k = 180 / kPi;
  for (PositionFigures& at : figures.positions) {
    for (double PositionFigures::*of :
         {&PositionFigures::nominal, &PositionFigures::linear, &PositionFigures::low,
          &PositionFigures::high, &PositionFigures::rss, &PositionFigures::mean,
          &PositionFigures::sigma}) {
      at.*of *= k;
    }
  }
  for (Contribution& one : figures.contributions) {
    one.sensitivity *= k;
    one.largest *= k;
    one.amount *= k;
  }
  for (Quantile& quantile : figures.quantiles) quantile.error *= k;
  for (double& edge : figures.histogram_edges) edge *= k;
  figures.mean_extreme *= k;
}

void to_degrees(ToleranceResult& result, bool judged_angle) {
  for (ToleranceFigures& figures : result.quantities) to_degrees(figures);
  if (!judged_angle) return;
  constexpr double k = 180 / kPi;
  for (ClearanceFigures& pin : result.clearances) {
    pin.massless *= k;
    if (pin.loaded) *pin.loaded *= k;
  }
  if (result.clearance_linear) *result.clearance_linear *= k;
  if (result.allocation_error) *result.allocation_error *= k;
}

/// The judged quantity; empty where there is none.
std::optional<std::size_t> judged_of(const ToleranceQuestion& question) {
  for (std::size_t q = 0; q < question.quantities.size(); ++q) {
    if (question.quantities[q].judged) return q;
  }
  return std::nullopt;
}

}  // namespace

Response ToleranceQuantity::scalar(std::size_t station) const {
  if (normal.empty()) return response;
  Response along = response;
  along.type = ResponseType::along;
  along.direction = normal[station];
  return along;
}

void add_stations(const Mechanism<double>& mechanism, const AssemblyRanges& ranges,
                  std::span<const double> drives, std::vector<double>& kept,
                  std::vector<Station>& stations) {
  constexpr double kOnChange = 1e-9;
  ChangedMechanism<double> closing({mechanism, {}});
  for (const double drive : drives) {
    const AssemblyRange* range = ranges.range_at(drive);
    if (range == nullptr) continue;
    const bool on_change = std::ranges::any_of(range->changes, [&](const Change& change) {
      return std::abs(change.drive - drive) <= kOnChange * ranges.scale;
    });
    if (on_change) continue;
    Station station{drive_position(mechanism, drive), sides_at(*range, drive)};
    closing.move_to(station);
    const bool closes = std::ranges::all_of(
        closing.closures(), [](const auto& closure) { return closure.discriminant > 0; });
    if (!closes) continue;
    kept.push_back(drive);
    stations.push_back(std::move(station));
  }
}

Response travel_response(const Mechanism<double>& mechanism, int body) {
  const Travel travel = travels(mechanism)[static_cast<std::size_t>(body)];
  Response response;
  response.index = static_cast<std::size_t>(body);
  if (travel.slides) {
    response.type = ResponseType::displacement;
    response.slide = travel.pair;
  }
  return response;
}

ToleranceResult tolerance_figures(const NamedMechanism& mechanism, const Tolerances& tolerances,
                                  std::optional<LengthUnit> unit, const ToleranceQuestion& question,
                                  const ToleranceRun& run) {
  ToleranceResult result;
  result.drive_slides = is_drive_slider(mechanism);
  if (const auto name = unknown_dimension(mechanism, tolerances)) {
    result.refused = fmt::format("tolerance.{} is no dimension of this mechanism", *name);
    return result;
  }
  const auto toleranced = problems::toleranced(mechanism, tolerances, unit);
  if (!toleranced) {
    result.refused = toleranced.error().reason;
    return result;
  }
  for (const auto& [name, nominal, deviation, is_length] : toleranced->dimensions) {
    result.dimensions.push_back({name, nominal, deviation.plus, deviation.minus});
  }
  for (const double drive : question.drive) {
    result.drive.push_back(shown_drive(mechanism, drive));
  }
  if (question.stations.empty()) {
    result.refused = "the mechanism can be assembled at none of its positions";
    return result;
  }
  if (question.left_out > 0) {
    result.refused = fmt::format(
        "at {} of {} positions the nominal mechanism stands at a dead point or beyond one, where "
        "any change of a dimension may end the motion: sensitivities, worst cases and quantiles do "
        "not exist",
        question.left_out, question.left_out + question.stations.size());
    return result;
  }
  const auto judged = judged_of(question);
  const bool judged_angle = judged && is_angular(question.quantities[*judged].response.type);
  FigureMaker maker(*toleranced, question);
  const auto dead =
      dead_point_within(toleranced->mechanism, question.motion, question.motion_drive, maker.box());
  const bool smooth = !(dead && dead->nominal);
  if (!smooth) result.refused = dead_point_refusal(mechanism, *dead);
  if (dead && !dead->nominal) result.notes.push_back(dead_point_note(mechanism, *dead));
  if (smooth) {
    maker.differentiate();
    for (std::size_t q = 0; q < question.quantities.size(); ++q) {
      result.quantities.push_back(maker.figures(q));
      note_nonlinear(result.quantities.back(), result.notes);
    }
    if (!dead) note_inexact(result.quantities, result.notes);
    if (judged) {
      add_clearances(mechanism, tolerances, question, *judged, result);
      add_allocation(*toleranced, tolerances, question, *judged, maker.table(), result);
    }
  }
  add_samples(*toleranced, tolerances, question, run, result);
  to_degrees(result, judged_angle);
  return result;
}

}  // namespace cognate::problems
