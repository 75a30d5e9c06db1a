#include "problems/leg/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/chain/starts/draw.hpp"
#include "problems/leg/checks.hpp"
#include "synthesis/chain/drawn.hpp"
#include "synthesis/chain/sweep.hpp"

namespace cognate::problems {
namespace {

constexpr int kChains = 120;
constexpr double kWorst = std::numeric_limits<double>::infinity();

/// A part of a drawn path as a stance.
struct DrawnStance {
  int first = 0;          ///< sample
  Vec2d direction{1, 0};  ///< of the ground, the path being to its left
  double stride = 0;
  double badness = kWorst;  ///< dimensionless
};

class StanceFinder {
 public:
  StanceFinder(const LegSpace& space, const DrawnCurve& curve)
      : space_(space),
        curve_(curve),
        steps_(static_cast<int>(std::lround(space.problem->target.duty * kDrawnPositions))) {}

  DrawnStance best() const {
    DrawnStance found;
    for (int first = 0; first < kDrawnPositions; ++first) {
      const DrawnStance one = stance(first);
      if (one.badness < found.badness) found = one;
    }
    return found;
  }

 private:
  const Vec2d& at(int index) const {
    return curve_[static_cast<std::size_t>(index % kDrawnPositions)];
  }

  DrawnStance stance(int first) const {
    DrawnStance one{first};
    if (space_.is_movable) {
      const Vec2d way = at(first + steps_) - at(first), middle = at(first + steps_ / 2) - at(first);
      const double length = norm(way);
      if (!(length > 0)) return one;
      one.direction = (1 / length) * way;
      // The rest of the path is on the other side of the ground than the walker's underside.
      double side = 0;
      for (int i = steps_ + 1; i < kDrawnPositions; ++i) {
        side += cross(one.direction, at(first + i) - at(first) - 0.5 * middle);
      }
      if (side < 0) one.direction = -one.direction;
    }
    measure(one);
    return one;
  }

  void measure(DrawnStance& one) const {
    const Vec2d origin = at(one.first);
    double low = kWorst, high = -kWorst, back = kWorst, ahead = -kWorst, bottom = kWorst,
           top = -kWorst;
    for (int i = 0; i < kDrawnPositions; ++i) {
      const Vec2d place = conj(one.direction) * (at(one.first + i) - origin);
      bottom = std::min(bottom, place.y);
      top = std::max(top, place.y);
      if (i > steps_) continue;
      low = std::min(low, place.y);
      high = std::max(high, place.y);
      back = std::min(back, place.x);
      ahead = std::max(ahead, place.x);
    }
    one.stride = ahead - back;
    const double unit = space_.is_movable ? one.stride : 1;
    if (!(unit > 0)) return;
    const auto missed = [&](const std::optional<double>& limit, double sign) {
      return limit ? std::max(0.0, sign * (*limit - (top - bottom) / unit)) : 0;
    };
    one.badness = (high - bottom) / unit + 0.5 * missed(space_.height_min, 1) +
                  0.5 * missed(space_.height_max, -1) + std::abs(std::log(one.stride / unit));
  }

