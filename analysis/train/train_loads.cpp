#include "analysis/train/train_loads.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cognate::train {
namespace {

/// Below this share of the greatest power a mesh passes none, but rounding.
constexpr double kRounding = 1e-11;
/// Of more meshes not every combination of senses is tried.
constexpr std::size_t kMostTried = 12;
constexpr int kMostSteps = 40;

/// Pivots below this are rounding, rows being of order 1.
constexpr double kSingular = 1e-13;

/// x of a·x = b; empty where `a` is singular to rounding.
std::optional<Eigen::VectorXd> solved(Eigen::MatrixXd a, Eigen::VectorXd b) {
  const Eigen::VectorXd greatest = a.rowwise().lpNorm<Eigen::Infinity>();
  if (!(greatest.array() > 0).all()) return std::nullopt;
  b.array() /= greatest.array();
  a = greatest.cwiseInverse().asDiagonal() * a;
  const Eigen::FullPivLU<Eigen::MatrixXd> factors =
      Eigen::FullPivLU<Eigen::MatrixXd>(a).setThreshold(kSingular);
  if (!factors.isInvertible()) return std::nullopt;
  return factors.solve(b);
}

class Balance {
 public:
  Balance(const GearTrain& train, const std::vector<double>& speeds,
          const std::vector<KnownTorque>& known, const std::vector<int>& unknown)
      : train_(train), speeds_(speeds), known_(known), unknown_(unknown) {}

  /// With the power of mesh k flowing from its first gear to its second where `senses[k]` is 1, the
  /// other way where it is −1, and no loss where it is 0.
  std::optional<TrainLoads> loads(const std::vector<int>& senses) const {
    const int members = train_.members;
    if (train_.conditions() + unknown_.size() != static_cast<std::size_t>(members)) {
      return std::nullopt;
    }
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(members, members);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(members);
    Eigen::Index column = 0;
    const auto put = [&](int member, double coefficient) {
      if (member != kFrame) a(member, column) += coefficient;
    };
    for (std::size_t k = 0; k < train_.meshes.size(); ++k, ++column) {
      const Mesh& mesh = train_.meshes[k];
      const double passed = passed_on(mesh, senses[k]);
      put(mesh.gears[0], 1);
      put(mesh.gears[1], passed);
      put(mesh.carrier, -1 - passed);
    }
    for (const auto& [one, other] : train_.joined) {
      put(one, 1);
      put(other, -1);
      ++column;
    }
    for (const int member : train_.fixed) {
      put(member, 1);
      ++column;
    }
    for (const int member : unknown_) {
      put(member, 1);
      ++column;
    }
    for (const auto& [member, torque] : known_) b[member] -= torque;
    const auto x = solved(std::move(a), std::move(b));
    return x ? std::optional(made_of(*x, senses)) : std::nullopt;
  }

  /// The sense of the power in `loads` through each mesh.
  std::vector<int> senses_of(const TrainLoads& loads) const {
    double greatest = 0;
    for (const double power : loads.power) greatest = std::max(greatest, std::abs(power));
    for (int i = 0; i < train_.members; ++i) {
      const auto at = static_cast<std::size_t>(i);
      greatest = std::max(greatest, std::abs(loads.external[at] * speeds_[at]));
    }
    std::vector<int> senses;
    for (const double power : loads.power) {
      senses.push_back(std::abs(power) <= kRounding * greatest ? 0 : power > 0 ? 1 : -1);
    }
    return senses;
  }

 private:
  /// The torque on the second gear for a torque of 1 on the first.
  static double passed_on(const Mesh& mesh, int sense) {
    const double kept = sense > 0 ? mesh.efficiency : sense < 0 ? 1 / mesh.efficiency : 1;
    return -double(mesh.signed_teeth()) / mesh.teeth[0] * kept;
  }

  double speed(int member) const {
    return member == kFrame ? 0 : speeds_[static_cast<std::size_t>(member)];
  }

  TrainLoads made_of(const Eigen::VectorXd& x, const std::vector<int>& senses) const {
    TrainLoads loads;
    loads.external.assign(static_cast<std::size_t>(train_.members), 0.0);
    auto next = x.begin();
    for (std::size_t k = 0; k < train_.meshes.size(); ++k) {
      const Mesh& mesh = train_.meshes[k];
      const double torque = *next++, carrier = speed(mesh.carrier);
      const double power = -torque * (speed(mesh.gears[0]) - carrier);
      const double passed = torque * passed_on(mesh, senses[k]) * (speed(mesh.gears[1]) - carrier);
      loads.torque.push_back(torque);
      loads.power.push_back(power);
      loads.loss.push_back(std::max(0.0, power - passed));
    }
    loads.clutch.assign(next, next + std::ssize(train_.joined));
    next += std::ssize(train_.joined);
    for (const int member : train_.fixed)
      loads.external[static_cast<std::size_t>(member)] += *next++;
    for (const int member : unknown_) loads.external[static_cast<std::size_t>(member)] += *next++;
    for (const auto& [member, torque] : known_) {
      loads.external[static_cast<std::size_t>(member)] += torque;
    }
    return loads;
  }

  const GearTrain& train_;
  const std::vector<double>& speeds_;
  const std::vector<KnownTorque>& known_;
  const std::vector<int>& unknown_;
};

bool agree(const std::vector<int>& assumed, const std::vector<int>& found) {
  for (std::size_t k = 0; k < assumed.size(); ++k) {
    if (found[k] != 0 && found[k] != assumed[k]) return false;
  }
  return true;
}

/// The bits of `number` as senses of the meshes.
std::vector<int> senses_of_number(std::uint32_t number, std::size_t count) {
  std::vector<int> senses;
  for (std::size_t k = 0; k < count; ++k) senses.push_back((number >> k) & 1U ? -1 : 1);
  return senses;
}

}  // namespace

std::optional<TrainLoads> loads_of(const GearTrain& train, const std::vector<double>& speeds,
                                   const std::vector<KnownTorque>& known,
                                   const std::vector<int>& unknown) {
  const Balance balance(train, speeds, known, unknown);
  const std::size_t count = train.meshes.size();
  std::vector<int> senses(count, 0);
  for (int step = 0; step < kMostSteps; ++step) {
    const auto loads = balance.loads(senses);
    if (!loads) break;
    const auto found = balance.senses_of(*loads);
    if (agree(senses, found)) return loads;
    senses = found;
  }
  if (count > kMostTried) return std::nullopt;
  for (std::uint32_t number = 0; number < (1U << count); ++number) {
    senses = senses_of_number(number, count);
    const auto loads = balance.loads(senses);
    if (loads && agree(senses, balance.senses_of(*loads))) return loads;
  }
  return std::nullopt;
}

}  // namespace cognate::train
