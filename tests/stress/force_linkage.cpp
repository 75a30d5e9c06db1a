#include "tests/stress/force_linkage.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "analysis/numbers/constants.hpp"

namespace cognate::stress {
namespace {

/// A number with its first and second derivatives by the crank's angle.
struct Jet {
  double v = 0, d = 0, dd = 0;
};
Jet operator+(Jet a, Jet b) {
  return {a.v + b.v, a.d + b.d, a.dd + b.dd};
}
Jet operator-(Jet a, Jet b) {
  return {a.v - b.v, a.d - b.d, a.dd - b.dd};
}
Jet operator*(Jet a, Jet b) {
  return {a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2 * a.d * b.d + a.v * b.dd};
}
Jet operator/(Jet a, Jet b) {
  const double q = a.v / b.v, qd = (a.d - q * b.d) / b.v;
  return {q, qd, (a.dd - 2 * qd * b.d - q * b.dd) / b.v};
}
Jet root(Jet a) {
  const double r = std::sqrt(a.v), d = a.d / (2 * r);
  return {r, d, (a.dd - 2 * d * d) / (2 * r)};
}
Jet constant(double c) {
  return {c, 0, 0};
}

struct Vector {
  double x = 0, y = 0;
};
double cross(Vector a, Vector b) {
  return a.x * b.y - a.y * b.x;
}

/// What moves: the work of loads and weights by the angle, inertia's derivative, the output, and
/// what the equations of motion of coupler and output need.
struct State {
  double even_torque = 0;  ///< without the load
  double load_rate = 0;    ///< work of a load of 1
  double output = 0;
  Vector from_b, from_d;                          ///< of C
  Vector centre;                                  ///< of the coupler's mass, from B
  Vector pull;                                    ///< mass times acceleration less gravity
  double coupler_moment = 0, output_inertia = 0;  ///< inertia times acceleration
};

double squared_speed_slope(Jet x, Jet y) {
  return x.d * x.dd + y.d * y.dd;
}

State state(const Linkage& l, double q) {
  const Jet c{std::cos(q), -std::sin(q), -std::cos(q)}, s{std::sin(q), std::cos(q), -std::sin(q)};
  const Jet bx = constant(l.crank) * c, by = constant(l.crank) * s;
  Jet cx, cy;
  if (l.slides) {
    const Jet rise = constant(l.frame) - by;
    cx = bx + root(constant(l.coupler * l.coupler) - rise * rise);
    cy = constant(l.frame);
  } else {
    const Jet vx = constant(l.frame) - bx, vy = constant(0) - by, square = vx * vx + vy * vy;
    const double excess = l.coupler * l.coupler - l.rocker * l.rocker;
    const Jet t = (constant(excess) + square) / (constant(2) * square);
    const Jet h = constant(l.side) * root(constant(l.coupler * l.coupler) / square - t * t);
    cx = bx + t * vx - h * vy;
    cy = by + t * vy + h * vx;
  }
  const Jet ux = (cx - bx) / constant(l.coupler), uy = (cy - by) / constant(l.coupler);
  const Jet px = bx + constant(l.u) * ux - constant(l.v) * uy;
  const Jet py = by + constant(l.u) * uy + constant(l.v) * ux;
  const double turn = ux.v * uy.d - uy.v * ux.d, turning = ux.v * uy.dd - uy.v * ux.dd;
  double out_rate = cx.d, out_rate_slope = cx.dd, output = cx.v;
  if (!l.slides) {
    const Jet rx = (cx - constant(l.frame)) / constant(l.rocker), ry = cy / constant(l.rocker);
    out_rate = rx.v * ry.d - ry.v * rx.d;
    out_rate_slope = rx.v * ry.dd - ry.v * rx.dd;
    output = std::atan2(ry.v, rx.v);
  }
  const double inertia_slope = l.mass * squared_speed_slope(px, py) + l.inertia * turn * turning +
                               l.output_inertia * out_rate * out_rate_slope;
  const double square = l.speed * l.speed;
  return {square * inertia_slope + l.mass * l.gravity * py.d,
          out_rate,
          output,
          {cx.v - bx.v, cy.v - by.v},
          {cx.v - l.frame, cy.v},
          {px.v - bx.v, py.v - by.v},
          {l.mass * square * px.dd, l.mass * (square * py.dd + l.gravity)},
          l.inertia * square * turning,
          l.output_inertia * square * out_rate_slope};
}

/// On the coupler at C: by moments about B, and by those of the rocker about D or the slider's
/// motion along its slide.
Vector force_at_c(const Linkage& l, const State& at, bool loaded) {
  const double about_b = at.coupler_moment + cross(at.centre, at.pull);
  const double output = (loaded ? l.load : 0) - at.output_inertia;
  if (l.slides) return {output, (about_b + at.from_b.y * output) / at.from_b.x};
  const double sine = cross(at.from_b, at.from_d);
  return {(about_b * at.from_d.x - output * at.from_b.x) / sine,
          (about_b * at.from_d.y - output * at.from_b.y) / sine};
}

/// The ends of the stroke of a slider whose crank turns fully.
std::pair<double, double> stroke_of(const Linkage& l) {
  const auto end = [&](double r) { return std::sqrt(r * r - l.frame * l.frame); };
  return {end(l.coupler - l.crank), end(l.coupler + l.crank)};
}

bool acts(const Linkage& l, double q, const State& at) {
  switch (l.when) {
    case When::always:
      return true;
    case When::advance:
      return at.load_rate > 0;
    case When::back:
      return at.load_rate < 0;
    case When::interval: {
      const double beyond = q / kDegree - l.from;
      return beyond - 360 * std::floor(beyond / 360) <= l.to - l.from;
    }
    case When::stroke: {
      const auto [least, greatest] = stroke_of(l);
      const double part = (at.output - least) / (greatest - least);
      return part >= l.from && part <= l.to;
    }
  }
  return false;
}

/// Whether a linkage closes somewhere and stays clear of change points and of short ranges.
bool is_clear(const Linkage& l) {
  if (l.slides) return true;
  constexpr double kClear = 0.02;
  const double near = std::abs(l.coupler - l.rocker), far = l.coupler + l.rocker;
  for (const double limit : {near, far}) {
    for (const double end : {std::abs(l.crank - l.frame), l.crank + l.frame}) {
      if (std::abs(limit - end) < kClear) return false;
    }
  }
  for (const auto& [from, to] : ranges(l)) {
    if (!(to - from > kClear)) return false;
  }
  return l.crank + l.frame > near && std::abs(l.crank - l.frame) < far;
}

}  // namespace

double force(const Linkage& l, ForceQuantity quantity, double q, bool loaded) {
  const State at = state(l, q);
  if (quantity == ForceQuantity::torque) {
    return at.even_torque - (loaded ? l.load * at.load_rate : 0);
  }
  const Vector c = force_at_c(l, at, loaded);
  if (quantity == ForceQuantity::at_c) return std::hypot(c.x, c.y);
  if (quantity == ForceQuantity::at_b) return std::hypot(at.pull.x - c.x, at.pull.y - c.y);
  return std::abs(c.y + l.output_inertia * l.gravity);
}

bool acts(const Linkage& l, double q) {
  return acts(l, q, state(l, q));
}

double part_of_stroke(const Linkage& l, double q) {
  const auto [least, greatest] = stroke_of(l);
  return (state(l, q).output - least) / (greatest - least);
}

std::vector<std::pair<double, double>> ranges(const Linkage& l) {
  if (l.slides) return {{l.start, l.start + kTurn}};
  const auto angle = [&](double diagonal) {
    return (l.crank * l.crank + l.frame * l.frame - diagonal * diagonal) / (2 * l.crank * l.frame);
  };
  const double near = angle(std::abs(l.coupler - l.rocker)), far = angle(l.coupler + l.rocker);
  const double least = near < 1 ? std::acos(std::max(near, -1.0)) : 0;
  const double most = far > -1 ? std::acos(far) : kPi;
  if (least == 0 && most == kPi) return {{l.start, l.start + kTurn}};
  if (least == 0) return {{-most, most}};
  if (most == kPi) return {{least, kTurn - least}};
  return {{least, most}, {-most, -least}};
}

std::string file_of(const Linkage& l) {
  std::ostringstream text;
  text.precision(17);
  text << "kind = \"analysis\"\ngravity = [0, " << -l.gravity << "]\n[mechanism]\n";
  if (l.slides) {
    text << "type = \"slider-crank\"\noffset = " << l.frame << "\n";
  } else {
    text << "type = \"four-bar\"\nfixed_pivots = [[0, 0], [" << l.frame
         << ", 0]]\nrocker = " << l.rocker << "\n";
  }
  text << "assembly = \"" << (l.side > 0 ? "open" : "crossed") << "\"\ncrank = " << l.crank
       << "\ncoupler = " << l.coupler << "\n[[link]]\nname = \"coupler\"\nmass = " << l.mass
       << "\ncentre = [" << l.u << ", " << l.v << "]\ninertia = " << l.inertia
       << "\n[[link]]\nname = \"" << (l.slides ? "slider\"\nmass = " : "rocker\"\ninertia = ")
       << l.output_inertia << "\n[[load]]\non = \"" << (l.slides ? "slider" : "rocker") << "\"\n";
  if (l.slides) {
    text << "force = [" << l.load << ", 0]\n";
  } else {
    text << "torque = " << l.load << "\n";
  }
  if (l.when == When::advance) text << "when = \"advance\"\n";
  if (l.when == When::back) text << "when = \"return\"\n";
  if (l.when == When::interval) text << "when = [" << l.from << ", " << l.to << "]\n";
  if (l.when == When::stroke) text << "stroke = [" << l.from << ", " << l.to << "]\n";
  text << "[drive]\nspeed = " << l.speed << "\nstart_deg = " << l.start / kDegree
       << "\nend_deg = " << l.start / kDegree + 360 << "\nsteps = " << l.steps
       << "\n[output]\ntorque = true\nreactions = true\n";
  return text.str();
}

Linkage LinkageFamily::next() {
  while (true) {
    const Linkage linkage = draw();
    if (is_clear(linkage)) return linkage;
  }
}

Linkage LinkageFamily::draw() {
  Linkage l;
  l.slides = random_() % 3 == 0;
  l.crank = between(0.1, 1);
  l.coupler = l.slides ? l.crank * between(1.3, 5) : between(0.2, 1.5);
  l.rocker = l.slides ? 0 : between(0.2, 1.5);
  l.frame = l.slides ? between(-0.9, 0.9) * (l.coupler - l.crank) : between(0.2, 1.5);
  l.side = !l.slides && random_() % 2 == 0 ? -1 : 1;
  const bool moves = random_() % 3 != 0;
  l.mass = moves ? between(0.1, 5) : 0;
  l.u = between(-1, 1);
  l.v = between(-1, 1);
  l.inertia = moves ? between(0.01, 1) : 0;
  l.output_inertia = moves ? between(0.01, 3) : 0;
  l.gravity = random_() % 2 == 0 ? 9.81 : 0;
  l.speed = between(0.5, 10);
  l.load = between(1, 100) * (random_() % 2 == 0 ? 1 : -1);
  constexpr When kCases[] = {When::always, When::advance, When::back, When::interval};
  l.when = kCases[random_() % 4];
  if (l.slides && random_() % 3 == 0) l.when = When::stroke;
  l.from = l.when == When::stroke ? between(0, 0.9) : between(0, 359);
  l.to = l.when == When::stroke ? l.from + (1 - l.from) * std::exp(between(std::log(1e-4), 0))
                                : l.from + std::exp(between(std::log(1e-4), std::log(300)));
  l.start = between(0, kTurn);
  l.steps = 3 + static_cast<int>(random_() % 38);
  return l;
}

}  // namespace cognate::stress
