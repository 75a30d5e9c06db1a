#include "synthesis/bounds/path_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "synthesis/bounds/box_quadratic.hpp"

namespace cognate::synthesis {
namespace {

using Complex = std::complex<double>;

constexpr double kPathRounding = 1e-15;
constexpr int kPathTerms = kBoxSides + 1;

double real_product(const Complex& a, const Complex& b) {  // Re(conj(a) b)
  return a.real() * b.real() + a.imag() * b.imag();
}

Complex conjugate_product(const Complex& a, const Complex& b) {  // conj(a) b
  return {a.real() * b.real() + a.imag() * b.imag(), a.real() * b.imag() - a.imag() * b.real()};
}

/// |a|, without the care that std::abs takes of the largest numbers.
double size_of(const Complex& a) {
  return std::sqrt(std::norm(a));
}

Complex product(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace

/// Points and crank directions at the positions that count, with t eliminated where it is free.
struct PathBound::Target {
  std::vector<double> weights;
  std::vector<Complex> e, z;  ///< less their means if t is free
  double weight = 0;          ///< Σ w
  double crank_form = 0;      ///< Σ w |e|²
  Complex crank_point;        ///< Σ w ē z
  double squares = 0;         ///< Σ w |z|²

  Target(const TimedPath& path, std::vector<double> of_points);
};

PathBound::Target::Target(const TimedPath& path, std::vector<double> of_points)
    : weights(std::move(of_points)), z(path.points) {
  const std::size_t n = z.size();
  Complex z_sum, e_sum;
  for (std::size_t j = 0; j < n; ++j) {
    e.push_back(std::polar(1.0, path.crank_angles[j]));
    weight += weights[j];
    z_sum += weights[j] * z[j];
    e_sum += weights[j] * e[j];
  }
  for (std::size_t j = 0; j < n; ++j) {
    if (!path.pivot_fixed) {
      z[j] -= z_sum / weight;
      e[j] -= e_sum / weight;
    }
    crank_form += weights[j] * std::norm(e[j]);
    crank_point += weights[j] * conjugate_product(e[j], z[j]);
    squares += weights[j] * std::norm(z[j]);
  }
}

/// What a box's directions give: u = v[0] + Σ t_i v[i] + rest, |rest_j| ≤ rest[j], after a turn of
/// all directions together that takes out their common change; and the sums over v.
struct PathBound::Forms {
  std::array<std::vector<Complex>, kPathTerms> v;
  std::vector<double> rest;
  std::array<Complex, kPathTerms> mean{}, crank{}, point{};  ///< Σ w v/Σ w, Σ w ē v, Σ w z̄ v
  BoxQuadratic gram{};                                       ///< Re Σ w v̄ v, less the means'
  double turned = 0;                                         ///< greatest Σ |v[i]|
};

/// Lagrange multipliers of the limits.
struct PathBound::Multipliers {
  double on_square = 0;                                ///< of |s|²
  Complex on_crank;                                    ///< of s
  double on_point = 0;                                 ///< of |q|²
  double constant = 0;                                 ///< what the limits of s add to the error
  double q = std::numeric_limits<double>::infinity();  ///< |q| at the minimum they give
};

/// A bound, κ = Z − F, and by how much H is too small for the required bound.
struct PathBound::Bounded {
  double least = 0;
  double kappa = 0;
  double missing = 0;
};

struct PathBound::Loss {
  double of_form = 0;  ///< of H
  double of_u = 0;     ///< of U, by rounding alone
  double crank = 0;    ///< bound of |Σ w ē rest|
  double square = 0;   ///< Σ w |rest|²
};

PathBound::PathBound(TimedPath path, const ProportionLimits& limits)
    : path_(std::move(path)),
      limits_(limits),
      target_(std::make_shared<const Target>(path_, path_.weights)) {}

PathBound::Forms PathBound::linear_part(const std::vector<DirectionRange>& directions,
                                        std::vector<double>& weights) const {
  const std::size_t n = directions.size();
  constexpr double kMostRadius = 0.3, kMostRest = 0.5;
  std::array<double, kBoxSides> common{};
  double weight = 0;
  for (std::size_t j = 0; j < n; ++j) {
    if (directions[j].radius > kMostRadius) weights[j] = 0;
    weight += weights[j];
    for (int i = 0; i < kBoxSides; ++i) common[i] += weights[j] * directions[j].slope[i];
  }
  Forms f;
  f.rest.resize(n);
  for (auto& column : f.v) column.resize(n);
  for (std::size_t j = 0; j < n; ++j) {
    if (weights[j] == 0) continue;
    const DirectionRange& direction = directions[j];
    const Complex u{direction.middle.x, direction.middle.y};
    f.v[0][j] = u;
    double turned = 0;
    for (int i = 0; i < kBoxSides; ++i) {
      const double slope = direction.slope[i] - common[i] / weight;
      turned += std::abs(slope);
      f.v[i + 1][j] = {-slope * u.imag(), slope * u.real()};
    }
    // |e^{i(τ + r)} − 1 − iτ| ≤ τ²/2 + |r|.
    f.rest[j] = Interval::above(0.5 * turned * turned + direction.radius + 4 * kPathRounding);
    if (f.rest[j] > kMostRest) weights[j] = 0;
    if (weights[j] > 0) f.turned = std::max(f.turned, turned);
  }
  return f;
}

void PathBound::add_sums(const Target& target, Forms& f) const {
  const std::size_t n = target.weights.size();
  for (int a = 0; a < kPathTerms; ++a) {
    for (std::size_t j = 0; j < n; ++j) {
      const Complex wv = target.weights[j] * f.v[a][j];
      f.mean[a] += wv;
      f.crank[a] += conjugate_product(target.e[j], wv);
      f.point[a] += conjugate_product(target.z[j], wv);
      for (int b = 0; b <= a; ++b) f.gram[a][b] += real_product(f.v[b][j], wv);
    }
    f.mean[a] = path_.pivot_fixed ? Complex{} : f.mean[a] / target.weight;
    for (int b = 0; b <= a; ++b) {
      f.gram[a][b] -= target.weight * real_product(f.mean[a], f.mean[b]);
      f.gram[b][a] = f.gram[a][b];
    }
  }
}

/// What holds s within its limits at the middle of the box where q's multiplier is `on_point`.
PathBound::Multipliers PathBound::crank_multipliers(const Target& target, const Forms& f,
                                                    double low, double high,
                                                    double on_point) const {
  Multipliers m;
  m.on_point = on_point;
  const double inverse = 1 / (f.gram[0][0] + on_point);
  const Complex pull = std::conj(f.point[0]);
  const double curvature = target.crank_form - inverse * std::norm(f.crank[0]);
  const Complex slope = target.crank_point - inverse * product(f.crank[0], pull);
  Complex s;
  if (path_.direction_fixed) {
    s = std::clamp(slope.real() / curvature, low, high);
    m.on_crank = curvature * s - slope;
    const double along = m.on_crank.real();
    const bool held = (along > 0 && s == low) || (along < 0 && s == high);
    if (held) m.constant = 2 * along * s.real();
    if (!held) m.on_crank = {0, m.on_crank.imag()};
  } else {
    const double along = size_of(slope), length = std::clamp(along / curvature, low, high);
    s = along > 0 ? (length / along) * slope : Complex(length);
    // A multiplier of the other sign would hold s from the wrong side: no bound at all.
    const double pull_of_limit = curvature - along / length;
    const bool held = (pull_of_limit > 0 && length == low) || (pull_of_limit < 0 && length == high);
    if (held && pull_of_limit < target.crank_form) m.on_square = pull_of_limit;
    if (m.on_square != 0) m.constant = m.on_square * length * length;
  }
  m.q = inverse * size_of(pull - conjugate_product(f.crank[0], s));
  const double size = m.on_square + std::norm(m.on_crank) + m.constant + m.q;
  return std::isfinite(size) ? m : Multipliers{};
}

/// What holds s and q within their limits at the middle of the box: q falls as its multiplier
/// grows.
PathBound::Multipliers PathBound::multipliers(const Target& target, const Forms& f, double low,
                                              double high) const {
  const auto at = [&](double on_point) {
    return crank_multipliers(target, f, low, high, on_point);
  };
  Multipliers m = at(0);
  if (m.q <= path_.farthest_point) return m;
  double least = 1e-14 * target.weight, greatest = least;
  for (m = at(greatest); m.q > path_.farthest_point && greatest < 1e6 * target.weight;) {
    least = greatest;
    m = at(greatest *= 16);
  }
  while (greatest > 1.01 * least) {
    const double middle = std::sqrt(least * greatest);
    m = at(middle);
    (m.q > path_.farthest_point ? least : greatest) = middle;
  }
  return m;
}

double PathBound::bound(const std::vector<DirectionRange>& directions, double low, double high,
                        double wanted) const {
  std::vector<double> weights = path_.weights;
  Forms f = linear_part(directions, weights);
  const auto left = std::ranges::count_if(weights, [](double w) { return w > 0; });
  if (left < 3) return 0;
  // Errors at points of which the box says nothing are left out, which only lowers the bound.
  if (weights == path_.weights) return bound(*target_, f, low, high, wanted);
  return bound(Target(path_, std::move(weights)), f, low, high, wanted);
}

double PathBound::bound(const Target& target, Forms& f, double low, double high,
                        double wanted) const {
  add_sums(target, f);
  Multipliers m = multipliers(target, f, low, high);
  const Bounded first = bounded(target, f, m, wanted);
  const double far_square = path_.farthest_point * path_.farthest_point;
  // Where u is nearly t + s·e, H is too small for its rounding and rest. What q's multiplier adds
  // to it counts more there than what it takes from Z.
  const double added = 2 * first.missing / first.kappa;
  if (!(first.kappa > 0) || !(added > 0) || !(added * far_square < 0.3 * first.kappa)) {
    return first.least;
  }
  m.on_point += added;
  return std::max(first.least, bounded(target, f, m, wanted).least);
}

/// What the rest of u may take away from H, first by its product with H's gradient, then its own,
/// and the rounding of H. Besides bounds of |Σ w ē rest|, Σ w |rest|² and of the terms of U.
PathBound::Loss PathBound::loss(const Target& target, const Forms& f, const Multipliers& m,
                                const std::array<Complex, kPathTerms>& b, double kappa) const {
  const std::size_t n = target.weights.size();
  const double per_form = 1 / (target.crank_form - m.on_square);
  const Complex pulled = target.crank_point + m.on_crank;
  Loss loss;
  double b_of_rest = 0, b_size = 0, crank_size = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const double w = target.weights[j], rest = f.rest[j];
    if (w == 0) continue;
    const Complex y = target.z[j] - per_form * product(target.e[j], pulled);
    double gradient = 0;
    for (int a = 0; a < kPathTerms; ++a) {
      const Complex part = f.v[a][j] - f.mean[a] - per_form * product(target.e[j], f.crank[a]);
      gradient += size_of(kappa * part - product(y, b[a]));
    }
    const double crank = size_of(target.e[j]);
    loss.of_form += 2 * w * rest * gradient;
    b_of_rest += w * size_of(y) * rest;
    loss.crank += w * crank * rest;
    loss.square += w * rest * rest;
    // Of the terms, not of y, in which they may cancel.
    b_size += w * (size_of(target.z[j]) + per_form * crank * size_of(pulled));
    crank_size += w * crank;
  }
  loss.of_form += b_of_rest * b_of_rest;
  if (m.on_square > 0) loss.of_form += kappa * per_form * loss.crank * loss.crank;
  const double reach = 1 + f.turned;
  const double rounding = kPathRounding * double(n + 16) * reach * reach;
  loss.of_u = rounding * (target.weight + per_form * crank_size * crank_size + m.on_point);
  loss.of_form += kappa * loss.of_u + rounding * b_size * b_size;
  return loss;
}

PathBound::Bounded PathBound::bounded(const Target& target, const Forms& f, const Multipliers& m,
                                      double wanted) const {
  const std::size_t n = target.weights.size();
  const double per_form = 1 / (target.crank_form - m.on_square);
  const Complex pulled = target.crank_point + m.on_crank;

  BoxQuadratic form{}, h{};
  std::array<Complex, kPathTerms> b;
  for (int a = 0; a < kPathTerms; ++a) {
    b[a] = f.point[a] - per_form * conjugate_product(pulled, f.crank[a]);
    for (int c = 0; c < kPathTerms; ++c) {
      form[a][c] = f.gram[a][c] - per_form * real_product(f.crank[a], f.crank[c]);
    }
  }
  const double far_square = m.on_point > 0 ? path_.farthest_point * path_.farthest_point : 0;
  const double kept = per_form * std::norm(pulled), far = m.on_point * far_square;
  const double rounding = kPathRounding * double(n + 16);
  const double kappa = target.squares - kept + m.constant - far - wanted -
                       rounding * (target.squares + kept + std::abs(m.constant) + far);
  if (!(kappa > 0)) return {};
  for (int a = 0; a < kPathTerms; ++a) {
    for (int c = 0; c < kPathTerms; ++c) h[a][c] = kappa * form[a][c] - real_product(b[a], b[c]);
  }
  h[0][0] += kappa * m.on_point;

  const Loss lost = loss(target, f, m, b, kappa);
  const double least = least_over_box(h) - lost.of_form * (1 + 1e-12);
  if (least >= 0) return {wanted, kappa, 0};

  // H = U·(error − wanted): divided by the least U of the box.
  const auto length = [&](const BoxQuadratic& q) {
    double size = std::sqrt(std::max(0.0, q[0][0])) - std::sqrt(lost.square);
    for (int a = 1; a < kPathTerms; ++a) size -= std::sqrt(std::max(0.0, q[a][a]));
    return std::max(0.0, size);
  };
  const bool indefinite = m.on_square > 0;
  const double size = length(indefinite ? f.gram : form);
  double smallest = m.on_point + size * size - lost.of_u;
  if (indefinite) {
    double crank = lost.crank;
    for (const Complex& c : f.crank) crank += size_of(c);
    smallest -= per_form * crank * crank;
  }
  const double bound = smallest > 0 ? std::max(0.0, wanted + 1.000001 * least / smallest) : 0;
  return {bound, kappa, -least};
}

BoxBound PathBound::operator()(const ProportionBox& box, double wanted) const {
  const bool turning = box.proportions != Proportions::any;
  const ProportionRanges ranges = ranges_of(box);
  double low = 0, high = 0;
  if (!may_satisfy(ranges, limits_, turning) || !crank_range(ranges, path_.lengths, low, high)) {
    return {kInfinity, -1};
  }
  if (turning && !may_transmit(ranges, limits_, ranges.inner, ranges.outer)) {
    return {kInfinity, -1};
  }
  const BoxDirections box_directions(box);
  std::vector<DirectionRange> directions;
  for (std::size_t j = 0; j < path_.crank_angles.size(); ++j) {
    directions.push_back(box_directions.at(path_.crank_angles[j], DirectedLink::coupler));
    const DirectionRange& at = directions.back();
    if (!at.closes) return {kInfinity, -1};
    if (!turning && !may_transmit(ranges, limits_, at.diagonal, at.diagonal)) {
      return {kInfinity, -1};
    }
  }
  return {bound(directions, low, high, wanted), worst_side(box, directions)};
}

}  // namespace cognate::synthesis
