#include "problems/chain/model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/free_chain.hpp"

namespace cognate::problems {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Derivatives of a point that a target's place moves, along `direction`, by that place.
void add_place_slopes(const Vec2d& direction, const Vec2d& reached, double* place) {
  place[0] = dot(direction, reached);
  place[1] = dot(direction, perp(reached));
  place[2] = direction.x;
  place[3] = direction.y;
}

}  // namespace

ChainPathModel::ChainPathModel(const ScaledChain& problem, const synthesis::ChainDesign& design,
                               std::vector<double> angles, const TargetPlace& at,
                               std::vector<TransmissionCheck> checks, double margin)
    : problem_(problem),
      design_(design),
      angles_(std::move(angles)),
      side_(design.side.begin(), design.side.end()),
      at_(at),
      checks_(std::move(checks)),
      cosine_limit_(problem.cosine_limit - margin) {
  add_variables();
  for (std::size_t j = 0; !problem.timed() && j < problem.points.size(); ++j) {
    locals_.insert(locals_.end(), stride(), static_cast<int>(j));
  }
}

void ChainPathModel::add_variables() {
  for (const int parameter : problem_.free) {
    const auto i = static_cast<std::size_t>(parameter);
    const double size = std::max(0.1, std::abs(design_.parameters[i]));
    variables_.push_back(
        {fmt::format("parameter {}", parameter), problem_.lower[i], problem_.upper[i], size});
  }
  if (problem_.timed()) {
    variables_.push_back({"phase", angles_[0] - kTurn, angles_[0] + kTurn, 1});
    return;
  }
  if (problem_.is_movable) {
    for (const char* name : {"turn x", "turn y", "shift x", "shift y"}) {
      variables_.push_back({name, -kUnbounded, kUnbounded, 1});
    }
  }
  const std::size_t count = angles_.size();
  const double sense = angles_.back() >= angles_.front() ? 1 : -1;
  for (std::size_t j = 0; j < count; ++j) {
    const double here = sense * angles_[j];
    const double seam = problem_.closed ? kTurn : 2 * kTurn;
    const double before = j > 0 ? sense * angles_[j - 1] : sense * angles_[count - 1] - seam;
    const double after = j + 1 < count ? sense * angles_[j + 1] : sense * angles_[0] + seam;
    double low = 0.5 * (before + here), high = 0.5 * (here + after);
    if (sense < 0) std::tie(low, high) = std::pair(-high, -low);
    variables_.push_back({fmt::format("crank angle {}", j), low, high, 1});
  }
}

int ChainPathModel::local_count() const {
  return problem_.timed() ? 0 : static_cast<int>(problem_.points.size());
}

std::vector<double> ChainPathModel::start() const {
  std::vector<double> x;
  for (const int parameter : problem_.free) {
    const auto i = static_cast<std::size_t>(parameter);
    x.push_back(std::clamp(design_.parameters[i], problem_.lower[i], problem_.upper[i]));
  }
  if (problem_.is_movable) {
    x.insert(x.end(), {at_.turn.x, at_.turn.y, at_.shift.x, at_.shift.y});
  }
  x.insert(x.end(), angles_.begin(), angles_.end());
  return x;
}

synthesis::ChainDesign ChainPathModel::design(std::span<const double> x) const {
  synthesis::ChainDesign found = design_;
  for (std::size_t i = 0; i < problem_.free.size(); ++i) {
    found.parameters[static_cast<std::size_t>(problem_.free[i])] = x[i];
  }
  return found;
}

std::vector<double> ChainPathModel::angles(std::span<const double> x) const {
  const std::size_t before =
      problem_.free.size() + (problem_.is_movable ? TargetPlace::kNumbers : 0);
  return {x.begin() + static_cast<std::ptrdiff_t>(before), x.end()};
}

TargetPlace ChainPathModel::target_place(std::span<const double> x) const {
  if (!problem_.is_movable) return at_;
  const auto own = x.subspan(problem_.free.size(), TargetPlace::kNumbers);
  return {{own[0], own[1]}, {own[2], own[3]}};
}

std::size_t ChainPathModel::global_count() const {
  return problem_.free.size() + (problem_.timed() ? 1 : 0) +
         (problem_.is_movable ? TargetPlace::kNumbers : 0);
}

/// One residual's derivatives: by the unknowns before the crank angles, and by the latter.
struct ChainPathModel::Row {
  double* global;
  double* turn;
};

bool ChainPathModel::residuals(std::span<const double> x, std::span<double> r,
                               std::span<double> jacobian, std::span<double> local) const {
  const synthesis::ChainDesign here = design(x);
  FreeChain chain(problem_, here.parameters, side_);
  const std::size_t unknowns = problem_.free.size(), points = problem_.points.size();
  const std::size_t columns = global_count();
  const TargetPlace target = target_place(x);
  const double weight = 1 / std::sqrt(double(points));
  const int trace = problem_.topology->trace;
  const bool has_slopes = !jacobian.empty() || !local.empty();
  const auto row = [&](std::size_t i) {
    double* own = jacobian.data() + i * columns;
    return Row{own, problem_.timed() ? own + unknowns : local.data() + i};
  };
  for (std::size_t j = 0; j < points; ++j) {
    const double crank = problem_.timed() ? x[unknowns] + problem_.crank_angles[j] : x[columns + j];
    const Vec2d reached = chain.at(crank)[trace];
    const Vec2d error = weight * (target.point(reached) - problem_.points[j]);
    if (!is_finite(error)) return false;
    const std::size_t first = stride() * j;
    r[first] = error.x;
    r[first + 1] = error.y;
    for (std::size_t axis = 0; has_slopes && axis < 2; ++axis) {
      const Vec2d direction = axis == 0 ? Vec2d{weight, 0} : Vec2d{0, weight};
      const Row own = row(first + axis);
      *own.turn = chain.slope(trace, conj(target.turn) * direction, own.global);
      if (problem_.is_movable) add_place_slopes(direction, reached, own.global + unknowns);
    }
    if (!problem_.is_motion()) continue;
    const double turn_weight = weight * problem_.headings.weight;
    r[first + 2] =
        turn_weight * chain.turned(problem_.headings.line, problem_.headings.directions[j]);
    if (!has_slopes) continue;
    const Row own = row(first + 2);
    *own.turn = chain.heading_slope(problem_.headings.line, turn_weight, own.global);
  }
  return true;
}

void ChainPathModel::constraints(std::span<const double> x, std::span<double> c,
                                 std::span<double> jacobian) const {
  const synthesis::ChainDesign here = design(x);
  FreeChain chain(problem_, here.parameters, side_);
  transmission_constraints(chain, cosine_limit_, checks_, global_count(), c, jacobian);
}

}  // namespace cognate::problems
