/// Slider-cranks of a given offset through three or four conditions.
#include <Eigen/LU>
#include <array>
#include <cassert>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/binary_form.hpp"
#include "synthesis/exact/function/slider_equation.hpp"
#include "synthesis/exact/null_plane.hpp"
#include "synthesis/exact/polish.hpp"
#include "synthesis/exact/reflections.hpp"

namespace cognate::synthesis {
namespace {

/// The equations in r, c and those starts that are to be found, the offset e being known.
template <int N>
class OffsetEquations {
 public:
  OffsetEquations(const SliderSetting& setting, double offset)
      : setting_(setting), offset_(offset) {}

  Linearised<N> operator()(const Unknowns<N>& x) const {
    const auto [phi, origin] = start_of(x);
    const Vec2d turn = unit_vector(phi);
    const double r = x[0], c = x[1];
    Linearised<N> result;
    for (int i = 0; i < N; ++i) {
      const SliderRow& row = setting_.rows[static_cast<std::size_t>(i)];
      const Vec2d d = row.u * turn, sd = (row.su + origin * row.u) * turn;
      const double square = row.square + origin * (2 * row.s + origin * row.constant);
      const double by_crank = -2 * (sd.x + offset_ * d.y);
      const double scale =
          std::abs(row.square) + 2 * std::abs(origin * row.s) + origin * origin * row.constant +
          2 * std::abs(r) * (norm1(sd) + std::abs(offset_) * norm1(d)) + std::abs(c) * row.constant;
      result.value[i] = (square + r * by_crank + c * row.constant) / scale;
      result.slope(i, 0) = by_crank / scale;
      result.slope(i, 1) = row.constant / scale;
      const double by_input = 2 * r * (sd.y - offset_ * d.x);
      const double by_output = 2 * (row.s + origin * row.constant - r * d.x);
      if constexpr (N == 3) {
        result.slope(i, 2) = (setting_.start.input ? by_output : by_input) / scale;
      } else {
        result.slope(i, 2) = by_input / scale;
        result.slope(i, 3) = by_output / scale;
      }
    }
    return result;
  }

  Unknowns<N> unknowns(const SliderCoefficients& c) const {
    Unknowns<N> x;
    x[0] = c.r;
    x[1] = c.c;
    if constexpr (N == 3) {
      x[2] = setting_.start.input ? c.output_start : c.input_start;
    } else {
      x[2] = c.input_start;
      x[3] = c.output_start;
    }
    return x;
  }

  SliderCoefficients coefficients(const Unknowns<N>& x) const {
    const auto [phi, origin] = start_of(x);
    return {1, x[0], x[0] * offset_, x[1], phi, origin};
  }

 private:
  std::array<double, 2> start_of(const Unknowns<N>& x) const {
    if constexpr (N == 4) return {x[2], x[3]};
    return setting_.start.input ? std::array{*setting_.start.input, x[2]} : std::array{x[2], 0.0};
  }

  const SliderSetting& setting_;
  double offset_;
};

/// Solutions as they are found; `offset` in the scaled unit.
class OffsetSolver {
 public:
  OffsetSolver(const SliderSetting& setting, double offset)
      : setting_(setting), offset_(offset / setting.scale.unit), given_(offset) {}

  /// Columns s², 2s, −2(S cos θ + e sin θ) without s₀, −2 cos θ, 1 with coefficients h, p = s₀ h,
  /// r, w = s₀ r and C; w h = p r.
  SliderCrankFunctions with_input_given() {
    const Vec2d turn = unit_vector(*setting_.start.input);
    Eigen::Matrix<double, 3, 5> m;
    for (int i = 0; i < 3; ++i) {
      const SliderRow& row = setting_.rows[static_cast<std::size_t>(i)];
      const Vec2d d = row.u * turn, sd = row.su * turn;
      m.row(i) << row.square, 2 * row.s, -2 * (sd.x + offset_ * d.y), -2 * d.x, row.constant;
    }
    const auto basis = null_basis<2>(m);
    result_.dependent = !basis;
    if (!basis) return result_;
    using Vector = Eigen::Matrix<double, 5, 1>;
    const auto differ = [](const Vector& a, const Vector& b) { return a[3] * b[0] - a[1] * b[2]; };
    const auto& [u, v] = *basis;
    for (const Vec2d& root : real_roots(quadratic_form(differ, u, v))) {
      const Vector x = root.x * u + root.y * v;
      if (std::abs(x[0]) <= kNone && std::abs(x[2]) <= kNone) {
        add_yoke(x[3], x[1]);
      } else if (const auto outcome = infinite_slider_part(x[0], x[2]);
                 outcome != SliderCrankOutcome::linkage) {
        add_slider_limit(outcome, 0, result_);
      } else {
        const double origin = x[1] / x[0];
        add<3>({1, x[2] / x[0], 0, x[4] / x[0] - origin * origin, *setting_.start.input, origin});
      }
    }
    return result_;
  }

  /// Linear in R = r e^{iφ₀}: columns S², the parts of R, 1.
  SliderCrankFunctions with_output_given() {
    Eigen::Matrix<double, 3, 4> m;
    for (int i = 0; i < 3; ++i) {
      const SliderRow& row = setting_.rows[static_cast<std::size_t>(i)];
      m.row(i) << row.square, by_real(row), by_imaginary(row), row.constant;
    }
    const auto basis = null_basis<1>(m);
    result_.dependent = !basis;
    if (!basis) return result_;
    const auto& x = (*basis)[0];
    const Vec2d crank{x[1], x[2]};
    const auto outcome = infinite_slider_part(x[0], norm(crank));
    if (outcome != SliderCrankOutcome::linkage) {
      add_slider_limit(outcome, 0, result_);
    } else {
      add_from((1 / x[0]) * crank, x[3] / x[0], 0);
    }
    return result_;
  }

