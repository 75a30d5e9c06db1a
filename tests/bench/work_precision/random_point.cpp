#include <algorithm>

#include "tests/bench/work_precision/contest.hpp"

namespace cognate::bench {

std::optional<std::vector<double>> random_point(const synthesis::Model& model, double reach,
                                                std::mt19937_64& random) {
  constexpr int kDraws = 1000;
  std::vector<double> x(model.variables().size());
  std::vector<double> r(static_cast<std::size_t>(model.residual_count()));
  for (int draw = 0; draw < kDraws; ++draw) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const synthesis::Variable& v = model.variables()[i];
      const double low = std::max(v.lower, -reach), high = std::min(v.upper, reach);
      x[i] = std::uniform_real_distribution<double>(low, std::max(low, high))(random);
    }
    if (model.residuals(x, r, {}, {})) return x;
  }
  return std::nullopt;
}

}  // namespace cognate::bench
