#include "tests/stress/ranges/chain_curve.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"

namespace cognate::stress {
namespace {

constexpr double kRadian = kPi / 180;
constexpr int kCoordinates = 5;
/// Angles of crank, coupler, rocker and of the dyad's links; of a slide its displacement last.
using State = std::array<double, kCoordinates>;
using Row = std::array<double, kCoordinates + 1>;

struct Point {
  double x = 0, y = 0;
};
Point polar(double length, double angle) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

Point coupler_point(const SixBar& c, const State& z) {
  const Point b = polar(c.crank, z[0]), along = polar(1, z[1]);
  return {b.x + c.p[0] * along.x - c.p[1] * along.y, b.y + c.p[0] * along.y + c.p[1] * along.x};
}

/// The loops' gaps.
std::array<double, 4> gaps(const SixBar& c, const State& z) {
  const Point b = polar(c.crank, z[0]), l = polar(c.coupler, z[1]), r = polar(c.rocker, z[2]);
  const Point p = coupler_point(c, z), m = polar(c.first, z[3]);
  const Point last = c.slides ? polar(z[4], c.second * kRadian) : polar(c.second, z[4]);
  return {b.x + l.x - c.d[0] - r.x, b.y + l.y - c.d[1] - r.y, p.x + m.x - c.e[0] - last.x,
          p.y + m.y - c.e[1] - last.y};
}

/// Their derivatives by the coordinates, with room for a right side.
std::array<Row, 5> derivatives(const SixBar& c, const State& z) {
  const auto turned = [](double length, double angle) {
    return Point{-length * std::sin(angle), length * std::cos(angle)};
  };
  const Point b = turned(c.crank, z[0]), l = turned(c.coupler, z[1]), r = turned(c.rocker, z[2]);
  const Point u = turned(c.p[0], z[1]), v = turned(c.p[1], z[1] + kRightAngle);
  const Point m = turned(c.first, z[3]);
  const Point last = c.slides ? polar(1, c.second * kRadian) : turned(c.second, z[4]);
  return {Row{b.x, l.x, -r.x, 0, 0, 0}, Row{b.y, l.y, -r.y, 0, 0, 0},
          Row{b.x, u.x + v.x, 0, m.x, -last.x, 0}, Row{b.y, u.y + v.y, 0, m.y, -last.y, 0}, Row{}};
}

/// Solves five equations; false where they are singular.
bool solve(std::array<Row, 5> rows, State& x) {
  for (int k = 0; k < kCoordinates; ++k) {
    int best = k;
    for (int i = k; i < kCoordinates; ++i) {
      if (std::abs(rows[i][k]) > std::abs(rows[best][k])) best = i;
    }
    std::swap(rows[k], rows[best]);
    if (std::abs(rows[k][k]) < 1e-9) return false;
    for (int i = 0; i < kCoordinates; ++i) {
      if (i == k) continue;
      const double factor = rows[i][k] / rows[k][k];
      for (int j = k; j <= kCoordinates; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  for (int k = 0; k < kCoordinates; ++k) x[k] = rows[k][kCoordinates] / rows[k][k];
  return true;
}

double dot(const State& a, const State& b) {
  double sum = 0;
  for (int i = 0; i < kCoordinates; ++i) sum += a[i] * b[i];
  return sum;
}

/// The unit vector along the curve on the side of `before`.
bool tangent(const SixBar& c, const State& z, const State& before, State& along) {
  auto rows = derivatives(c, z);
  for (int i = 0; i < kCoordinates; ++i) rows[4][i] = before[i];
  rows[4][kCoordinates] = 1;
  if (!solve(rows, along)) return false;
  const double size = std::sqrt(dot(along, along));
  for (double& x : along) x /= size;
  return true;
}

/// A step of Newton's method after which the next would be rounding.
constexpr double kSmallStep = 1e-11;

/// The place on the curve that is `step` ahead of `z` along its tangent.
bool advance(const SixBar& c, const State& z, const State& along, double step, State& next) {
  for (int i = 0; i < kCoordinates; ++i) next[i] = z[i] + step * along[i];
  for (int iteration = 0; iteration < 8; ++iteration) {
    auto rows = derivatives(c, next);
    const auto gap = gaps(c, next);
    for (int i = 0; i < 4; ++i) rows[i][kCoordinates] = -gap[i];
    for (int i = 0; i < kCoordinates; ++i) rows[4][i] = along[i];
    State change{};
    if (!solve(rows, change)) return false;
    for (int i = 0; i < kCoordinates; ++i) next[i] += change[i];
    if (dot(change, change) < kSmallStep * kSmallStep) return true;
  }
  return false;
}

/// Angles of transmission of both dyads, in radians.
std::array<double, 2> transmission(const SixBar& c, const State& z) {
  const auto between = [](double a, double b) { return std::abs(std::remainder(a - b, kTurn)); };
  const double by_slide = std::acos(std::clamp(-std::sin(z[3] - c.second * kRadian), -1.0, 1.0));
  return {between(z[1] + kPi, z[2] + kPi),
          c.slides ? kPi - by_slide : between(z[3] + kPi, z[4] + kPi)};
}

/// The state at a crank angle with the assemblies given, by circles and lines.
std::optional<State> assemble(const SixBar& c, double theta) {
  State z{theta};
  const auto circles = [](Point from, Point to, double r1, double r2, int side) {
    const double x = to.x - from.x, y = to.y - from.y, square = x * x + y * y;
    const double along = (square + r1 * r1 - r2 * r2) / (2 * square);
    const double high = r1 * r1 / square - along * along;
    if (high < 0) return std::optional<Point>();
    const double across = side * std::sqrt(high);
    return std::optional(Point{from.x + along * x - across * y, from.y + along * y + across * x});
  };
  const Point b = polar(c.crank, theta);
  const auto pin = circles(b, {c.d[0], c.d[1]}, c.coupler, c.rocker, c.side);
  if (!pin) return std::nullopt;
  z[1] = std::atan2(pin->y - b.y, pin->x - b.x);
  z[2] = std::atan2(pin->y - c.d[1], pin->x - c.d[0]);
  const Point p = coupler_point(c, z);
  if (!c.slides) {
    const auto end = circles(p, {c.e[0], c.e[1]}, c.first, c.second, c.dyad_side);
    if (!end) return std::nullopt;
    z[3] = std::atan2(end->y - p.y, end->x - p.x);
    z[4] = std::atan2(end->y - c.e[1], end->x - c.e[0]);
    return z;
  }
  const Point v = polar(1, c.second * kRadian), to{p.x - c.e[0], p.y - c.e[1]};
  const double rise = v.x * to.y - v.y * to.x, high = c.first * c.first - rise * rise;
  if (high < 0) return std::nullopt;
  const double ahead = c.dyad_side * std::sqrt(high);
  z[3] = c.second * kRadian + std::atan2(-rise, ahead);
  z[4] = v.x * to.x + v.y * to.y + ahead;
  return z;
}

/// Follows the curve and notes what happens.
class Follower {
 public:
  enum class Until { dead_point, whole_circuit };
  enum class End { dead_point, drive, circuit, lost };

  explicit Follower(const SixBar& chain) : chain_(chain) {}

  double least = HUGE_VAL, greatest = -HUGE_VAL, net = 0;
  double least_transmission = kPi, greatest_transmission = 0;
  double end_drive = 0;

  /// From `z` on in the sense in which the drive grows (`sense` +1) or falls, up to `bound`.
  End follow(const State& start, int sense, Until until, double bound) {
    State z = start, along{}, guess{};
    guess[0] = sense;
    if (!tangent(chain_, z, guess, along)) return End::lost;
    if (along[0] * sense < 0) {
      for (double& x : along) x = -x;
    }
    const State first = along;
    note(z);
    double step = 0.01;
    for (int i = 0; i < 200'000; ++i) {
      State next{}, ahead{};
      if (!advance(chain_, z, along, step, next) || !tangent(chain_, next, along, ahead) ||
          dot(along, ahead) < 1 - 2e-4) {
        if ((step /= 2) < 1e-9) return End::lost;
        continue;
      }
      if (until == Until::dead_point) {
        if (along[0] * ahead[0] <= 0) return end_at(z, along, step, 0, 0, End::dead_point);
        if ((next[0] - bound) * sense >= 0) return end_at(z, along, step, 1, bound, End::drive);
      } else if (i > 4 && is_back(start, first, z, next, ahead, step)) {
        note_extremes(z, along, ahead, step);
        net = next[4] - start[4];
        return End::circuit;
      }
      note_extremes(z, along, ahead, step);
      note(next);
      z = next;
      along = ahead;
      step = std::min(0.02, 1.5 * step);
    }
    return End::lost;
  }

 private:
  void note(const State& z) {
    least = std::min(least, z[4]);
    greatest = std::max(greatest, z[4]);
    for (const double mu : transmission(chain_, z)) {
      least_transmission = std::min(least_transmission, mu);
      greatest_transmission = std::max(greatest_transmission, mu);
    }
  }

  /// How far from `z` on f changes its sign, by bisection, and the state there.
  std::pair<double, State> place(const State& z, const State& along, double step,
                                 const std::function<double(const State&, const State&)>& f) {
    State here = z, ahead = along;
    const double at_start = f(z, along);
    double a = 0, b = step;
    for (int i = 0; i < 60; ++i) {
      const double middle = (a + b) / 2;
      if (!advance(chain_, z, along, middle, here) || !tangent(chain_, here, along, ahead)) break;
      (f(here, ahead) * at_start > 0 ? a : b) = middle;
    }
    return {a, here};
  }

  /// Extremes of the output, and of transmission, between `z` and what is `step` ahead.
  void note_extremes(const State& z, const State& along, const State& ahead, double step) {
    if (along[4] * ahead[4] < 0) {
      note(place(z, along, step, [](const State&, const State& t) { return t[4]; }).second);
    }
    for (const int which : {0, 1}) {
      const auto slope = [&](const State& at, const State& t) {
        constexpr double kStep = 1e-6;
        State before = at, after = at;
        for (int i = 0; i < kCoordinates; ++i) before[i] -= kStep * t[i], after[i] += kStep * t[i];
        return transmission(chain_, after)[which] - transmission(chain_, before)[which];
      };
      State next{};
      if (!advance(chain_, z, along, step, next)) continue;
      if (slope(z, along) * slope(next, ahead) < 0) note(place(z, along, step, slope).second);
    }
  }

  End end_at(const State& z, const State& along, double step, int kind, double bound, End end) {
    const auto [length, last] = place(z, along, step, [&](const State& at, const State& t) {
      return kind == 0 ? t[0] : at[0] - bound;
    });
    State ahead{};
    if (tangent(chain_, last, along, ahead)) note_extremes(z, along, ahead, length);
    note(last);
    end_drive = last[0];
    return end;
  }

  /// Whether the start lies between `z` and `next`, but for whole turns.
  bool is_back(const State& start, const State& first, const State& z, const State& next,
               const State& ahead, double step) const {
    if (dot(first, ahead) < 0.9) return false;
    State from{}, to{};
    for (int i = 0; i < kCoordinates; ++i) {
      const bool turns = i < 4 || !chain_.slides;
      from[i] = z[i] - start[i], to[i] = next[i] - start[i];
      const double turn = turns ? kTurn * std::round(to[i] / (kTurn)) : 0;
      from[i] -= turn, to[i] -= turn;
    }
    return dot(from, first) < 0 && dot(to, first) >= 0 && dot(to, to) < 9 * step * step;
  }

  const SixBar& chain_;
};

/// The crank angle between two at which `holds` changes, to rounding.
double edge(double inside, double outside, const std::function<bool(double)>& holds) {
  for (int i = 0; i < 80; ++i) {
    const double middle = std::midpoint(inside, outside);
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}

/// Crank angles from start to end in order: evenly, and crowded towards both ends of each arc on
/// which the four-bar closes. The dyad's point is as fast as one likes there, and the whole may
/// close within 1e-6 of a turn only.
std::vector<double> places(const SixBar& chain, double start, double end) {
  constexpr int kSamples = 20'000;
  const auto closes = [&](double theta) {
    const Point b = polar(chain.crank, theta);
    const double far = std::hypot(b.x - chain.d[0], b.y - chain.d[1]);
    return std::abs(chain.coupler - chain.rocker) <= far && far <= chain.coupler + chain.rocker;
  };
  std::vector<double> all;
  const auto even = [&](int i) { return start + (end - start) * i / kSamples; };
  for (int i = 0; i <= kSamples; ++i) {
    const bool here = closes(even(i));
    if (i > 0 && here != closes(even(i - 1))) {
      const double inside = even(here ? i : i - 1), outside = even(here ? i - 1 : i);
      const double last = edge(inside, outside, closes);
      for (double part = 1; part > 1e-14; part *= 0.9) {
        all.push_back(last + part * (inside - last));
      }
    }
    all.push_back(even(i));
  }
  std::ranges::sort(all);
  if (end < start) std::ranges::reverse(all);
  return all;
}

/// The drive's angle at a dead point near `end`, at which the motion in `sense` ends: where the
/// whole can no longer be assembled.
double dead_point(const SixBar& chain, double end, int sense) {
  const auto closes = [&](double theta) { return assemble(chain, theta).has_value(); };
  for (double room = 1e-9; room < 1e-2; room *= 2) {
    const double inside = end - sense * room, outside = end + sense * room;
    if (closes(inside) && !closes(outside)) return edge(inside, outside, closes);
  }
  return end;
}

}  // namespace

std::optional<SixBarTruth> truth_of(const SixBar& chain) {
  const double start = chain.start * kRadian, end = chain.end * kRadian;
  const std::vector<double> all = places(chain, start, end);
  const auto first =
      std::ranges::find_if(all, [&](double theta) { return assemble(chain, theta).has_value(); });
  if (first == all.end()) return std::nullopt;
  const auto inside = assemble(chain, *first);
  const bool from_start = first == all.begin();
  const int sense = end < start ? -1 : 1;
  SixBarTruth truth;
  Follower range(chain);
  using Until = Follower::Until;
  using End = Follower::End;
  const auto add_dead_point = [&](int towards) {
    truth.dead_points.push_back(dead_point(chain, range.end_drive, towards) / kRadian);
  };
  if (!from_start) {
    if (range.follow(*inside, -sense, Until::dead_point, start) != End::dead_point)
      return std::nullopt;
    add_dead_point(-sense);
  }
  const End stop = range.follow(*inside, sense, Until::dead_point, end);
  if (stop == End::lost) return std::nullopt;
  if (stop == End::dead_point) add_dead_point(sense);
  const double unit = chain.slides ? 1 : 1 / kRadian;
  double least = range.least, greatest = range.greatest;
  if (from_start && stop == End::dead_point && std::abs(end - start) >= kTurn * (1 - 1e-12)) {
    // A turn later the start is passed again, on the way out of the other end of its range.
    Follower back(chain);
    if (back.follow(*inside, -sense, Until::dead_point, start - sense * kTurn) == End::lost) {
      return std::nullopt;
    }
    least = std::min(least, back.least);
    greatest = std::max(greatest, back.greatest);
  }
  truth.stroke = unit * (greatest - least);
  truth.least_transmission = range.least_transmission / kRadian;
  truth.greatest_transmission = range.greatest_transmission / kRadian;
  Follower whole(chain);
  if (whole.follow(*inside, sense, Until::whole_circuit, 0) != End::circuit) return std::nullopt;
  const bool came_round = !chain.slides && std::abs(whole.net) > 1;
  truth.circuit = came_round ? 360 : unit * (whole.greatest - whole.least);
  if (!chain.slides) truth.circuit = std::min(360.0, *truth.circuit);
  return truth;
}

std::string file_of(const SixBar& c) {
  const auto assembly = [](int side) { return side > 0 ? "open" : "crossed"; };
  std::string text = fmt::format(
      "kind = \"analysis\"\n[mechanism]\ntype = \"chain\"\n[[pivot]]\nname = \"A\"\nat = [0, 0]\n"
      "[[pivot]]\nname = \"D\"\nat = [{:.17g}, {:.17g}]\n[[pivot]]\nname = \"E\"\nat = [{:.17g}, "
      "{:.17g}]\n[crank]\nat = \"A\"\npin = \"B\"\nlength = {:.17g}\n[[dyad]]\ntype = \"RRR\"\n"
      "joins = [\"B\", \"D\"]\nlengths = [{:.17g}, {:.17g}]\nassembly = \"{}\"\nnew = \"C\"\nnames "
      "= "
      "[\"coupler\", \"rocker\"]\n[[point]]\nname = \"P\"\non = [\"B\", \"C\"]\nat = [{:.17g}, "
      "{:.17g}]\n",
      c.d[0], c.d[1], c.e[0], c.e[1], c.crank, c.coupler, c.rocker, assembly(c.side), c.p[0],
      c.p[1]);
  text += c.slides ? fmt::format(
                         "[[dyad]]\ntype = \"RRP\"\njoins = \"P\"\nlength = {:.17g}\nslide = "
                         "{{through = \"E\", direction_deg = {:.17g}}}\n",
                         c.first, c.second)
                   : fmt::format(
                         "[[dyad]]\ntype = \"RRR\"\njoins = [\"P\", \"E\"]\nlengths = "
                         "[{:.17g}, {:.17g}]\n",
                         c.first, c.second);
  return text + fmt::format(
                    "assembly = \"{}\"\nnew = \"F\"\nnames = [\"link\", \"output\"]\n[drive]\n"
                    "start_deg = {:.17g}\nend_deg = {:.17g}\nsteps = 7\n[output]\nvelocity = "
                    "false\nacceleration = false\n",
                    assembly(c.dyad_side), c.start, c.end);
}

}  // namespace cognate::stress
