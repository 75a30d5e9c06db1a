/// @file A chain at one position of its crank: where its points are, how fast they move, and the
/// derivative of any combination of them by all parameters. The number type may be double, a SIMD
/// pack, a dual number or one of extended precision.
///
/// The derivative is taken backwards, from the last line to the first: the two closure equations of
/// a dyad, M dx = c, need one solution of the transposed system Mᵀλ = f for any number of
/// parameters (implicit function theorem; Griewank & Walther 2008, "Evaluating Derivatives", §3.2).
/// det M = u × v = a b sin μ: it is infinite at dead points, and only there. A three-pin link has
/// three such equations.
#pragma once

#include <cmath>
#include <type_traits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"
#include "synthesis/chain/chain_place.hpp"
#include "synthesis/chain/three_pin_lines.hpp"

namespace cognate::synthesis {

/// The joint of two links of lengths a and b from p and q, to the `side` of the way from p to q.
template <class T>
Vec2<T> dyad_joint(const Vec2<T>& p, const Vec2<T>& q, const T& a, const T& b, const T& side) {
  using std::sqrt;
  const Vec2<T> way = q - p;
  const T square = squared_norm(way), half = T(0.5) / square;
  const T along = square + (a - b) * (a + b);
  // 16 area² as a product: it keeps its digits near the dead points.
  const T sum = a + b, difference = a - b;
  const T height = sqrt((sum * sum - square) * (square - difference * difference));
  return p + half * (Vec2<T>{along, side * height} * way);
}

/// The pin of a slider on the guide through `on` in the direction `guide`, at the distance `length`
/// from `from`, to the `side` of the foot of `from`.
template <class T>
Vec2<T> slider_pin(const Vec2<T>& from, const Vec2<T>& on, const Vec2<T>& guide, const T& length,
                   const T& side) {
  using std::sqrt;
  const Vec2<T> across = perp(guide);
  const T away = dot(across, on - from);
  return from + away * across + (side * sqrt((length - away) * (length + away))) * guide;
}

/// Places all lines at the direction `crank` of the crank; three-pin links, where they are not
/// followed, as they are drawn, with the crank at angle 0.
template <Kept Keeps, class T>
void place_lines(const ChainView<T>& chain, const Vec2<T>& crank, ChainPlace<T>& out) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  out.crank = crank;
  for (int k = 0; k < chain.count; ++k) {
    const auto& [line, parameter] = chain.lines[k];
    const T* own = chain.parameters + parameter;
    switch (line.type) {
      case LineType::pivot:
        out.at[k] = {own[0], own[1]};
        break;
      case LineType::crank:
        out.at[k] = out.at[line.first] + own[0] * crank;
        break;
      case LineType::dyad:
        out.at[k] =
            dyad_joint(out.at[line.first], out.at[line.second], own[0], own[1], chain.side[k]);
        break;
      case LineType::attached:
      case LineType::third_pin: {
        const Vec2<T> way = out.at[line.second] - out.at[line.first];
        if constexpr (Keeps != Kept::distances) out.inverse[k] = T(1) / sqrt(squared_norm(way));
        out.axis[k] = out.inverse[k] * way;
        out.at[k] = out.at[line.first] + Vec2<T>{own[0], own[1]} * out.axis[k];
        break;
      }
      case LineType::guide:
        if constexpr (Keeps == Kept::nothing) out.axis[k] = {cos(own[0]), sin(own[0])};
        out.at[k] = out.at[line.first] + own[1] * perp(out.axis[k]);
        break;
      case LineType::heading:
        if constexpr (Keeps == Kept::nothing) out.axis[k] = {cos(own[0]), sin(own[0])};
        out.at[k] = out.at[line.first];
        break;
      case LineType::slider:
        out.at[k] = slider_pin(out.at[line.first], out.at[line.second], out.axis[line.second],
                               own[0], chain.side[k]);
        break;
      case LineType::third_link:
        out.at[k] = out.at[line.first];
        break;
      case LineType::drawn:
        out.at[k] = {own[0], own[1]};
        break;
      case LineType::first_pin:
        place_pins<Keeps>(chain, k - kFirstPin, out);
        break;
      case LineType::second_pin:
        break;  // with the first
    }
  }
}

