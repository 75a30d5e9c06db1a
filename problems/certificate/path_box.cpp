#include "problems/certificate/path_box.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

constexpr int kTerms = 5;          // 1 and the four sides
constexpr double kUpward = 1e-12;  // more than sums of positive doubles are off by

using Doubles = std::complex<double>;

/// At least the absolute value.
double size_above(const QuadComplex& a) {
  return std::hypot(static_cast<double>(a.re.magnitude()), static_cast<double>(a.im.magnitude())) *
         (1 + kUpward);
}

double above(const Quad& value) {
  return static_cast<double>(value) * (1 + kUpward);
}

Doubles middle_of(const QuadComplex& a) {
  return {static_cast<double>(a.re.middle()), static_cast<double>(a.im.middle())};
}

std::array<Quad, 4> half_sides(const QuadBox& box) {
  std::array<Quad, 4> half;
  for (int i = 0; i < 4; ++i) half[i] = (box.side[i].high - box.side[i].low) / 2 * (1 + kUpward);
  return half;
}

/// The mean slopes, by which the couplers turn alike; any number is as good.
std::array<Quad, 4> common_slopes(const std::vector<LinkAngle>& links,
                                  const std::vector<double>& weight) {
  std::array<Quad, 4> common{};
  double all = 0;
  for (std::size_t j = 0; j < links.size(); ++j) {
    if (weight[j] == 0) continue;
    all += weight[j];
    for (int i = 0; i < 4; ++i) common[i] += weight[j] * links[j].slope[i].middle();
  }
  for (Quad& slope : common) slope /= all > 0 ? all : 1;
  return common;
}

/// Of the sides, that of the frame's length by the shorter of crank and frame.
std::array<double, 4> widths(const QuadBox& box, const std::array<Quad, 4>& half) {
  std::array<double, 4> all{};
  for (int i = 0; i < 4; ++i) all[i] = static_cast<double>(half[i]);
  const Quad narrow = std::min<Quad>(box.side[0].middle(), 1 - box.side[0].middle());
  if (box.crank_turns()) all[0] = static_cast<double>(2 * half[0] / narrow);
  return all;
}

int greatest_of(const std::array<double, 4>& scores) {
  return static_cast<int>(std::ranges::max_element(scores) - scores.begin());
}

}  // namespace

/// The coupler's directions over a box: v[0] + Σ t_i v[i] for t in [−1, 1]⁴, up to `rest`, when all
/// are turned alike. Samples of weight zero are left out, which only lowers the error.
struct PathBoxes::Directions {
  std::array<std::vector<QuadComplex>, kTerms> v;
  std::vector<double> rest, weight;
  int side = 0;        ///< best halved
  bool closes = true;  ///< false: no linkage of the box closes at one of the angles
};

/// Products of the points, the crank's and the coupler's directions, with t eliminated if free.
struct PathBoxes::Sums {
  std::vector<QuadComplex> points, cranks;
  std::array<std::vector<QuadComplex>, kTerms> v;
  QuadInterval squares, crank_square;                         ///< Σ w |z|², Σ w |e|²
  QuadComplex crank_point;                                    ///< Σ w ē z
  std::array<QuadComplex, kTerms> crank_v, point_v;           ///< Σ w ē v, Σ w z̄ v
  std::array<std::array<QuadInterval, kTerms>, kTerms> gram;  ///< Re Σ w v̄ v
};

/// Of |q|² ≤ farthest², of |s|² and of s, with what the limits of s add to the error.
struct PathBoxes::Multipliers {
  double on_point = 0;
  double on_square = 0;
  Doubles on_crank;
  QuadInterval constant;
  Doubles s, q;  ///< at the middle
};

PathBoxes::PathBoxes(const PathProblem& problem, bool clockwise, double bound)
    : question_(path_question(problem, clockwise)),
      limits_(path_lengths(problem), problem.constraints, path_ratio(problem)),
      farthest_(path_farthest(problem)),
      bound_(bound) {}

