/// The equations, Newton's corrections and the conditions of every instruction set, against
/// difference quotients and a dense solution that share nothing with the elimination of rotations.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <complex>
#include <random>
#include <vector>

#include "synthesis/exact/nine_point/path_equations.hpp"
#include "synthesis/exact/nine_point/start_set.hpp"

namespace cognate::synthesis::nine_point::nine_point_equations_test {
namespace {

using Extended = std::complex<long double>;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  template <class C = Number>
  C number() {
    const double re = uniform_(engine_), im = uniform_(engine_);
    return C(re, im);
  }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

TEST(NinePointEquations, PartialsAreDifferenceQuotients) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    Dyad<Extended> dyad{random.number<Extended>(), random.number<Extended>(),
                        random.number<Extended>(), random.number<Extended>()};
    const Extended t = random.number<Extended>() + Extended(2);
    CouplerMove<Extended> to{t, Extended(1) / t, random.number<Extended>(),
                             random.number<Extended>()};
    const auto f = dyad_equation(dyad, to);
    // f is linear in each of these: any step gives the partial derivative.
    const auto quotient = [&](Extended& unknown) {
      const Extended kept = unknown, step(0.5L, 0.25L);
      unknown = kept + step;
      const Extended above = dyad_equation(dyad, to).value;
      unknown = kept;
      return (above - f.value) / step;
    };
    const long double tolerance = 1e-17L;
    EXPECT_LT(std::abs(quotient(dyad.moving) - f.moving), tolerance);
    EXPECT_LT(std::abs(quotient(dyad.moving_bar) - f.moving_bar), tolerance);
    EXPECT_LT(std::abs(quotient(dyad.fixed) - f.fixed), tolerance);
    EXPECT_LT(std::abs(quotient(dyad.fixed_bar) - f.fixed_bar), tolerance);
    EXPECT_LT(std::abs(quotient(to.d) - f.d), tolerance);
    EXPECT_LT(std::abs(quotient(to.d_bar) - f.d_bar), tolerance);
    // In log t it is A e^s + B e^{−s} + C, whose symmetric difference quotient has sinh(h)/h.
    const long double h = 0.25L;
    CouplerMove<Extended> after = to, before = to;
    after.t *= std::exp(h);
    after.inverse_t *= std::exp(-h);
    before.t *= std::exp(-h);
    before.inverse_t *= std::exp(h);
    const Extended log_t =
        (dyad_equation(dyad, after).value - dyad_equation(dyad, before).value) / (2 * std::sinh(h));
    EXPECT_LT(std::abs(log_t - f.log_t), 10 * tolerance);
  }
}

/// The dense Jacobian by pivots and rotations, and by the data d and d̄ (and log t of poses).
struct Dense {
  Eigen::MatrixXcd jacobian, by_data;
  Eigen::VectorXcd value;
};

Dense dense(const PathParameters& data, std::span<const Pair> root) {
  const int poses = static_cast<int>(data.t.size()), count = static_cast<int>(data.d.size());
  Dense all;
  all.jacobian = Eigen::MatrixXcd::Zero(2 * count, kPivots + count - poses);
  all.by_data = Eigen::MatrixXcd::Zero(2 * count, 2 * count + poses);
  all.value.resize(2 * count);
  for (int j = 0; j < count; ++j) {
    const Number t = j < poses ? data.t[j] : number(root[kPivots + j - poses]);
    for (int e = 0; e < 2; ++e) {
      const auto z = [&](int i) { return number(root[4 * e + i]); };
      const auto f = dyad_equation(Dyad<Number>{z(0), z(1), z(2), z(3)},
                                   CouplerMove<Number>{t, 1.0 / t, data.d[j], data.d_bar[j]});
      const int row = 2 * j + e;
      all.value(row) = f.value;
      const Number pivots[4] = {f.moving, f.moving_bar, f.fixed, f.fixed_bar};
      for (int i = 0; i < 4; ++i) all.jacobian(row, 4 * e + i) = pivots[i];
      if (j >= poses) all.jacobian(row, kPivots + j - poses) = f.log_t;
      all.by_data(row, 2 * j) = f.d;
      all.by_data(row, 2 * j + 1) = f.d_bar;
      if (j < poses) all.by_data(row, 2 * count + j) = f.log_t;
    }
  }
  return all;
}

TEST(NinePointEquations, CorrectionsAndConditionsAreThoseOfTheDenseSystem) {
  Random random(2);
  for (int poses = 1; poses <= 5; ++poses) {
    const PathClass kind{poses, 10 - 2 * poses};
    PathParameters data{kind, {}, {}, {}};
    for (int j = 0; j < poses - 1 + kind.points; ++j) {
      data.d.push_back(random.number());
      data.d_bar.push_back(random.number());
      if (j < poses - 1) data.t.push_back(random.number() + 2.0);
    }
    // 19 roots are no multiple of any number of lanes.
    const int size = unknowns(kind.points), count = 19;
    std::vector<Pair> roots;
    for (int i = 0; i < count * size; ++i) roots.push_back(pair(random.number() + 1.5));
    for (const InstructionSet set : instruction_sets()) {
      for (const bool extended : {false, true}) {
        TrackingOptions means;
        means.set = set;
        const Inspection seen =
            inspect(roots, kind.points, parameter_line(data, data), extended, means);
        for (int i = 0; i < count; ++i) {
          const Dense all = dense(data, std::span(roots).subspan(std::size_t(i) * size, size));
          const auto lu = all.jacobian.fullPivLu();
          const Eigen::VectorXcd change = lu.solve(-all.value);
          double worst = 0;
          for (int k = 0; k < size; ++k) {
            worst = std::max(worst, std::abs(change(k) - number(seen.changes[i * size + k])));
          }
          EXPECT_LT(worst, 1e-9 * (1 + change.norm())) << name(set) << " poses " << poses;
          const double condition = lu.solve(all.by_data).topRows(kPivots).norm();
          EXPECT_NEAR(seen.conditions[i] / condition, 1, 1e-8) << name(set);
        }
      }
    }
  }
}

}  // namespace
}  // namespace cognate::synthesis::nine_point::nine_point_equations_test
