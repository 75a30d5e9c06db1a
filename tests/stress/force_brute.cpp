#include "tests/stress/force_brute.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <sstream>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/read.hpp"

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

enum class When { always, advance, back, interval, stroke };

/// A linkage with a load on its output, and what a file says of it. Of a slider-crank `rocker` is 0
/// and `frame` its offset.
struct Linkage {
  bool slides = false;
  double crank = 1, coupler = 1, rocker = 1, frame = 1, side = 1;
  double mass = 0, u = 0, v = 0, inertia = 0, output_inertia = 0, gravity = 0, speed = 1, load = 0;
  When when = When::always;
  double from = 0, to = 0;  ///< degrees, or parts of the stroke
  double start = 0;
  int steps = 3;
};

/// What moves: the work of loads and weights by the angle, inertia's derivative, and the output.
struct State {
  double even_torque = 0;  ///< without the load
  double load_rate = 0;    ///< work of a load of 1
  double output = 0;
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
  return {l.speed * l.speed * inertia_slope + l.mass * l.gravity * py.d, out_rate, output};
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

double torque(const Linkage& l, double q, bool loaded) {
  const State at = state(l, q);
  return at.even_torque - (loaded ? l.load * at.load_rate : 0);
}

bool acts(const Linkage& l, double q) {
  return acts(l, q, state(l, q));
}

/// Where the linkage closes, as intervals of the angle from `start` on for a turn.
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

struct Found {
  double least = 0, greatest = 0;
  bool falls = false, grows = false, unclear = false;
};

/// The golden section between two places about a sample.
double refine(const std::function<double(double)>& f, double a, double b) {
  constexpr double kShare = 0.6180339887498949;
  for (int i = 0; i < 60; ++i) {
    const double x = b - kShare * (b - a), y = a + kShare * (b - a);
    (f(x) < f(y) ? a : b) = f(x) < f(y) ? x : y;
  }
  return f(0.5 * (a + b));
}

Found search(const Linkage& l, int samples) {
  Found found{HUGE_VAL, -HUGE_VAL};
  for (const auto& [from, to] : ranges(l)) {
    const bool turns = to - from >= kTurn - 1e-9;
    std::vector<double> places;
    for (int i = 0; i <= samples; ++i) {
      const double share = static_cast<double>(i) / samples;
      const double bent = 0.5 - 0.5 * std::cos(kPi * share);
      places.push_back(from + (to - from) * (turns ? share : bent));
    }
    if (l.when == When::interval) {
      for (double q : {l.from * kDegree, l.to * kDegree, 0.5 * (l.from + l.to) * kDegree}) {
        q = from + std::fmod(std::fmod(q - from, kTurn) + kTurn, kTurn);
        if (q < to) places.push_back(q);
      }
      std::ranges::sort(places);
    }
    if (!turns) {
      places.erase(places.begin());
      places.pop_back();
      for (const auto& [end, inward] : {std::pair(from, 1.0), std::pair(to, -1.0)}) {
        const bool loaded = acts(l, end + inward * 1e-7);
        const double near = torque(l, end + inward * 1e-9, loaded);
        const double far = torque(l, end + inward * 1e-7, loaded);
        const bool grows = std::abs(near) > 3 * std::abs(far);
        found.unclear |= std::abs(near) < 10 && std::abs(near) > 1e-6;
        if (grows && std::abs(near) > 1e-6) (near > 0 ? found.grows : found.falls) = true;
      }
    }
    const auto offer = [&](double value) {
      found.least = std::min(found.least, value);
      found.greatest = std::max(found.greatest, value);
    };
    std::vector<bool> loaded;
    std::vector<double> values;
    for (const double q : places) {
      loaded.push_back(acts(l, q));
      values.push_back(torque(l, q, loaded.back()));
      offer(values.back());
    }
    for (std::size_t i = 1; i < places.size(); ++i) {
      if (loaded[i] != loaded[i - 1]) {
        double a = places[i - 1], b = places[i];
        for (int k = 0; k < 60; ++k) {
          const double middle = 0.5 * (a + b);
          (acts(l, middle) == loaded[i - 1] ? a : b) = middle;
        }
        offer(torque(l, a, loaded[i - 1]));
        offer(torque(l, b, loaded[i]));
      } else if (i + 1 < places.size() && loaded[i] == loaded[i + 1]) {
        for (const double sense : {1.0, -1.0}) {
          const double here = sense * values[i];
          if (here < sense * values[i - 1] || here < sense * values[i + 1]) continue;
          const auto f = [&](double q) { return sense * torque(l, q, loaded[i]); };
          offer(sense * refine(f, places[i - 1], places[i + 1]));
        }
      }
    }
  }
  return found;
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
       << "\n[output]\ntorque = true\nreactions = false\n";
  return text.str();
}

class Family {
 public:
  explicit Family(std::uint64_t seed) : random_(seed) {}