PathBoxes::Directions PathBoxes::directions(const LinkAngles& angles, const QuadBox& box) const {
  constexpr double kMostRest = 0.5;
  const std::size_t n = question_.points.size();
  Directions d;
  d.weight = question_.weights;
  d.rest.assign(n, 0);
  for (auto& column : d.v) column.resize(n);
  std::vector<LinkAngle> links;
  for (std::size_t j = 0; j < n; ++j) {
    links.push_back(angles.at(question_.angles[j], false));
    d.closes = d.closes && links[j].closes;
    if (!links[j].known) d.weight[j] = 0;
  }
  const auto half = half_sides(box), common = common_slopes(links, d.weight);
  std::array<double, 4> score{};
  std::size_t left = 0;
  for (std::size_t j = 0; j < n; ++j) {
    if (d.weight[j] == 0) continue;
    const QuadComplex& u = links[j].middle;
    d.v[0][j] = u;
    std::array<double, 4> turned{}, doubt{};
    double all = 0, rest = 0;
    for (int i = 0; i < 4; ++i) {
      const QuadInterval slope = links[j].slope[i] - QuadInterval(common[i]);
      const Quad middle = slope.middle(), step = middle * half[i];
      d.v[i + 1][j] = QuadInterval(step) * QuadComplex{-u.im, u.re};
      doubt[i] = above((slope - middle).magnitude() * half[i]);
      turned[i] = above(abs(step));
      all += turned[i];
      rest += doubt[i];
    }
    // |e^{i(τ + ρ)} − 1 − iτ| ≤ τ²/2 + |ρ|.
    d.rest[j] = (0.5 * all * all + rest) * (1 + kUpward);
    for (int i = 0; i < 4; ++i) {
      score[i] += d.weight[j] * std::min(1.0, all * turned[i] + doubt[i]);
    }
    if (d.rest[j] > kMostRest) d.weight[j] = 0;
    left += d.weight[j] > 0;
  }
  d.side = greatest_of(2 * left < n ? widths(box, half) : score);
  return d;
}

PathBoxes::Sums PathBoxes::sums(const Directions& d) const {
  const std::size_t n = question_.points.size();
  Sums s;
  s.points = question_.points;
  s.v = d.v;
  for (const CrankAngle& angle : question_.angles) s.cranks.push_back({angle.cosine, angle.sine});
  QuadInterval weight;
  for (const double w : d.weight) weight += QuadInterval(w);
  const auto centre = [&](std::vector<QuadComplex>& values) {
    QuadComplex sum;
    for (std::size_t j = 0; j < n; ++j) {
      if (d.weight[j] > 0) sum += QuadInterval(d.weight[j]) * values[j];
    }
    const QuadComplex mean = (QuadInterval(1) / weight) * sum;
    for (QuadComplex& value : values) value = value - mean;
  };
  if (!question_.pivot_fixed) {
    centre(s.points);
    centre(s.cranks);
    for (auto& column : s.v) centre(column);
  }
  for (std::size_t j = 0; j < n; ++j) {
    if (d.weight[j] == 0) continue;
    const QuadInterval w(d.weight[j]);
    s.squares += w * squared_size(s.points[j]);
    s.crank_square += w * squared_size(s.cranks[j]);
    s.crank_point += w * (conjugate(s.cranks[j]) * s.points[j]);
    for (int a = 0; a < kTerms; ++a) {
      const QuadComplex v = w * s.v[a][j];
      s.crank_v[a] += conjugate(s.cranks[j]) * v;
      s.point_v[a] += conjugate(s.points[j]) * v;
      for (int b = 0; b <= a; ++b) s.gram[a][b] += inner_product(s.v[b][j], v);
    }
  }
  return s;
}