/// The direction at half the angle from 0 to that of `direction`, 0 … 2π.
template <class T>
Vec2<T> halved(const Vec2<T>& direction) {
  using std::sqrt;
  constexpr double kAhead = 1e-12;  // half of 0 is 0
  const Vec2<T> half{direction.y + T(kAhead), T(1) - direction.x};
  return (T(1) / sqrt(squared_norm(half))) * half;
}

/// Whether a three-pin link stands nowhere, so that it cannot be led on.
inline bool is_lost(const ChainView<double>& chain, const ChainPlace<double>& out) {
  for (int k = 0; k < chain.count; ++k) {
    if (chain.lines[k].line.type == LineType::first_pin && !std::isfinite(out.at[k].x)) return true;
  }
  return false;
}

/// Leads three-pin links from where they stand in `out` to `crank`, never across the angle 0, from
/// which they are led at first.
inline void lead_on(const ChainView<double>& chain, const Vec2d& crank, ChainPlace<double>& out) {
  constexpr double kStep = kTurn / 64;
  const double from = in_one_turn(angle_of(out.crank));
  const double way = in_one_turn(angle_of(crank)) - from;
  const int steps = static_cast<int>(std::abs(way) / kStep);
  for (int i = 1; i <= steps && !is_lost(chain, out); ++i) {
    place_lines<Kept::distances>(chain, unit_vector(from + way * i / (steps + 1)), out);
  }
  place_lines<Kept::distances>(chain, crank, out);
}

/// Turns the crank from angle 0 to `crank`, and three-pin links follow.
template <Kept Keeps, class T>
void place_followed(const ChainView<T>& chain, const Vec2<T>& crank, ChainPlace<T>& out) {
  constexpr int kHalvings = 5, kSteps = 1 << kHalvings;
  Vec2<T> direction{T(1), T(0)};
  place_lines<Keeps>(chain, direction, out);
  if constexpr (std::is_same_v<T, double>) {
    lead_on(chain, crank, out);
  } else {
    // Lanes go all the same steps.
    Vec2<T> step = crank;
    for (int i = 0; i < kHalvings; ++i) step = halved(step);
    for (int i = 1; i < kSteps; ++i) {
      direction = direction * step;
      place_lines<Kept::distances>(chain, direction, out);
    }
    place_lines<Kept::distances>(chain, crank, out);
  }
}

/// Places all lines at the direction `crank` of the crank.
template <Kept Keeps = Kept::nothing, class T>
void place(const ChainView<T>& chain, const Vec2<T>& crank, ChainPlace<T>& out) {
  if constexpr (Keeps == Kept::distances) {
    place_lines<Keeps>(chain, crank, out);
  } else {
    has_three_pin_link(chain) ? place_followed<Keeps>(chain, crank, out)
                              : place_lines<Keeps>(chain, crank, out);
  }
}

/// The same after another position of a chain with the same dimensions, `out`, or after none: what
/// of that helps is kept.
inline void place_next(const ChainView<double>& chain, const Vec2d& crank,
                       ChainPlace<double>& out) {
  constexpr double kNearby = 0.97;  // cosine of the angle over which three-pin links are followed
  if (squared_norm(out.crank) == 0) return place(chain, crank, out);
  if (!has_three_pin_link(chain) || is_lost(chain, out)) {
    return place<Kept::guides>(chain, crank, out);
  }
  dot(crank, out.crank) > kNearby ? place<Kept::distances>(chain, crank, out)
                                  : lead_on(chain, crank, out);
}

