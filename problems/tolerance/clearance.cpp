#include "problems/tolerance/clearance.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/joints.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "problems/mechanism/joint_names.hpp"
#include "problems/tolerance/dimensions.hpp"

namespace cognate::problems {
namespace {

using Loads = std::vector<Load>;

/// What works as a unit moment on the direction between two points: a moment on the body of both,
/// else a couple.
Loads unit_moment(const Mechanism<double>& mechanism, const Attached<double>& from,
                  const Attached<double>& to, std::span<const BodyMotion<double, 1>> bodies) {
  if (const auto body = common_body(mechanism, from, to)) {
    return {{.at = {*body, {}}, .force = {}, .torque = 1}};
  }
  const auto place = [&](const Attached<double>& point) {
    const auto& body = bodies[static_cast<std::size_t>(point.body)];
    return body.origin[0] + body.direction * point.at;
  };
  const Vec2d way = place(to) - place(from);
  const Vec2d force = (1 / squared_norm(way)) * perp(way);
  Loads loads;
  if (to.body != 0) loads.push_back({.at = to, .force = force, .torque = 0});
  if (from.body != 0) loads.push_back({.at = from, .force = -1.0 * force, .torque = 0});
  return loads;
}

/// Unit loads on what is judged; of a point one along each axis.
std::vector<Loads> unit_loads(const NamedMechanism& mechanism, const Response& response,
                              std::span<const BodyMotion<double, 1>> bodies) {
  switch (response.type) {
    case ResponseType::angle:
      return {{{.at = {static_cast<int>(response.index), {}}, .force = {}, .torque = 1}}};
    case ResponseType::direction:
      return {unit_moment(mechanism.mechanism, mechanism.points[response.index].at,
                          mechanism.points[response.to].at, bodies)};
    case ResponseType::displacement: {
      const auto& guide = bodies[static_cast<std::size_t>(response.slide.through.body)];
      return {{{.at = {response.slide.slider, {}},
                .force = guide.direction * response.slide.direction,
                .torque = 0}}};
    }
    case ResponseType::along:
      return {
          {{.at = mechanism.points[response.index].at, .force = response.direction, .torque = 0}}};
    case ResponseType::point: {
      const Attached<double>& at = mechanism.points[response.index].at;
      return {{{.at = at, .force = {1, 0}, .torque = 0}},
              {{.at = at, .force = {0, 1}, .torque = 0}}};
    }
    default:
      return {};
  }
}

/// Reactions of every joint under each unit load, at one station.
class UnitReactions {
 public:
  explicit UnitReactions(const NamedMechanism& mechanism)
      : mechanism_(mechanism),
        bodies_(static_cast<std::size_t>(body_count(mechanism.mechanism))),
        closures_(mechanism.mechanism.dyads.size()),
        dynamics_(mechanism.mechanism, {}),
        forces_{dynamics_.forces(), dynamics_.forces()} {}

  /// How many loads there are; 0 where the forces are not determined.
  std::size_t find(const Response& response, const Station& station) {
    evaluate<1>(mechanism_.mechanism, station.drive, std::span<const double>(station.sides),
                std::span<BodyMotion<double, 1>>(bodies_),
                std::span<DyadClosure<double>>(closures_));
    const auto loads = unit_loads(mechanism_, response, bodies_);
    for (std::size_t k = 0; k < loads.size(); ++k) {
      const bool found = dynamics_.solve<1>(std::span<const BodyMotion<double, 1>>(bodies_), {},
                                            std::span<const Load>(loads[k]), forces_[k]);
      if (!found) return 0;
    }
    return loads.size();
  }

  Vec2d operator()(std::size_t load, std::size_t joint) const {
    return forces_[load].reactions[joint].force;
  }

 private:
  const NamedMechanism& mechanism_;
  std::vector<BodyMotion<double, 1>> bodies_;
  std::vector<DyadClosure<double>> closures_;
  InverseDynamics dynamics_;
  std::array<Forces, 2> forces_;
};

/// The greatest length of (r₁·o, r₂·o) with |o| = 1: the greater singular value of the rows.
double greatest_stretch(const Vec2d& r1, const Vec2d& r2) {
  const double sum = (squared_norm(r1) + squared_norm(r2)) / 2;
  const double difference = (squared_norm(r1) - squared_norm(r2)) / 2;
  return std::sqrt(sum + std::hypot(difference, dot(r1, r2)));
}

/// The change of a scalar, or the way of a point, that `offset` of the pin of `joint` makes.
Vec2d change(const UnitReactions& reactions, std::size_t loads, std::size_t joint,
             const Vec2d& offset) {
  return {-dot(reactions(0, joint), offset), loads == 2 ? -dot(reactions(1, joint), offset) : 0};
}

std::vector<std::size_t> joints_called(const std::string& name,
                                       const std::vector<std::string>& names) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) all.push_back(i);
  }
  return all;
}

/// That a pin has more play than the shortest length is long.
void note_loose(const NamedMechanism& mechanism, ToleranceResult& result) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const MechanismDimension& dimension : dimensions(mechanism)) {
    if (dimension.is_length && dimension.nominal > 0)
      shortest = std::min(shortest, dimension.nominal);
  }
  for (const ClearanceFigures& pin : result.clearances) {
    if (pin.radial < shortest) continue;
    result.notes.push_back(
        fmt::format("The clearance of {} is no less than the shortest length, {:.6g}: figures of "
                    "first order mean nothing there.",
                    pin.joint, shortest));
  }
}

}  // namespace

void add_clearances(const NamedMechanism& mechanism, const Tolerances& tolerances,
                    const ToleranceQuestion& question, std::size_t judged,
                    ToleranceResult& result) {
  if (tolerances.clearances.empty()) return;
  const ToleranceQuantity& quantity = question.quantities[judged];
  if (quantity.response.type == ResponseType::transmission) return;
  const std::vector<std::string> names = joint_names(mechanism);
  std::vector<std::vector<std::size_t>> joints;
  for (const auto& [joint, radial] : tolerances.clearances) {
    result.clearances.push_back({.joint = joint, .radial = radial});
    joints.push_back(joints_called(joint, names));
  }
  UnitReactions reactions(mechanism);
  double most = 0;
  for (std::size_t s = 0; s < question.stations.size(); ++s) {
    const std::size_t loads = reactions.find(quantity.scalar(s), question.stations[s]);
    if (loads == 0) continue;
    double sum = 0;
    for (std::size_t p = 0; p < joints.size(); ++p) {
      ClearanceFigures& pin = result.clearances[p];
      for (const std::size_t joint : joints[p]) {
        const double massless =
            pin.radial * (loads == 2 ? greatest_stretch(reactions(0, joint), reactions(1, joint))
                                     : norm(reactions(0, joint)));
        sum += massless;
        if (massless > pin.massless) {
          pin.massless = massless;
          pin.massless_at = s;
        }
        if (question.reactions.empty()) continue;
        const Vec2d force = question.reactions[s].reactions[joint].force;
        if (!(norm(force) > 0)) continue;
        const Vec2d moved = change(reactions, loads, joint, (-pin.radial / norm(force)) * force);
        if (norm(moved) >= std::abs(pin.loaded.value_or(0))) {
          pin.loaded = loads == 2 ? norm(moved) : moved.x;
          pin.loaded_at = s;
        }
      }
    }
    most = std::max(most, sum);
  }
  result.clearance_linear = most;
  note_loose(mechanism, result);
}

}  // namespace cognate::problems