/// Those that hold s within its limits at the middle of the box where q has `on_point`.
PathBoxes::Multipliers PathBoxes::multipliers(const Sums& sums, const QuadInterval& crank,
                                              double on_point) const {
  Multipliers m;
  m.on_point = on_point;
  const double form = static_cast<double>(sums.gram[0][0].middle()) + on_point;
  const double crank_square = static_cast<double>(sums.crank_square.middle());
  const Doubles along = middle_of(sums.crank_v[0]), pull = std::conj(middle_of(sums.point_v[0]));
  const double curvature = crank_square - std::norm(along) / form;
  const Doubles slope = middle_of(sums.crank_point) - along * pull / form;
  const double low = static_cast<double>(crank.low), high = static_cast<double>(crank.high);
  if (question_.direction_fixed) {
    m.s = std::clamp(slope.real() / curvature, low, high);
    m.on_crank = curvature * m.s - slope;
    const double force = m.on_crank.real(), at = m.s.real();
    const bool held = (force > 0 && at == low) || (force < 0 && at == high);
    if (!held) m.on_crank = {0, m.on_crank.imag()};
    if (held) m.constant = QuadInterval(2 * force) * (force > 0 ? crank.low : crank.high);
  } else {
    const double size = std::abs(slope), length = std::clamp(size / curvature, low, high);
    m.s = size > 0 ? slope * (length / size) : Doubles(length);
    const double force = curvature - size / length;
    const bool held = (force > 0 && length == low) || (force < 0 && length == high);
    if (held && force < crank_square) {
      m.on_square = force;
      m.constant = QuadInterval(force) * square(QuadInterval(force > 0 ? crank.low : crank.high));
    }
  }
  m.q = (pull - std::conj(along) * m.s) / form;
  return m;
}

/// Those that hold q within its limit, too.
PathBoxes::Multipliers PathBoxes::multipliers_within(const Sums& sums,
                                                     const QuadInterval& crank) const {
  Multipliers m = multipliers(sums, crank, 0);
  double low = 0, high = 1e-16 * static_cast<double>(sums.crank_square.middle());
  while (!(std::abs(m.q) <= farthest_) && high < kInfinity) {
    low = m.on_point;
    m = multipliers(sums, crank, high);
    high *= 16;
  }
  for (double top = m.on_point; top > 1.001 * low;) {
    const Multipliers between = multipliers(sums, crank, (low + top) / 2);
    const bool is_within = std::abs(between.q) <= farthest_;
    if (is_within) m = between;
    (is_within ? top : low) = between.on_point;
  }
  return m;
}

/// How much the form lacks at the middle where nothing is shown; empty where the bound is shown.
std::optional<double> PathBoxes::lacks(const Directions& d, const Sums& sums,
                                       const Multipliers& m) const {
  const std::size_t n = question_.points.size();
  const QuadInterval one(1), crank_form = sums.crank_square - QuadInterval(m.on_square);
  if (!(crank_form.low > 0)) return kInfinity;
  const QuadInterval per_form = one / crank_form;
  const QuadComplex pulled = sums.crank_point + QuadComplex{m.on_crank.real(), m.on_crank.imag()};
  QuadInterval kappa = sums.squares - per_form * squared_size(pulled) + m.constant - bound_;
  if (m.on_point > 0) kappa = kappa - QuadInterval(m.on_point) * square(QuadInterval(farthest_));
  if (!(kappa.low > 0)) return kInfinity;
  std::array<QuadComplex, kTerms> b;
  for (int a = 0; a < kTerms; ++a) {
    b[a] = sums.point_v[a] - per_form * (conjugate(pulled) * sums.crank_v[a]);
  }
  BoxForm form;
  for (int a = 0; a < kTerms; ++a) {
    for (int c = 0; c <= a; ++c) {
      const QuadInterval size =
          sums.gram[a][c] - per_form * inner_product(sums.crank_v[a], sums.crank_v[c]);
      form[a][c] = kappa * size - inner_product(b[a], b[c]);
      form[c][a] = form[a][c];
    }
  }
  form[0][0] += kappa * QuadInterval(m.on_point);
  double first = 0, of_points = 0, of_cranks = 0;
  for (std::size_t j = 0; j < n; ++j) {
    if (d.weight[j] == 0) continue;
    const QuadComplex e = per_form * sums.cranks[j];
    const QuadComplex y = sums.points[j] - e * pulled;
    double gradient = 0;
    for (int a = 0; a < kTerms; ++a) {
      gradient += size_above(kappa * (sums.v[a][j] - e * sums.crank_v[a]) - y * b[a]);
    }
    const double lost = d.weight[j] * d.rest[j];
    first += 2 * lost * gradient;
    of_points += lost * size_above(y);
    of_cranks += lost * size_above(sums.cranks[j]);
  }
  double loss = first + of_points * of_points;
  if (m.on_square > 0) {
    loss += above((kappa * (per_form - one / sums.crank_square)).high) * of_cranks * of_cranks;
  }
  loss *= 1 + kUpward;
  const FormMinimum minimum = form_minimum(form);
  if (surely_exceeds(form, minimum.multiplier, QuadInterval(loss))) return std::nullopt;
  return std::max(0.0, loss - minimum.value) / static_cast<double>(kappa.middle());
}