/// How the points move when the crank turns at the rate `turn` and the parameters change at the
/// rates `rates` (null: not at all).
template <class T>
void move(const ChainView<T>& chain, const ChainPlace<T>& at, const T& turn, const T* rates,
          Vec2<T>* velocity) {
  const auto rate = [&](int parameter) { return rates ? rates[parameter] : T(0); };
  for (int k = 0; k < chain.count; ++k) {
    const auto& [line, parameter] = chain.lines[k];
    const T* own = chain.parameters + parameter;
    const T first = rate(parameter),
            second = parameter_count(line.type) == 1 ? T(0) : rate(parameter + 1);
    switch (line.type) {
      case LineType::pivot:
        velocity[k] = {first, second};
        break;
      case LineType::crank:
        velocity[k] = velocity[line.first] + first * at.crank + (own[0] * turn) * perp(at.crank);
        break;
      case LineType::dyad: {
        const Vec2<T> u = at.at[k] - at.at[line.first], v = at.at[k] - at.at[line.second];
        const T along_u = dot(u, velocity[line.first]) + own[0] * first;
        const T along_v = dot(v, velocity[line.second]) + own[1] * second;
        velocity[k] = (T(1) / cross(u, v)) * (along_v * perp(u) - along_u * perp(v));
        break;
      }
      case LineType::attached:
      case LineType::third_pin: {
        const Vec2<T>& axis = at.axis[k];
        const T spin = at.inverse[k] * cross(axis, velocity[line.second] - velocity[line.first]);
        velocity[k] = velocity[line.first] + Vec2<T>{first, second} * axis +
                      spin * perp(at.at[k] - at.at[line.first]);
        break;
      }
      case LineType::guide:
        velocity[k] =
            velocity[line.first] + second * perp(at.axis[k]) - (own[1] * first) * at.axis[k];
        break;
      case LineType::slider: {
        const Vec2<T> u = at.at[k] - at.at[line.first], v = perp(at.axis[line.second]);
        const T turning = rate(chain.lines[line.second].parameter);
        const T along_u = dot(u, velocity[line.first]) + own[0] * first;
        const T along_v = dot(v, velocity[line.second]) +
                          turning * dot(at.axis[line.second], at.at[k] - at.at[line.second]);
        velocity[k] = (T(1) / cross(u, v)) * (along_v * perp(u) - along_u * perp(v));
        break;
      }
      case LineType::heading:
      case LineType::third_link:
        velocity[k] = velocity[line.first];
        break;
      case LineType::drawn:
        velocity[k] = {T(0), T(0)};
        break;
      case LineType::first_pin:
        move_pins(chain, at, k - kFirstPin, rates, velocity);
        break;
      case LineType::second_pin:
        break;  // with the first
    }
  }
}

/// The gradient by all parameters of a goal whose derivatives by the points are `seed`, up to line
/// `last`; `seed` is used up. What of the goal depends on parameters directly is in `gradient`
/// already. Returns the derivative by the crank's angle.
template <class T>
T sweep_back(const ChainView<T>& chain, const ChainPlace<T>& at, int last, Vec2<T>* seed,
             T* gradient) {
  T turn(0);
  for (int k = last; k >= 0; --k) {
    const auto& [line, parameter] = chain.lines[k];
    const T* own = chain.parameters + parameter;
    T* slope = gradient + parameter;
    const Vec2<T> f = seed[k];
    switch (line.type) {
      case LineType::pivot:
        slope[0] = slope[0] + f.x;
        slope[1] = slope[1] + f.y;
        break;
      case LineType::crank:
        slope[0] = slope[0] + dot(f, at.crank);
        turn = turn + own[0] * cross(at.crank, f);
        seed[line.first] = seed[line.first] + f;
        break;
      case LineType::dyad: {
        const Vec2<T> u = at.at[k] - at.at[line.first], v = at.at[k] - at.at[line.second];
        const T inverse = T(1) / cross(u, v);
        const T first = inverse * cross(f, v), second = inverse * cross(u, f);
        seed[line.first] = seed[line.first] + first * u;
        seed[line.second] = seed[line.second] + second * v;
        slope[0] = slope[0] + first * own[0];
        slope[1] = slope[1] + second * own[1];
        break;
      }
      case LineType::attached:
      case LineType::third_pin: {
        const Vec2<T>& axis = at.axis[k];
        slope[0] = slope[0] + dot(f, axis);
        slope[1] = slope[1] + cross(axis, f);
        const T torque = cross(at.at[k] - at.at[line.first], f);
        const Vec2<T> couple = (torque * at.inverse[k]) * perp(axis);
        seed[line.second] = seed[line.second] + couple;
        seed[line.first] = seed[line.first] + (f - couple);
        break;
      }
      case LineType::guide:
        slope[0] = slope[0] - own[1] * dot(f, at.axis[k]);
        slope[1] = slope[1] + dot(f, perp(at.axis[k]));
        seed[line.first] = seed[line.first] + f;
        break;
      case LineType::slider: {
        const Vec2<T>& guide = at.axis[line.second];
        const Vec2<T> u = at.at[k] - at.at[line.first], v = perp(guide);
        const T inverse = T(1) / cross(u, v);
        const T first = inverse * cross(f, v), second = inverse * cross(u, f);
        seed[line.first] = seed[line.first] + first * u;
        seed[line.second] = seed[line.second] + second * v;
        slope[0] = slope[0] + first * own[0];
        T& turning = gradient[chain.lines[line.second].parameter];
        turning = turning + second * dot(guide, at.at[k] - at.at[line.second]);
        break;
      }
      case LineType::first_pin:
        sweep_back_pins(chain, at, k - kFirstPin, seed, gradient);
        break;
      case LineType::heading:  // by `seed_heading`
      case LineType::third_link:
      case LineType::drawn:
      case LineType::second_pin:
        break;  // with the first pin
    }
  }
  return turn;
}