  const LegSpace& space_;
  const DrawnCurve& curve_;
  int steps_;
};

/// Turned so that `direction` is the x axis, and enlarged by `factor`, about the crank's pivot.
void move(const LegSpace& space, const Vec2d& direction, double factor,
          synthesis::ChainDesign& chain) {
  using synthesis::ParameterRole;
  // What stands so with the crank at this angle is turned to where the crank is at angle 0.
  synthesis::draw_anew(space.lines, direction, chain);
  for (const auto& [line, parameter] : space.lines) {
    double* own = chain.parameters.data() + parameter;
    for (int i = 0; i < synthesis::parameter_count(line.type); ++i) {
      const bool turns = parameter_role(line.type, i) == ParameterRole::direction;
      own[i] = turns ? own[i] - angle_of(direction) : own[i] * factor;
    }
    if (parameter_role(line.type, 0) != ParameterRole::x) continue;
    const Vec2d turned = conj(direction) * Vec2d{own[0], own[1]};
    own[0] = turned.x;
    own[1] = turned.y;
  }
}

/// The published leg with other lengths, its pivots turned about that of the crank.
synthesis::ChainDesign scattered(const LegSpace& space, std::mt19937_64& random) {
  constexpr double kUsual = 1.5;
  const double most = std::log(space.problem->near.value_or(kUsual));
  const auto factor = [&] { return std::exp(uniform(random, -most, most)); };
  synthesis::ChainDesign chain = *space.known;
  for (std::size_t k = 0; k < space.lines.size(); ++k) {
    const auto& [line, parameter] = space.lines[k];
    double* own = chain.parameters.data() + parameter;
    if (line.type == synthesis::LineType::pivot) {
      const Vec2d at = factor() * unit_vector(uniform(random, 0, kTurn)) * Vec2d{own[0], own[1]};
      own[0] = at.x;
      own[1] = at.y;
      continue;
    }
    for (int i = 0; i < synthesis::parameter_count(line.type); ++i) own[i] *= factor();
    if (uniform(random, 0, 1) < 0.5) continue;
    if (line.type == synthesis::LineType::attached) own[1] = -own[1];
    if (line.type == synthesis::LineType::dyad) chain.side[k] = -chain.side[k];
  }
  return chain;
}

}  // namespace

std::optional<Gait> gait_of(const LegSpace& space, const synthesis::ChainDesign& chain,
                            double duty) {
  const std::vector<double> side(chain.side.begin(), chain.side.end());
  const synthesis::ChainView<double> view{space.lines.data(), static_cast<int>(space.lines.size()),
                                          chain.parameters.data(), side.data()};
  synthesis::ChainPlace<double> place;
  std::array<Vec2d, synthesis::kMostLines> velocity;
  const auto foot = static_cast<std::size_t>(space.foot);
  const FootPath path = [&](double crank) -> FootState {
    synthesis::place_next(view, unit_vector(crank), place);
    synthesis::move<double>(view, place, 1, nullptr, velocity.data());
    return {place.at[foot], velocity.at(foot)};
  };
  return gait(path, duty);
}

std::optional<LegDesign> with_stance(const LegSpace& space, synthesis::ChainDesign chain) {
  return with_stance(space, std::move(chain), space.problem->target.duty);
}

std::optional<LegDesign> with_stance(const LegSpace& space, synthesis::ChainDesign chain,
                                     double duty) {
  const auto found = gait_of(space, chain, duty);
  if (!found) return std::nullopt;
  if (space.is_movable) move(space, {1, 0}, 1 / found->stride, chain);
  return LegDesign{std::move(chain), found->from, found->to - found->from};
}

std::optional<LegDesign> draw_leg(const LegSpace& space, std::mt19937_64& random) {
  std::optional<LegDesign> best;
  double least = kWorst;
  for (int i = 0; i < kChains; ++i) {
    auto drawn = draw(space, random);
    if (!drawn) continue;
    const DrawnStance stance = StanceFinder(space, drawn->curve).best();
    if (!(stance.badness < least)) continue;
    least = stance.badness;
    double start = kTurn * stance.first / kDrawnPositions;
    if (space.is_movable) {
      move(space, stance.direction, 1 / stance.stride, drawn->design);
      start -= std::atan2(stance.direction.y, stance.direction.x);
    }
    best = LegDesign{std::move(drawn->design), start, kTurn * space.problem->target.duty};
  }
  return best;
}

std::optional<LegDesign> draw_beside_known(const LegSpace& space, std::mt19937_64& random) {
  constexpr int kLegs = 48;
  std::optional<LegDesign> best;
  double least = kWorst;
  for (int i = 0; i < kLegs; ++i) {
    const auto leg = with_stance(space, scattered(space, random));
    const double half = leg ? half_band(space, *leg) : kWorst;
    if (half < least) best = leg;
    least = std::min(least, half);
  }
  return best;
}

}  // namespace cognate::problems
