#include "tests/stress/chain_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/mechanism/convert.hpp"
#include "analysis/mechanism/kinematics.hpp"

namespace cognate::stress {
namespace {

/// What is compared of the last dyad.
template <class T>
struct Outcome {
  std::array<Vec2<T>, 2> directions, origins;
  std::array<T, 2> turns;
  T discriminant;
};

template <class T>
Outcome<T> outcome(const Mechanism<T>& mechanism, const Vec2<T>& crank,
                   const std::vector<double>& signs) {
  const std::vector<T> sides(signs.begin(), signs.end());
  std::vector<BodyMotion<T, 1>> bodies(static_cast<std::size_t>(body_count(mechanism)));
  std::vector<DyadClosure<T>> closures(mechanism.dyads.size());
  evaluate<1>(mechanism, DrivePosition<T>{crank, T(0)}, sides, bodies, closures);
  const auto &second = bodies.back(), &first = *(bodies.end() - 2);
  return {{first.direction, second.direction},
          {first.origin[0], second.origin[0]},
          {first.turn[0], second.turn[0]},
          closures.back().discriminant};
}

Vec2<Exact> unit(const Vec2<Exact>& v) {
  return Exact(1 / sqrt(squared_norm(v))) * v;
}

/// Directions are what is given, not its length.
void normalise(Mechanism<Exact>& mechanism) {
  for (Dyad<Exact>& dyad : mechanism.dyads) {
    if (auto* rrp = std::get_if<Rrp<Exact>>(&dyad))
      rrp->guide.direction = unit(rrp->guide.direction);
    if (auto* prp = std::get_if<Prp<Exact>>(&dyad)) {
      prp->first.direction = unit(prp->first.direction);
      prp->second.direction = unit(prp->second.direction);
    }
    if (auto* rpp = std::get_if<Rpp<Exact>>(&dyad)) {
      rpp->slot = unit(rpp->slot);
      rpp->guide.direction = unit(rpp->guide.direction);
    }
  }
}

/// The chain in 237 bits, with input number `index` (the last two are the crank's direction)
/// changed by the part `step`. Returns how many numbers there are.
class ExactChain {
 public:
  explicit ExactChain(const ChainPosition& at) : at_(at), sides_(sides(at.mechanism)) {
    convert<Exact>(at.mechanism, [this](double x) { return ++count_, Exact(x); });
    count_ += 2;
  }

  int count() const { return count_; }

  Outcome<Exact> changed(int index, const Exact& step) const {
    int next = 0;
    const auto lift = [&](double x) { return Exact(next++ == index ? x * (1 + step) : Exact(x)); };
    auto mechanism = convert<Exact>(at_.mechanism, lift);
    normalise(mechanism);
    const Exact x = lift(at_.crank.x), y = lift(at_.crank.y);
    return outcome<Exact>(mechanism, unit({x, y}), sides_);
  }

 private:
  const ChainPosition& at_;
  std::vector<double> sides_;
  int count_ = 0;
};

double norm(const Vec2<Exact>& v) {
  return double(sqrt(squared_norm(v)));
}

Vec2<Exact> exact(const Vec2d& v) {
  return {Exact(v.x), Exact(v.y)};
}

/// Σ|x·∂/∂x| of what an outcome holds.
struct Conditions {
  std::array<double, 2> directions{}, origins{}, turns{};
  double discriminant = 0;
};

Conditions conditions(const ExactChain& chain) {
  const Exact step = ldexp(Exact(1), -90);
  const double per_step = std::ldexp(1.0, 89);
  Conditions sums;
  for (int i = 0; i < chain.count(); ++i) {
    const Outcome<Exact> more = chain.changed(i, step), less = chain.changed(i, -step);
    for (std::size_t k = 0; k < 2; ++k) {
      sums.directions[k] += per_step * norm(more.directions[k] - less.directions[k]);
      sums.origins[k] += per_step * norm(more.origins[k] - less.origins[k]);
      sums.turns[k] += per_step * double(abs(Exact(more.turns[k] - less.turns[k])));
    }
    sums.discriminant += per_step * double(abs(Exact(more.discriminant - less.discriminant)));
  }
  return sums;
}

bool is_finite(const Outcome<double>& found) {
  return std::isfinite(found.directions[0].x) && std::isfinite(found.origins[1].x) &&
         std::isfinite(found.turns[0]) && std::isfinite(found.turns[1]);
}

}  // namespace

void ChainAccuracy::include(const ChainPosition& at) {
  const ExactChain chain(at);
  const Outcome<Exact> expected = chain.changed(-1, 0);
  const Outcome<double> found = outcome(at.mechanism, at.crank, sides(at.mechanism));
  const bool should_close = expected.discriminant > 0;
  const Conditions sum = conditions(chain);
  positions.include_flag(should_close, is_finite(found),
                         double(abs(expected.discriminant)) / sum.discriminant / kUnit);
  if (!should_close || !is_finite(found)) return;
  for (std::size_t k = 0; k < 2; ++k) {
    // Dimensions are of order one; an origin far away is measured by its own distance.
    const double size = std::max(1.0, norm(expected.origins[k]));
    positions.include_error(distance(found.directions[k], expected.directions[k]),
                            sum.directions[k]);
    positions.include_error(norm(exact(found.origins[k]) - expected.origins[k]) / size / kUnit,
                            sum.origins[k] / size);
    const double turn = 1 + double(abs(expected.turns[k]));
    velocities.include_error(double(abs(found.turns[k] - expected.turns[k])) / turn / kUnit,
                             sum.turns[k] / turn);
  }
}

void ChainAccuracy::include(const ChainAccuracy& other) {
  positions.include(other.positions);
  velocities.include(other.velocities);
}

}  // namespace cognate::stress