/// The distance of the point `first` of slider `k` from its guide, to the left of the guide.
template <class T>
T slider_distance(const ChainView<T>& chain, const ChainPlace<T>& at, int k) {
  const ChainLine& line = chain.lines[k].line;
  return dot(perp(at.axis[line.second]), at.at[line.second] - at.at[line.first]);
}

/// The last line whose point `seed_transmission` of line `k` seeds.
template <class T>
int last_seeded(const ChainView<T>& chain, int k) {
  const LineType type = chain.lines[k].line.type;
  return is_three_pin(type) ? k - pin_of(type) + 2 : k - 1;
}

/// The cosine of the transmission angle of the dyad of line `k`: that between its two links, of a
/// slider that between its link and the normal of its guide; of a pin of a three-pin link that of
/// the link that holds it.
template <class T>
T transmission_cosine(const ChainView<T>& chain, const ChainPlace<T>& at, int k) {
  const auto& [line, parameter] = chain.lines[k];
  if (is_three_pin(line.type)) {
    const int pin = pin_of(line.type), base = k - pin - kFirstPin;
    return transmission_cosine(held_link(chain, base), held_closure(chain, at, base), pin);
  }
  const T& a = chain.parameters[parameter];
  if (line.type == LineType::slider) return slider_distance(chain, at, k) / a;
  const T& b = chain.parameters[parameter + 1];
  const T square = squared_norm(at.at[line.second] - at.at[line.first]);
  return (a * a + b * b - square) / (T(2) * a * b);
}

/// Adds `weight` times the derivatives of that cosine to `seed`, up to that of the line
/// `last_seeded`, and `gradient`.
template <class T>
void seed_transmission(const ChainView<T>& chain, const ChainPlace<T>& at, int k, const T& cosine,
                       const T& weight, Vec2<T>* seed, T* gradient) {
  const auto& [line, parameter] = chain.lines[k];
  if (is_three_pin(line.type)) {
    const int pin = pin_of(line.type);
    return seed_pin(chain, at, k - pin - kFirstPin, pin, cosine, weight, seed, gradient);
  }
  const T& a = chain.parameters[parameter];
  const Vec2<T> way = at.at[line.second] - at.at[line.first];
  if (line.type == LineType::slider) {
    const T share = weight / a;
    const Vec2<T>& guide = at.axis[line.second];
    seed[line.second] = seed[line.second] + share * perp(guide);
    seed[line.first] = seed[line.first] - share * perp(guide);
    T& turning = gradient[chain.lines[line.second].parameter];
    turning = turning - share * dot(guide, way);
    gradient[parameter] = gradient[parameter] - share * cosine;
    return;
  }
  const T& b = chain.parameters[parameter + 1];
  const T share = weight / (a * b);
  seed[line.second] = seed[line.second] - share * way;
  seed[line.first] = seed[line.first] + share * way;
  gradient[parameter] = gradient[parameter] + weight * (T(1) / b - cosine / a);
  gradient[parameter + 1] = gradient[parameter + 1] + weight * (T(1) / a - cosine / b);
}

}  // namespace cognate::synthesis
