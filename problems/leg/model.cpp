#include "problems/leg/model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

constexpr Vec2d kAlong{1, 0}, kUp{0, 1};
/// Radians: half the distance of the central difference that the foot's speed is.
constexpr double kSpeedStep = 1e-3;
/// The stride, and the level of the stance's ends.
constexpr std::size_t kEqualities = 2;

}  // namespace

struct LegModel::Sum {
  std::size_t columns;
  double value = 0;
  double* row = nullptr;  ///< null: derivatives are not requested
  std::vector<double> own = std::vector<double>(row ? columns : 0);

  void add(double more, std::size_t column, double slope) {
    value += more;
    if (row) row[column] += slope;
  }

  /// Adds weight·(direction·P), P the point of a line, and returns its derivative by the crank's
  /// angle.
  double add_point(FreeChain& chain, int line, double weight, const Vec2d& direction,
                   double crank) {
    const Vec2d* at = chain.at(crank);
    value += weight * dot(direction, at[line]);
    if (!row) return 0;
    const double turn = weight * chain.slope(line, direction, own.data());
    for (std::size_t i = 0; i < columns; ++i) row[i] += weight * own[i];
    return turn;
  }
};

LegModel::LegModel(const LegSpace& space, const LegDesign& design, LegChecks checks, int nodes,
                   double unit, LegObjective objective)
    : space_(space),
      design_(design),
      side_(design.chain.side.begin(), design.chain.side.end()),
      checks_(std::move(checks)),
      unit_(unit),
      objective_(objective) {
  for (int i = 0; i < nodes; ++i) nodes_.push_back(0.5 - 0.5 * std::cos(kPi * i / (nodes - 1)));
  for (const int parameter : space.free) {
    const auto i = static_cast<std::size_t>(parameter);
    variables_.push_back({fmt::format("parameter {}", parameter), space.lower[i], space.upper[i],
                          std::max(0.1, std::abs(design.chain.parameters[i]))});
  }
  variables_.push_back({"start", design.start - kTurn, design.start + kTurn, 1});
  double least = 0, greatest = 0;
  FreeChain chain(space, design.chain.parameters, side_);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double level = chain.at(design.start + design.span * nodes_[i])[space.foot].y;
    least = i == 0 ? level : std::min(least, level);
    greatest = i == 0 ? level : std::max(greatest, level);
  }
  level_ = 0.5 * (least + greatest);
  variables_.push_back({"level", level_ - 10, level_ + 10, 1});
  if (finds_span()) {
    variables_.push_back({"span", kTurn * space.problem->target.duty, kTurn * kMostDuty, 1});
  }
}

int LegModel::residual_count() const {
  return finds_span() ? 1 : static_cast<int>(nodes_.size());
}

int LegModel::constraint_count() const {
  const auto bands = finds_span() ? 2 * nodes_.size() : 0;
  return equality_count() +
         static_cast<int>(2 * checks_.transmission.size() + checks_.swing.size() +
                          checks_.slow.size() + checks_.fast.size() + bands) +
         bool(space_.height_min) + bool(space_.height_max) +
         static_cast<int>(2 * space_.distances.size());
}

std::vector<double> LegModel::start() const {
  std::vector<double> x;
  for (const int parameter : space_.free) {
    const auto i = static_cast<std::size_t>(parameter);
    x.push_back(std::clamp(design_.chain.parameters[i], space_.lower[i], space_.upper[i]));
  }
  x.push_back(design_.start);
  x.push_back(level_);
  if (finds_span()) {
    x.push_back(std::clamp(design_.span, variables_.back().lower, variables_.back().upper));
  }
  return x;
}

LegDesign LegModel::design(std::span<const double> x) const {
  LegDesign found = design_;
  for (std::size_t i = 0; i < space_.free.size(); ++i) {
    found.chain.parameters[static_cast<std::size_t>(space_.free[i])] = x[i];
  }
  found.start = x[start_column()];
  if (finds_span()) found.span = x[span_column()];
  return found;
}

void LegModel::add_in_stance(FreeChain& chain, const LegDesign& here, double weight,
                             const Vec2d& direction, double share, double beyond, Sum& sum) const {
  const double crank = here.start + here.span * share + beyond;
  const double turn = sum.add_point(chain, space_.foot, weight, direction, crank);
  if (!sum.row) return;
  sum.row[start_column()] += turn;
  if (finds_span()) sum.row[span_column()] += share * turn;
}

void LegModel::add_speed(FreeChain& chain, const LegDesign& here, double share, Sum& sum) const {
  const double weight = checks_.sense * here.span / (2 * kSpeedStep);
  const double before = sum.value;
  add_in_stance(chain, here, weight, kAlong, share, kSpeedStep, sum);
  add_in_stance(chain, here, -weight, kAlong, share, -kSpeedStep, sum);
  // The mean speed is stride over span, the stride 1.
  if (sum.row && finds_span()) sum.row[span_column()] += (sum.value - before) / here.span;
}

