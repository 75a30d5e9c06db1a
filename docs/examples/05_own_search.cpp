// All solutions of a model of your own, from many starts: where a circle of radius 5 meets the
// hyperbola x y = 12.
#include <algorithm>
#include <array>
#include <cognate/search.hpp>
#include <cstdio>
#include <vector>

namespace synthesis = cognate::synthesis;

class Crossing : public synthesis::Model {
 public:
  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override { return 2; }

  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double>) const override {
    r[0] = x[0] * x[0] + x[1] * x[1] - 25;
    r[1] = x[0] * x[1] - 12;
    const std::array rows{2 * x[0], 2 * x[1], x[1], x[0]};
    if (!jacobian.empty()) std::ranges::copy(rows, jacobian.begin());
    return true;
  }

 private:
  std::array<synthesis::Variable, 2> variables_{
      {{.name = "x", .lower = -10, .upper = 10}, {.name = "y", .lower = -10, .upper = 10}}};
};

int main() {
  const auto found = synthesis::search(Crossing{}, {.designs = 10, .seed = 7});
  std::vector<std::vector<double>> points;
  for (const auto& minimum : found.minima) {
    if (minimum.solution.objective < 1e-18) points.push_back(minimum.solution.x);
  }
  std::ranges::sort(points);
  for (const auto& point : points) std::printf("(%.6f, %.6f)\n", point[0], point[1]);
}

// (-4.000000, -3.000000)
// (-3.000000, -4.000000)
// (3.000000, 4.000000)
// (4.000000, 3.000000)
