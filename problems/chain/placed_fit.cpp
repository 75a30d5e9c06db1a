#include "problems/chain/placed_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "synthesis/chain/bodies.hpp"
#include "synthesis/chain/sweep.hpp"

namespace cognate::problems {
namespace {

constexpr int kSteps = 4;
constexpr double kMostTurned = 0.2;  ///< radians that the crank turns at a point in one step
constexpr double kStill = 1e-9;      ///< of the target: a slower point stands

class PlaceFit {
 public:
  PlaceFit(const ScaledChain& problem, PlacedChain& chain)
      : problem_(problem),
        chain_(chain),
        side_(chain.design.side.begin(), chain.design.side.end()),
        view_{problem.lines.data(), static_cast<int>(problem.lines.size()),
              chain.design.parameters.data(), side_.data()},
        reached_(problem.points.size()),
        speed_(problem.points.size()) {}

  void run() {
    for (int step = 0; step < kSteps; ++step) {
      if (!look() || !improve()) return;
    }
    look();
  }

 private:
  /// Where the point is, and how fast; the objective. Whether all is assembled and allowed.
  bool look() {
    const auto trace = static_cast<std::size_t>(problem_.topology->trace);
    chain_.objective = std::numeric_limits<double>::infinity();
    double sum = 0;
    for (std::size_t j = 0; j < reached_.size(); ++j) {
      synthesis::place(view_, unit_vector(chain_.angles[j]), place_);
      reached_[j] = place_.at[trace];
      if (!is_finite(reached_[j]) || exceeds_limit()) return false;
      synthesis::move(view_, place_, 1.0, static_cast<const double*>(nullptr), velocity_.data());
      speed_[j] = velocity_[trace];
      sum += squared_norm(error(j));
    }
    chain_.objective = sum / double(reached_.size());
    return true;
  }

  bool exceeds_limit() {
    return std::ranges::any_of(problem_.joints, [&](int joint) {
      return std::abs(synthesis::transmission_cosine(view_, place_, joint)) > problem_.cosine_limit;
    });
  }

  Vec2d error(std::size_t j) const { return chain_.at.point(reached_[j]) - problem_.points[j]; }

  bool improve() {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t j = 0; j < reached_.size(); ++j) {
      const Vec2d tangent = chain_.at.turn * speed_[j];
      const double speed = norm(tangent);
      if (speed < kStill) continue;
      const Vec2d normal = (1 / speed) * perp(tangent);
      const Eigen::Vector4d row(dot(normal, reached_[j]), dot(normal, perp(reached_[j])), normal.x,
                                normal.y);
      matrix += row * row.transpose();
      right -= dot(normal, error(j)) * row;
    }
    const Eigen::Vector4d change = matrix.ldlt().solve(right);  // turn and shift
    if (!change.allFinite()) return false;
    chain_.at.turn = chain_.at.turn + Vec2d{change[0], change[1]};
    chain_.at.shift = chain_.at.shift + Vec2d{change[2], change[3]};
    for (std::size_t j = 0; j < reached_.size(); ++j) {
      const Vec2d tangent = chain_.at.turn * speed_[j];
      const double square = squared_norm(tangent);
      if (square < kStill * kStill) continue;
      chain_.angles[j] -= std::clamp(dot(tangent, error(j)) / square, -kMostTurned, kMostTurned);
    }
    return true;
  }

  const ScaledChain& problem_;
  PlacedChain& chain_;
  std::vector<double> side_;
  synthesis::ChainView<double> view_;
  synthesis::ChainPlace<double> place_;
  std::array<Vec2d, synthesis::kMostLines> velocity_{};
  std::vector<Vec2d> reached_, speed_;
};

}  // namespace

void fit_place(const ScaledChain& problem, PlacedChain& chain) {
  PlaceFit(problem, chain).run();
}

}  // namespace cognate::problems