bool LegModel::residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                         std::span<double> /*local*/) const {
  const LegDesign here = design(x);
  const std::size_t columns = x.size();
  std::ranges::fill(jacobian, 0.0);
  if (finds_span()) {
    r[0] = 1 - here.span / kTurn;
    if (!jacobian.empty()) jacobian[span_column()] = -1 / kTurn;
    return true;
  }
  FreeChain chain(space_, here.chain.parameters, side_);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Sum sum{columns, 0, jacobian.empty() ? nullptr : jacobian.data() + i * columns};
    add_in_stance(chain, here, 1 / unit_, kUp, nodes_[i], 0, sum);
    sum.add(-x[level_column()] / unit_, level_column(), -1 / unit_);
    if (!std::isfinite(sum.value)) return false;
    r[i] = sum.value;
  }
  return true;
}

void LegModel::constraints(std::span<const double> x, std::span<double> c,
                           std::span<double> jacobian) const {
  const LegDesign here = design(x);
  FreeChain chain(space_, here.chain.parameters, side_);
  const std::size_t columns = x.size(), joints = 2 * checks_.transmission.size();
  std::ranges::fill(jacobian, 0.0);
  transmission_constraints(
      chain, space_.cosine_limit, checks_.transmission, columns, c.subspan(kEqualities, joints),
      jacobian.empty() ? jacobian : jacobian.subspan(kEqualities * columns, joints * columns));
  std::size_t next = kEqualities + joints;
  const auto make = [&](std::size_t index, double offset, const auto& terms) {
    Sum sum{columns, offset, jacobian.empty() ? nullptr : jacobian.data() + index * columns};
    terms(sum);
    c[index] = sum.value;
    if (std::isfinite(sum.value)) return;
    // What cannot be assembled violates, without a way out.
    c[index] = -1;
    if (sum.row) std::fill_n(sum.row, columns, 0.0);
  };
  const auto bound = [&](double offset, const auto& terms) { make(next++, offset, terms); };
  const double sense = checks_.sense;
  make(0, -1, [&](Sum& sum) {
    add_in_stance(chain, here, sense, kAlong, checks_.ahead, 0, sum);
    add_in_stance(chain, here, -sense, kAlong, checks_.behind, 0, sum);
  });
  make(1, 0, [&](Sum& sum) {
    add_in_stance(chain, here, 1, kUp, 0, 0, sum);
    add_in_stance(chain, here, -1, kUp, 1, 0, sum);
  });
  for (const double crank : checks_.swing) {
    bound(0, [&](Sum& sum) {
      sum.add_point(chain, space_.foot, 1, kUp, crank);
      sum.add(-x[level_column()], level_column(), -1);
    });
  }
  const auto bound_height = [&](const std::optional<double>& limit, double sign) {
    if (!limit) return;
    bound(-sign * *limit - kLegMargin, [&](Sum& sum) {
      sum.add_point(chain, space_.foot, sign, kUp, checks_.top);
      sum.add_point(chain, space_.foot, -sign, kUp, checks_.bottom);
    });
  };
  bound_height(space_.height_min, 1);
  bound_height(space_.height_max, -1);
  for (const DistanceLimit& limit : space_.distances) {
    const Vec2d* at = chain.at(here.start);
    const Vec2d way = at[limit.to] - at[limit.from], along = (1 / norm(way)) * way;
    const auto bound_distance = [&](double offset, double sign) {
      bound(offset - kLegMargin, [&](Sum& sum) {
        sum.add_point(chain, limit.to, sign, along, here.start);
        sum.add_point(chain, limit.from, -sign, along, here.start);
      });
    };
    bound_distance(-limit.least, 1);
    bound_distance(limit.most, -1);
  }
  const auto bound_speed = [&](const std::vector<double>& shares,
                               const std::optional<double>& limit, double sign) {
    for (const double share : shares) {
      bound(0, [&](Sum& sum) {
        add_speed(chain, here, share, sum);
        sum.value = sign * (sum.value - *limit) - kLegMargin;
        for (std::size_t i = 0; sum.row && i < columns; ++i) sum.row[i] *= sign;
      });
    }
  };
  const LegConstraints& limits = space_.problem->constraints;
  bound_speed(checks_.slow, limits.foot_speed_min, 1);
  bound_speed(checks_.fast, limits.foot_speed_max, -1);
  if (!finds_span()) return;
  for (const double share : nodes_) {
    for (const double sign : {1.0, -1.0}) {
      bound(checks_.band, [&](Sum& sum) {
        add_in_stance(chain, here, sign, kUp, share, 0, sum);
        sum.add(-sign * x[level_column()], level_column(), -sign);
      });
    }
  }
}

}  // namespace cognate::problems