  /// For a given s₀ the four equations are linear in R and C; that they have a solution is a cubic
  /// of s₀, whose coefficients come from the columns without and with s₀.
  SliderCrankFunctions with_none_given() {
    std::array<Columns, 2> parts;
    for (int i = 0; i < 4; ++i) {
      const SliderRow& row = setting_.rows[static_cast<std::size_t>(i)];
      const Eigen::RowVector4d plain{row.square, by_real(row), by_imaginary(row), row.constant};
      const Eigen::RowVector4d with{2 * row.s, -2 * row.u.x, 2 * row.u.y, 0};
      const double size = std::max(plain.cwiseAbs().maxCoeff(), with.cwiseAbs().maxCoeff());
      parts[0].row(i) = plain / size;
      parts[1].row(i) = with / size;
    }
    // Of α³, α²β, αβ², β³ with s₀ = α/β: sums over which columns are those with s₀.
    std::array<double, 4> form{};
    for (unsigned choice = 0; choice < 8; ++choice) {
      Columns m = parts[0];
      std::size_t power = 0;
      for (int column = 0; column < 3; ++column) {
        if ((choice >> column & 1U) == 0) continue;
        m.col(column) = parts[1].col(column);
        ++power;
      }
      form[3 - power] += m.determinant();
    }
    double largest = 0;
    for (const double each : form) largest = std::max(largest, std::abs(each));
    result_.dependent = !(largest > kDependent);
    if (result_.dependent) return result_;
    for (const Vec2d& root : real_roots(form)) add_for_start(root, parts);
    return result_;
  }

 private:
  using Columns = Eigen::Matrix4d;
  using ThreeColumns = Eigen::Matrix<double, 4, 3>;

  static constexpr double kNone = 1e-11;       ///< of a unit vector: as good as zero
  static constexpr double kDependent = 1e-13;  ///< determinants of rows of size one

  /// The coefficients of the parts of R where s₀ = 0: −2 Re(R su) − 2e Im(R u).
  double by_real(const SliderRow& row) const { return -2 * (row.su.x + offset_ * row.u.y); }
  double by_imaginary(const SliderRow& row) const { return 2 * (row.su.y - offset_ * row.u.x); }

  void add_for_start(const Vec2d& root, const std::array<Columns, 2>& parts) {
    if (std::abs(root.y) <= kNone) {
      // s₀ at infinity: s is harmonic in φ.
      ThreeColumns m;
      m << parts[1].col(1), parts[1].col(2), parts[0].col(3);
      const Eigen::Vector3d x =
          solved(Eigen::ColPivHouseholderQR<ThreeColumns>(m), -parts[1].col(0));
      add_yoke(std::hypot(x[0], x[1]), 1);
      return;
    }
    const double origin = root.x / root.y;
    const Columns all = parts[0] + origin * parts[1];
    const ThreeColumns m = all.rightCols<3>();
    const Eigen::Vector3d x = solved(Eigen::ColPivHouseholderQR<ThreeColumns>(m), -all.col(0));
    const Vec2d crank{x[0], x[1]};
    if (!(norm(crank) > kNone)) {
      add_slider_limit(SliderCrankOutcome::no_crank, 0, result_);
    } else {
      add_from(crank, x[2] - origin * origin, origin);
    }
  }

  void add_from(const Vec2d& crank, double c, double origin) {
    const SliderCoefficients found{1, norm(crank), 0, c, angle_of(crank), origin};
    if (setting_.start.output) {
      add<3>(found);
    } else {
      add<4>(found);
    }
  }

  void add_yoke(double q, double p) {
    if (std::abs(p) > kNone) {
      add_slider_limit(SliderCrankOutcome::scotch_yoke,
                       setting_.scale.unit * std::abs(q) / std::abs(p), result_);
    } else {
      add_slider_limit(SliderCrankOutcome::infinite_links, 0, result_);
    }
  }

  template <int N>
  void add(const SliderCoefficients& c) {
    const OffsetEquations<N> equations(setting_, offset_);
    const Root<N> root = polish<N>(equations, equations.unknowns(c));
    if (!(root.residual <= kAcceptedSliderResidual)) return;
    SliderCrankFunction found = slider_linkage(equations.coefficients(root.x), setting_);
    found.offset = given_;
    found.residual = root.residual;
    found.condition = root.condition;
    result_.solutions.push_back(found);
  }

  const SliderSetting& setting_;
  double offset_, given_;
  SliderCrankFunctions result_;
};

}  // namespace

SliderCrankFunctions slider_crank_functions(std::span<const PrecisionPoint> points,
                                            const GivenStart& start, double offset) {
  assert(!(start.input && start.output));
  assert(condition_count(points) ==
         static_cast<std::size_t>(2 + int{!start.input} + int{!start.output}));
  const SliderScale scale = slider_scale(points, start);
  const SliderRows rows = slider_rows(points, scale);
  const SliderSetting setting{rows, start, scale};
  OffsetSolver solver(setting, offset);
  if (start.input) return solver.with_input_given();
  return start.output ? solver.with_output_given() : solver.with_none_given();
}

}  // namespace cognate::synthesis
