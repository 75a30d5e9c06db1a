// A coupler curve by a batch, on the vector instructions of whatever machine this runs on: the pin
// C as coupler point stays at its distance from D.
#include <cmath>
#include <cognate/analysis/batch/four_bar_batch.hpp>
#include <vector>

int main() {
  const cognate::FourBar linkage{.pivot_a = {0, 0},
                                 .pivot_d = {4, 0},
                                 .crank = 1,
                                 .coupler = 3,
                                 .rocker = 3.5,
                                 .coupler_point = cognate::Vec2d{3, 0}};
  const auto cranks = cognate::CrankTable<double>::full_turn(360);
  std::vector<double> x(360), y(360);
  const auto status = cognate::evaluate_batch(linkage, cranks, {.x = x, .y = y});
  if (status != cognate::BatchStatus::done) return 1;
  for (std::size_t i = 0; i < 360; ++i) {
    if (!(std::abs(std::hypot(x[i] - 4, y[i]) - 3.5) < 1e-14)) return 1;
  }
  return 0;
}
