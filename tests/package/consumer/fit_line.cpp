// A user's own problem, given to every solver: the line a + b t through three points of 2 - 3 t.
#include <array>
#include <cmath>
#include <cognate/synthesis/optimise/solver.hpp>
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
  using enum synthesis::Backend;
  int wrong = 0;
  const Line line;
  for (const auto backend : {gauss_newton, ceres, slsqp, cobyla, ipopt}) {
    const auto solution = synthesis::solve(backend, line, std::array{0.5, 0.5});
    const bool right = std::abs(solution.x[0] - 2) < 1e-4 && std::abs(solution.x[1] + 3) < 1e-4;
    std::printf("%s: %s, a = %.9g, b = %.9g\n", right ? "right" : "wrong",
                synthesis::name(backend).data(), solution.x[0], solution.x[1]);
    wrong += right ? 0 : 1;
  }
  return wrong;
}
