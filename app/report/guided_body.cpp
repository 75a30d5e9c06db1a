#include "app/report/guided_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/mechanism/kinematics.hpp"
#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::app {
namespace {

using synthesis::Pose;
using Places = std::vector<std::optional<Pose>>;

/// For each body where it stands at each of `stations`.
std::vector<Places> places_of_bodies(const Mechanism<double>& mechanism,
                                     std::span<const double> stations) {
  MechanismMotion<0> motion(mechanism);
  std::vector<Places> all(motion.bodies().size());
  for (const double station : stations) {
    const bool closes = motion.move_to(station);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto& body = motion.bodies()[i];
      const double angle = std::atan2(body.direction.y, body.direction.x);
      all[i].push_back(closes ? std::optional(Pose{body.origin[0], angle}) : std::nullopt);
    }
  }
  return all;
}

/// The target's axes in the body's: the mean over the stations.
Pose mean_in_body(const Places& places, std::span<const Pose> targets) {
  Vec2d at{}, direction{};
  double count = 0;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    if (!places[k]) continue;
    const double turn = targets[k].angle - places[k]->angle;
    at = at + to_body(*places[k], targets[k].at);
    direction = direction + Vec2d{std::cos(turn), std::sin(turn)};
    ++count;
  }
  return {(1 / count) * at, std::atan2(direction.y, direction.x)};
}

/// The greatest distance of the targets' origins from where the body takes them, and of points that
/// lie `arm` away from these.
double misfit(const Places& places, std::span<const Pose> targets, const Pose& in_body,
              double arm) {
  double worst = 0;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    if (!places[k]) continue;
    const Vec2d away = to_frame(*places[k], in_body.at) - targets[k].at;
    const double turn =
        std::remainder(places[k]->angle + in_body.angle - targets[k].angle, 2 * std::acos(-1.0));
    worst = std::max({worst, std::hypot(away.x, away.y), arm * std::abs(turn)});
  }
  return worst;
}

}  // namespace

std::optional<GuidedBody> guided_body(const problems::NamedMechanism& mechanism,
                                      std::span<const double> stations,
                                      std::span<const Pose> targets, std::optional<int> known) {
  if (stations.size() != targets.size() || targets.empty()) return std::nullopt;
  const auto all = places_of_bodies(mechanism.mechanism, stations);
  const double arm = std::max(synthesis::extent(targets), std::numeric_limits<double>::min());
  std::optional<GuidedBody> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t body = 1; body < all.size(); ++body) {
    if (known.value_or(static_cast<int>(body)) != static_cast<int>(body)) continue;
    if (std::ranges::none_of(all[body], [](const auto& place) { return place.has_value(); })) {
      continue;
    }
    const Pose in_body = mean_in_body(all[body], targets);
    const double away = misfit(all[body], targets, in_body, arm);
    if (!(away < least)) continue;
    least = away;
    best = GuidedBody{static_cast<int>(body), all[body], in_body};
  }
  return best;
}

}  // namespace cognate::app
