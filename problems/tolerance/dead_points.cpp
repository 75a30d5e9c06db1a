#include "problems/tolerance/dead_points.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "synthesis/tolerance/worst_case.hpp"

namespace cognate::problems {
namespace {

/// Of the greatest discriminant of the motion: links are in line but for rounding.
constexpr double kInLine = 1e-12;
constexpr int kGoldenSteps = 40;

/// The discriminants of a nominal mechanism over its motion.
class Discriminants {
 public:
  explicit Discriminants(const AffineMechanism& mechanism)
      : mechanism_(mechanism), changed_(mechanism.nominal()) {}

  double at(std::size_t dyad, const Station& station) {
    changed_.move_to(station);
    return changed_.closures()[dyad].discriminant;
  }

  double at(std::size_t dyad, double drive, const Station& like) {
    return at(dyad, station(drive, like));
  }

  Station station(double drive, const Station& like) const {
    return {drive_position(mechanism_.nominal().mechanism, drive), like.sides};
  }

 private:
  const AffineMechanism& mechanism_;
  ChangedMechanism<double> changed_;
};

/// Whether a dyad can come to a dead point: the sine of guides that the dimensions do not turn
/// cannot vanish.
bool has_dead_points(const Dyad<double>& dyad) {
  return !std::holds_alternative<Prp<double>>(dyad) && !std::holds_alternative<Rpp<double>>(dyad);
}

}  // namespace

std::optional<DeadPoint> dead_point_within(const AffineMechanism& mechanism,
                                           std::span<const Station> motion,
                                           std::span<const double> drive,
                                           std::span<const synthesis::Interval> box) {
  Discriminants discriminants(mechanism);
  const auto& dyads = mechanism.nominal().mechanism.dyads;
  for (std::size_t dyad = 0; dyad < dyads.size(); ++dyad) {
    if (!has_dead_points(dyads[dyad])) continue;
    Response closure;
    closure.type = ResponseType::closure;
    closure.index = dyad;
    std::vector<double> value;
    for (const Station& station : motion) value.push_back(discriminants.at(dyad, station));
    const double size = value.empty() ? 0 : std::ranges::max(value);
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const bool low_before = k > 0 && value[k - 1] < value[k];
      const bool low_after = k + 1 < motion.size() && value[k + 1] < value[k];
      if (low_before || low_after) continue;
      const std::size_t from = k > 0 ? k - 1 : k;
      const std::size_t to = k + 1 < motion.size() ? k + 1 : k;
      const GoldenBracket least =
          golden_section([&](double at) { return discriminants.at(dyad, at, motion[k]); },
                         drive[from], drive[to], kGoldenSteps);
      const bool between = least.least() < value[k];
      const double place = between ? least.middle() : drive[k];
      const Station station = discriminants.station(place, motion[k]);
      const double nominal = discriminants.at(dyad, station);
      if (!(nominal > kInLine * size)) return DeadPoint{dyad, place, true};
      const auto worst = synthesis::worst_case(mechanism, closure, station, box);
      if (!worst || nominal + worst->low <= 0) return DeadPoint{dyad, place, false};
    }
  }
  return std::nullopt;
}

}  // namespace cognate::problems
