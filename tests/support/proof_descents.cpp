#include "tests/support/proof_descents.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace cognate::test {
namespace {

using problems::CrankReference;
using problems::PathProblem;
using Real = long double;
using Complex = std::complex<Real>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

constexpr Real kHalfTurn = std::numbers::pi_v<Real>;
constexpr int kDeepestDescent = 60;

/// A four-bar by its lengths in units of frame + crank, and the crank's phase from A→D.
struct Proportioned {
  Real crank = 0, coupler = 0, rocker = 0, frame = 0, phase = 0;
  int assembly = 1;
  std::array<double, 4> at{};  ///< the sides of its box
};

Proportioned proportioned(const synthesis::ProportionBox& root, std::mt19937_64& random) {
  const auto uniform = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  Proportioned p;
  for (int i = 0; i < 4; ++i) {
    double share = uniform();
    if (uniform() < 0.3) share = share < 0.5 ? std::pow(share, 4) : 1 - std::pow(1 - share, 4);
    if ((i == 1 || i == 2) && uniform() < 0.05) share = std::round(share);
    p.at[i] = std::clamp(root.side[i].low + share * (root.side[i].high - root.side[i].low),
                         root.side[i].low, root.side[i].high);
  }
  const bool any = root.proportions == synthesis::Proportions::any;
  p.frame = p.at[0];
  p.crank = 1 - p.frame;
  const Real inverse = any ? Real(p.at[2]) / (1 - Real(p.at[2])) : std::cos(Real(p.at[2]));
  const Real difference = any ? Real(p.at[1]) : std::abs(2 * p.frame - 1) * std::cos(Real(p.at[1]));
  p.coupler = (1 / inverse + difference) / 2;
  p.rocker = (1 / inverse - difference) / 2;
  p.phase = p.at[3];
  p.assembly = root.assembly;
  return p;
}

/// What a path asks, in the file's unit.
struct Wanted {
  std::vector<Complex> points;
  std::vector<Real> angles;  ///< from the crank's zero
  std::vector<Real> weights;
  bool pivot_fixed = false, direction_fixed = false;
  Real ratio = 0, farthest = 0;
};

Wanted wanted_of(const PathProblem& problem, bool clockwise) {
  Wanted wanted;
  wanted.pivot_fixed = problem.given.pivot_a.has_value();
  const bool along_frame =
      problem.crank_reference == CrankReference::frame && problem.given.frame_angle;
  wanted.direction_fixed = along_frame || problem.crank_reference == CrankReference::global;
  const Real turn = along_frame ? -Real(*problem.given.frame_angle) : 0;
  const Vec2d origin = problem.given.pivot_a.value_or(Vec2d{});
  const bool increments = problem.crank_reference == CrankReference::first;
  for (std::size_t j = 0; j < problem.points.size(); ++j) {
    const Complex point(Real(problem.points[j].x) - origin.x, Real(problem.points[j].y) - origin.y);
    wanted.points.push_back(point * std::polar(Real(1), turn));
    const Real angle =
        Real(problem.crank_angles[j]) - (increments ? Real(problem.crank_angles.front()) : 0);
    wanted.angles.push_back(clockwise ? -angle : angle);
    wanted.weights.push_back(problem.weights.empty() ? 1 : problem.weights[j]);
  }
  return wanted;
}

/// The coupler's direction in axes with A→D along x: C is where two circles meet.
std::optional<Complex> coupler_direction(const Proportioned& p, Real crank_angle) {
  const Complex b = std::polar(p.crank, crank_angle), diagonal = Complex(p.frame) - b;
  const Real square = std::norm(diagonal);
  const Real along = (square + p.coupler * p.coupler - p.rocker * p.rocker) / 2;
  const Real height_square = p.coupler * p.coupler * square - along * along;
  // Where the circles only touch, they may miss one another by rounding.
  if (height_square < -1e-16L * p.coupler * p.coupler * square) return std::nullopt;
  const Real height = p.assembly * std::sqrt(std::max<Real>(0, height_square));
  return diagonal * Complex(along, height) / (square * p.coupler);
}

/// s is the crank, q the coupler point from B, t the pivot A, as complex numbers.
struct Fit {
  Complex t, s, q;
};

/// The least squares for those that are free; s is held where `crank` is given.
Fit fitted(const Wanted& wanted, const std::vector<Complex>& u, std::optional<Complex> crank) {
  const std::size_t n = wanted.points.size();
  const int of_t = wanted.pivot_fixed ? 0 : 2;
  const int of_s = crank ? 0 : wanted.direction_fixed ? 1 : 2;
  Matrix a = Matrix::Zero(Eigen::Index(2 * n), of_t + of_s + 2);
  Vector b = Vector::Zero(Eigen::Index(2 * n));
  for (std::size_t j = 0; j < n; ++j) {
    const Real root = std::sqrt(wanted.weights[j]);
    const auto put = [&](int column, const Complex& value) {
      a(Eigen::Index(2 * j), column) = root * value.real();
      a(Eigen::Index(2 * j + 1), column) = root * value.imag();
    };
    const Complex e = std::polar(Real(1), wanted.angles[j]), i(0, 1);
    if (of_t > 0) put(0, 1), put(1, i);
    if (of_s > 0) put(of_t, e);
    if (of_s > 1) put(of_t + 1, i * e);
    put(of_t + of_s, u[j]);
    put(of_t + of_s + 1, i * u[j]);
    const Complex rest = wanted.points[j] - (crank ? *crank * e : Complex());
    b(Eigen::Index(2 * j)) = root * rest.real();
    b(Eigen::Index(2 * j + 1)) = root * rest.imag();
  }
  const Vector x = a.completeOrthogonalDecomposition().solve(b);
  Fit fit;
  if (of_t > 0) fit.t = {x(0), x(1)};
  fit.s = crank ? *crank : Complex(x(of_t), of_s > 1 ? x(of_t + 1) : 0);
  fit.q = {x(of_t + of_s), x(of_t + of_s + 1)};
  return fit;
}

/// Crank lengths for which all four keep the bounds; empty where there are none.
std::optional<std::pair<Real, Real>> crank_range(const PathProblem& problem, const Proportioned& p,
                                                 Real ratio) {
  const std::array<Real, 4> shares{p.crank, p.coupler, p.rocker, p.frame};
  const auto [least, greatest] = std::ranges::minmax(shares);
  if (!(greatest <= ratio * least)) return std::nullopt;
  const auto& bounds = problem.bounds;
  const std::array ranges{bounds.crank, bounds.coupler, bounds.rocker, bounds.frame};
  std::pair<Real, Real> crank{0, std::numeric_limits<Real>::infinity()};
  for (int i = 0; i < 4; ++i) {
    if (!ranges[i]) continue;
    crank.first = std::max(crank.first, ranges[i]->min * p.crank / shares[i]);
    crank.second = std::min(crank.second, ranges[i]->max * p.crank / shares[i]);
  }
  if (!(crank.first < crank.second)) return std::nullopt;
  return crank;
}

/// The weighted sum of squares of the best linkage with those proportions within the limits.
std::optional<Real> planted_error(const PathProblem& problem, const Wanted& wanted,
                                  const Proportioned& p) {
  const auto crank = crank_range(problem, p, wanted.ratio);
  if (!crank) return std::nullopt;
  std::vector<Complex> u;
  for (const Real angle : wanted.angles) {
    const auto direction = coupler_direction(p, angle + p.phase);
    if (!direction) return std::nullopt;
    u.push_back(*direction);
  }
  Fit fit = fitted(wanted, u, std::nullopt);
  const Real signed_size = wanted.direction_fixed ? fit.s.real() : std::abs(fit.s);
  const Real size = std::clamp(signed_size, crank->first, crank->second);
  if (!(size > 0)) return std::nullopt;
  if (size != signed_size) {
    const Complex along =
        wanted.direction_fixed || std::abs(fit.s) == 0 ? Complex(1) : fit.s / std::abs(fit.s);
    fit = fitted(wanted, u, size * along);
  }
  if (!(std::abs(fit.q) <= wanted.farthest)) return std::nullopt;
  Real error = 0;
  for (std::size_t j = 0; j < u.size(); ++j) {
    const Complex point = fit.t + fit.s * std::polar(Real(1), wanted.angles[j]) + fit.q * u[j];
    error += wanted.weights[j] * std::norm(point - wanted.points[j]);
  }
  return error;
}

Real ratio_of(const PathProblem& problem) {
  return problem.constraints.link_ratio_max.value_or(problems::kCertifiedLinkRatio);
}

/// The greatest distance of the coupler point from B, for a path of that size.
Real farthest_of(const PathProblem& problem, Real size) {
  const auto& box = problem.bounds.coupler_point;
  if (!box) return problems::kFarthestPoint * size;
  return std::hypot(std::max(std::abs(box->min.x), std::abs(box->max.x)),
                    std::max(std::abs(box->min.y), std::abs(box->max.y)));
}

struct Descent {
  problems::PathPart part;
  std::array<double, 4> at{};
  double target = 0;
  int depth = 0;
};

/// One more step of a descent; false where it ends.
bool step(const problems::PathDomain& domain, double scale, Descent& descent, DescentTally& tally) {
  const std::array<problems::PathPart, 1> parts{descent.part};
  std::array<synthesis::StageVerdict, 1> above, below;
  problems::judge(domain, parts, descent.target / scale, descent.target / scale, above);
  problems::judge(domain, parts, 0.5 * descent.target, 0.5 * descent.target, below);
  ++tally.boxes;
  tally.deepest = std::max(tally.deepest, descent.depth);
  tally.discarded_below += below[0].reached == 2;
  if (above[0].reached == 2) {
    ++tally.wrongly_discarded;
    return false;
  }
  const int side = above[0].side;
  if (side < 0 || ++descent.depth > kDeepestDescent) return false;
  const auto [first, second] = problems::halves(descent.part, side);
  descent.part = descent.at[side] <= first.box.side[side].high ? first : second;
  return true;
}

}  // namespace