  Linkage next() {
    while (true) {
      const Linkage linkage = draw();
      if (is_clear(linkage)) return linkage;
    }
  }

 private:
  double between(double a, double b) { return std::uniform_real_distribution(a, b)(random_); }

  Linkage draw() {
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
    l.to = l.when == When::stroke ? l.from + between(0.02, 1 - l.from)
                                  : l.from + std::exp(between(std::log(0.01), std::log(300)));
    l.start = between(0, kTurn);
    l.steps = 3 + static_cast<int>(random_() % 38);
    return l;
  }

  /// Whether it closes somewhere and stays clear of change points and of short ranges.
  static bool is_clear(const Linkage& l) {
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

  std::mt19937_64 random_;
};

/// Holds one analysis against the brute force.
class Judge {
 public:
  Judge(const Linkage& linkage, ForceTally& tally) : linkage_(linkage), tally_(tally) {}

  void judge() {
    const auto problem = problems::parse_analysis(file_of(linkage_));
    if (!problem) return disagree("file refused: " + problem.error().front().message);
    const auto result = problems::analyse(*problem, problems::Run{.threads = 1});
    for (const auto& fact : result.facts) {
      if (const auto* value = std::get_if<double>(&fact.value)) facts_[fact.name] = *value;
    }
    ++tally_.linkages;
    const Found found = search(linkage_, 2500);
    if (found.unclear) return;
    compare("min", found.least, found.falls, found.greatest - found.least);
    compare("max", found.greatest, found.grows, found.greatest - found.least);
  }

 private:
  void compare(const std::string& which, double value, bool unbounded, double range) {
    const std::string name = "torque_N_m." + which;
    const bool said = facts_.contains(name + "_unbounded_at_deg");
    if (said != unbounded) return disagree(which + (said ? " said" : " not said") + " unbounded");
    if (unbounded) {
      ++tally_.unbounded;
      if (facts_.contains(name)) disagree(which + " both");
      return compare_place(facts_[name + "_unbounded_at_deg"]);
    }
    if (!facts_.contains(name)) return disagree(which + " missing");
    const double size = std::max(std::abs(value), std::isfinite(range) && range < 1e6 ? range : 0);
    const double difference = size > 0 ? std::abs(facts_[name] - value) / size : 0;
    ++tally_.bounded;
    tally_.worst = std::max(tally_.worst, difference);
    if (difference > 1e-6) return disagree(which + " off by " + std::to_string(difference));
    const double at = facts_[name + "_at_deg"] * kDegree;
    double nearest = HUGE_VAL;
    for (const double step : {-1e-8, 0.0, 1e-8}) {
      for (const bool loaded : {true, false}) {
        nearest = std::min(nearest, std::abs(torque(linkage_, at + step, loaded) - value));
      }
    }
    if (nearest > 1e-5 * size) disagree(which + "_at holds another torque");
  }

  void compare_place(double degrees) {
    for (const auto& [from, to] : ranges(linkage_)) {
      for (const double end : {from, to}) {
        if (std::abs(std::remainder(degrees - end / kDegree, 360)) < 1e-6) return;
      }
    }
    disagree("unbounded elsewhere");
  }

  void disagree(const std::string& what) {
    if (tally_.disagreements++ == 0) tally_.first_file = "# " + what + "\n" + file_of(linkage_);
  }

  const Linkage& linkage_;
  ForceTally& tally_;
  std::map<std::string, double> facts_;
};

}  // namespace

ForceTally check_forces(std::uint64_t seed, int count) {
  ForceTally tally;
  Family family(seed);
  for (int i = 0; i < count; ++i) {
    const Linkage linkage = family.next();
    Judge(linkage, tally).judge();
  }
  return tally;
}

}  // namespace cognate::stress
