// A model of your own, given to every solver that can take it: the line a + b t through three
// points of 2 - 3 t.
#include <array>
#include <cognate/optimise.hpp>
#include <cstdio>

namespace synthesis = cognate::synthesis;

class Line : public synthesis::Model {
 public:
  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override { return 3; }

  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double>) const override {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto t = static_cast<double>(i);
      r[i] = x[0] + x[1] * t - (2 - 3 * t);
      if (jacobian.empty()) continue;
      jacobian[2 * i] = 1;
      jacobian[2 * i + 1] = t;
    }
    return true;
  }

 private:
  std::array<synthesis::Variable, 2> variables_{
      {{.name = "a", .lower = -10, .upper = 10}, {.name = "b", .lower = -10, .upper = 10}}};
};

int main() {
  using enum synthesis::Solver;
  const Line line;
  for (const auto solver : {gauss_newton, ceres, slsqp, mma, ccsaq, cobyla, bobyqa, ags, isres, crs,
                            mlsl, direct, ipopt}) {
    if (!can_solve(solver, line)) continue;
    const auto solution = solve(solver, line, std::array{0.5, 0.5});
    std::printf("%-12s a = %.3f, b = %.3f\n", name(solver).data(), solution.x[0], solution.x[1]);
  }
}

// gauss-newton a = 2.000, b = -3.000
// ceres        a = 2.000, b = -3.000
// slsqp        a = 2.000, b = -3.000
// mma          a = 2.000, b = -3.000
// ccsaq        a = 2.000, b = -3.000
// cobyla       a = 2.000, b = -3.000
// bobyqa       a = 2.000, b = -3.000
// ags          a = 2.000, b = -3.000
// isres        a = 2.000, b = -3.000
// crs          a = 2.000, b = -3.000
// mlsl         a = 2.000, b = -3.000
// direct       a = 2.000, b = -3.000
// ipopt        a = 2.000, b = -3.000