DescentTally& DescentTally::operator+=(const DescentTally& other) {
  designs += other.designs;
  boxes += other.boxes;
  wrongly_discarded += other.wrongly_discarded;
  discarded_below += other.discarded_below;
  deepest = std::max(deepest, other.deepest);
  return *this;
}

DescentTally descend(const PathProblem& problem, long boxes, std::mt19937_64& random,
                     double scale) {
  const problems::PathDomain domain = problems::path_domain(problem);
  const auto roots = problems::whole_parts(domain);
  const bool increments = problem.crank_reference == CrankReference::first;
  DescentTally tally;
  while (tally.boxes < boxes) {
    const auto& root =
        roots[std::uniform_int_distribution<std::size_t>(0, roots.size() - 1)(random)];
    const bool clockwise =
        increments && (problem.crank_sense == problems::CrankSense::cw || root.sense == 1);
    Wanted wanted = wanted_of(problem, clockwise);
    wanted.ratio = ratio_of(problem);
    wanted.farthest = farthest_of(problem, std::sqrt(domain.to_file));
    const Proportioned p = proportioned(root.box, random);
    const auto error = planted_error(problem, wanted, p);
    if (!error || !(*error > 1e-9 * domain.to_file)) continue;
    ++tally.designs;
    Descent descent{root, p.at, double(*error / domain.to_file) * (1 + 1e-9), 0};
    while (step(domain, scale, descent, tally)) {
    }
  }
  return tally;
}

}  // namespace cognate::test