bool PathBoxes::is_shown(const Directions& d, const QuadInterval& crank) const {
  const Sums s = sums(d);
  const double crank_square = static_cast<double>(s.crank_square.middle());
  const Doubles along = middle_of(s.crank_v[0]);
  const Doubles point =
      middle_of(s.point_v[0]) - std::conj(middle_of(s.crank_point)) * along / crank_square;
  const double form = static_cast<double>(s.gram[0][0].middle()) - std::norm(along) / crank_square;
  const bool is_far = std::isfinite(farthest_);
  double on_point = is_far ? std::max(0.0, std::abs(point) / farthest_ - form) : 0;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const auto lacking = lacks(d, s, multipliers(s, crank, on_point));
    if (!lacking) return true;
    if (!is_far || !(*lacking > 0) || !std::isfinite(*lacking)) return false;
    on_point += 2 * *lacking;
  }
  return false;
}

BoxFinding PathBoxes::operator()(const QuadBox& box) const {
  const LinkAngles angles(box);
  const auto crank = limits_.crank_lengths(box, angles.proportions());
  if (!crank) return {true, 0};
  const Directions d = directions(angles, box);
  if (!d.closes) return {true, 0};
  if (std::ranges::count_if(d.weight, [](double w) { return w > 0; }) < 3) return {false, d.side};
  return {is_shown(d, *crank), d.side};
}

/// That of the multipliers' s and q, where t is best.
FourBar PathBoxes::linkage(const QuadBox& point, const Directions& d, const Multipliers& at) const {
  const QuadProportions p(point);
  const auto number = [](const QuadInterval& value) { return static_cast<double>(value.middle()); };
  Doubles pivot;
  double weight = 0;
  for (std::size_t j = 0; j < question_.points.size(); ++j) {
    const CrankAngle& crank = question_.angles[j];
    const Doubles e(number(crank.cosine), number(crank.sine));
    pivot += question_.weights[j] *
             (middle_of(question_.points[j]) - at.s * e - at.q * middle_of(d.v[0][j]));
    weight += question_.weights[j];
  }
  pivot = question_.pivot_fixed ? 0.0 : pivot / weight;
  const double crank = std::abs(at.s), unit = crank / number(p.crank);
  const double along = std::arg(at.s) - number(point.side[3]);
  const Doubles in_plane = std::polar(1.0, -question_.turned);
  const Doubles a = Doubles(question_.origin.x, question_.origin.y) + in_plane * pivot;
  const Doubles d_from_a = in_plane * std::polar(unit * number(p.frame), along);
  const Doubles of_coupler = at.q * std::polar(1.0, -along);
  const double sum = unit / number(p.inverse), difference = unit * number(p.difference);
  return {.pivot_a = {a.real(), a.imag()},
          .pivot_d = {(a + d_from_a).real(), (a + d_from_a).imag()},
          .crank = crank,
          .coupler = (sum + difference) / 2,
          .rocker = (sum - difference) / 2,
          .assembly = point.assembly > 0 ? Assembly::open : Assembly::crossed,
          .coupler_point = Vec2d{of_coupler.real(), of_coupler.imag()}};
}

std::optional<Counterexample> PathBoxes::counterexample(const QuadBox& box) const {
  const QuadBox point = box.middle();
  const LinkAngles angles(point);
  const auto crank = limits_.crank_lengths(point, angles.proportions());
  if (!crank) return std::nullopt;
  const Directions d = directions(angles, point);
  if (std::ranges::count(d.weight, 0) > std::ranges::count(question_.weights, 0)) {
    return std::nullopt;
  }
  const Multipliers m = multipliers_within(sums(d), *crank);
  if (!(std::abs(m.q) <= farthest_) || !std::isfinite(std::abs(m.s))) return std::nullopt;
  Counterexample found{linkage(point, d, m), std::arg(m.s) - question_.turned, 0};
  found.error = path_error(question_, found.linkage, found.first_crank_angle);
  found.first_crank_angle += static_cast<double>(question_.angles.front().angle);
  if (!(found.error < bound_)) return std::nullopt;
  return found;
}

}  // namespace cognate::problems
