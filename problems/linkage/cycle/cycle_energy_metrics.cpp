/// The steady motion of a finished linkage: work by quadrature of torques over the turn, and the
/// energy that it begins with by a search for the mean speed.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/cycle/cycle_scan.hpp"
#include "problems/linkage/cycle/linkage_dynamics.hpp"

namespace cognate::problems {
namespace {

struct EnergyState {
  double inertia = 0;
  double work = 0;
};

/// Inertia and work at any crank angle of the turn.
class CycleOfWork {
 public:
  CycleOfWork(const FourBar& linkage, const Operation& operation)
      : dynamics_(linkage, operation), scan_{frame_angle(linkage)} {
    for (int k = 0; k < CycleScan::kAngles; ++k) {
      works_.at(index(k + 1)) =
          works_.at(index(k)) + work_between(scan_.angle(k), scan_.angle(k + 1));
    }
    drive_ = -works_.back() / (CycleScan::kStep * CycleScan::kAngles);
  }

  bool is_known() const { return std::isfinite(drive_); }

  const CycleScan& scan() const { return scan_; }

  /// Not numbers where the linkage does not close.
  EnergyState at(double angle) {
    const double turned = angle - scan_.begin;
    const int k =
        std::clamp(static_cast<int>(std::lround(turned / CycleScan::kStep)), 0, CycleScan::kAngles);
    const double before = works_.at(index(k)) + work_between(scan_.angle(k), angle);
    if (!dynamics_.move_to(angle)) return {kNone, kNone};
    return {dynamics_.inertia(), before + drive_ * turned};
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  static std::size_t index(int k) { return static_cast<std::size_t>(k); }

  double rocker_rate(double angle) {
    return dynamics_.move_to(angle) ? dynamics_.rocker_rate() : kNone;
  }

  /// Of loads and weights. Where the rocker turns back, a load may set in or cease.
  double work_between(double from, double to) {
    if (from == to) return 0;
    const auto rate = [&](double angle) { return rocker_rate(angle); };
    const double first = rate(from), last = rate(to);
    if (!(first * last < 0)) return smooth_work(from, to);
    const double turning = from < to ? bracket_zero(rate, from, first, to, last).first
                                     : bracket_zero(rate, to, last, from, first).first;
    return smooth_work(from, turning) + smooth_work(turning, to);
  }

  /// By Gauss's rule of three places.
  double smooth_work(double from, double to) {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    const double reach = half * std::sqrt(0.6);
    const auto torque = [&](double angle) {
      return dynamics_.move_to(angle) ? dynamics_.working_torque() : kNone;
    };
    return half / 9 *
           (5 * torque(middle - reach) + 8 * torque(middle) + 5 * torque(middle + reach));
  }

  LinkageDynamics dynamics_;
  CycleScan scan_;
  std::array<double, CycleScan::kAngles + 1> works_{};
  double drive_ = 0;
};

/// The motion of a given energy at the beginning.
class SteadyMotion {
 public:
  SteadyMotion(CycleOfWork& work, double flywheel) : work_(work), flywheel_(flywheel) {
    for (int k = 0; k < CycleScan::kAngles; ++k) {
      table_.at(static_cast<std::size_t>(k)) = at(work_.scan().angle(k));
    }
  }

  /// The greatest speed with the sign 1, the least with −1.
  double extreme(double energy, double sign) {
    const auto speed = [&](const EnergyState& state) {
      const double square = 2 * (energy + state.work) / state.inertia;
      return std::copysign(std::sqrt(std::abs(square)), square);
    };
    CycleScan::Values values{};
    std::ranges::transform(table_, values.begin(),
                           [&](const EnergyState& state) { return -sign * speed(state); });
    return -sign *
           work_.scan().least(values, [&](double angle) { return -sign * speed(at(angle)); });
  }

  /// The energy of a mean speed, which grows with it.
  std::optional<double> energy_of(double mean) {
    double low = kInfinity, high = -kInfinity, least = kInfinity, most = 0;
    for (const auto& [inertia, work] : table_) {
      low = std::min(low, -work);
      high = std::max(high, -work);
      least = std::min(least, inertia);
      most = std::max(most, inertia);
    }
    if (!(least > 0) || !std::isfinite(high - low)) return std::nullopt;
    // With less than this all speeds are below the mean, with more above it.
    const double margin = 1e-3 * (0.5 * mean * mean * most + high - low);
    low += 0.5 * mean * mean * least - margin;
    high += 0.5 * mean * mean * most + margin;
    const auto excess = [&](double energy) {
      return 0.5 * (extreme(energy, 1) + extreme(energy, -1)) - mean;
    };
    const double at_low = excess(low), at_high = excess(high);
    if (!(at_low < 0 && at_high > 0)) return std::nullopt;
    return bracket_zero(excess, low, at_low, high, at_high).first;
  }

 private:
  EnergyState at(double angle) {
    EnergyState state = work_.at(angle);
    state.inertia += flywheel_;
    return state;
  }

  CycleOfWork& work_;
  double flywheel_;
  std::array<EnergyState, CycleScan::kAngles> table_;
};

}  // namespace

double speed_fluctuation(const FourBar& linkage, const Operation& operation) {
  CycleOfWork work(linkage, operation);
  if (!work.is_known()) return kInfinity;
  SteadyMotion motion(work, operation.flywheel);
  const double mean = std::abs(operation.speed);
  const auto energy = motion.energy_of(mean);
  if (!energy) return kInfinity;
  return (motion.extreme(*energy, 1) - motion.extreme(*energy, -1)) / mean;
}

double flywheel_inertia(const FourBar& linkage, const Operation& operation) {
  CycleOfWork work(linkage, operation);
  if (!work.is_known()) return kInfinity;
  const double mean = std::abs(operation.speed), fluctuation = operation.fluctuation;
  /// How far W − ½ J ω² falls.
  const auto least = [&](double speed, double sign) {
    return work.scan().least([&](double angle) {
      const EnergyState state = work.at(angle);
      return sign * (state.work - 0.5 * speed * speed * state.inertia);
    });
  };
  const double lacking =
      -least(mean * (1 - fluctuation / 2), 1) - least(mean * (1 + fluctuation / 2), -1);
  return std::max(0., lacking / (fluctuation * mean * mean));
}

}  // namespace cognate::problems
