#include "problems/chain/placed_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "synthesis/chain/bodies.hpp"
#include "synthesis/chain/sweep.hpp"

namespace cognate::problems {
namespace {

constexpr int kSteps = 4;
constexpr std::size_t kUnknowns = 4;  ///< turn and shift
constexpr double kMostTurned = 0.2;   ///< radians that the crank turns at a point in one step
constexpr double kStill = 1e-9;       ///< of the target: a slower point stands

using Four = std::array<double, kUnknowns>;

/// Σ (row·x − right)² → min, by its normal equations.
class NormalEquations {
 public:
  void add(const Four& row, double right) {
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      for (std::size_t k = 0; k < kUnknowns; ++k) matrix_[i][k] += row[i] * row[k];
      right_[i] += row[i] * right;
    }
  }

  /// Gaussian elimination, which a positive definite matrix needs no pivots for.
  Four solved() {
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      for (std::size_t k = i + 1; k < kUnknowns; ++k) {
        const double factor = matrix_[k][i] / matrix_[i][i];
        for (std::size_t j = i; j < kUnknowns; ++j) matrix_[k][j] -= factor * matrix_[i][j];
        right_[k] -= factor * right_[i];
      }
    }
    Four x{};
    for (std::size_t i = kUnknowns; i-- > 0;) {
      double rest = right_[i];
      for (std::size_t j = i + 1; j < kUnknowns; ++j) rest -= matrix_[i][j] * x[j];
      x[i] = rest / matrix_[i][i];
    }
    return x;
  }

 private:
  std::array<Four, kUnknowns> matrix_{};
  Four right_{};
};

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
    NormalEquations equations;
    for (std::size_t j = 0; j < reached_.size(); ++j) {
      const Vec2d tangent = chain_.at.turn * speed_[j];
      const double speed = norm(tangent);
      if (speed < kStill) continue;
      const Vec2d normal = (1 / speed) * perp(tangent);
      equations.add({dot(normal, reached_[j]), dot(normal, perp(reached_[j])), normal.x, normal.y},
                    -dot(normal, error(j)));
    }
    const Four change = equations.solved();
    if (!std::ranges::all_of(change, [](double x) { return std::isfinite(x); })) return false;
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
