#include "problems/chain/free_chain.hpp"

#include <cmath>

namespace cognate::problems {

void watch(const ChainSpace& space, const std::vector<TransmissionCheck>& fresh,
           std::vector<TransmissionCheck>& watched) {
  watched.insert(watched.end(), fresh.begin(), fresh.end());
  if (!has_three_pin_link(*space.topology)) return;
  std::ranges::stable_sort(watched, {},
                           [](const TransmissionCheck& check) { return in_one_turn(check.crank); });
}

void transmission_constraints(FreeChain& chain, double limit,
                              std::span<const TransmissionCheck> checks, std::size_t columns,
                              std::span<double> c, std::span<double> jacobian,
                              std::optional<CheckTurn> turn) {
  for (std::size_t k = 0; k < checks.size(); ++k) {
    TransmissionCheck check = checks[k];
    if (turn) check.crank += turn->angle;
    const double cosine = chain.cosine(check);
    const bool known = std::isfinite(cosine);
    c[2 * k] = known ? limit - cosine : -1;
    c[2 * k + 1] = known ? limit + cosine : -1;
    if (jacobian.empty()) continue;
    double* row = jacobian.data() + 2 * k * columns;
    std::fill_n(row, 2 * columns, 0.0);
    if (!known) continue;
    const double slope = chain.cosine_slope(check, cosine, row + columns);
    if (turn) row[columns + turn->column] = slope;
    for (std::size_t i = 0; i < columns; ++i) row[i] = -row[columns + i];
  }
}

}  // namespace cognate::problems
