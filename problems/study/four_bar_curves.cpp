#include "problems/study/four_bar_curves.hpp"

#include <algorithm>

namespace cognate::problems {

FourBarCurves::FourBarCurves(std::size_t steps, std::size_t most)
    : most_(most), cranks_(CrankTable<double>::full_turn(steps)) {
  for (auto& column : designs_) column.resize(most);
  samples_.resize(steps * most);
  one_.resize(steps);
}

void FourBarCurves::sample(std::span<const FourBar> linkages) {
  // The last is repeated, so that every lane holds a linkage.
  for (std::size_t i = 0; i < most_; ++i) {
    const FourBar& linkage = linkages[std::min(i, linkages.size() - 1)];
    const std::array<double, 10> numbers{
        linkage.pivot_a.x,       linkage.pivot_a.y,      linkage.pivot_d.x,
        linkage.pivot_d.y,       linkage.crank,          linkage.coupler,
        linkage.rocker,          sign(linkage.assembly), linkage.coupler_point->x,
        linkage.coupler_point->y};
    for (std::size_t k = 0; k < numbers.size(); ++k) designs_[k][i] = numbers[k];
  }
  const auto& d = designs_;
  const FourBarArrays<double> arrays{d[0], d[1], d[2], d[3], d[4], d[5], d[6], d[7], d[8], d[9]};
  const BatchStatus status = evaluate_batch(
      arrays, cranks_,
      FourBarColumns<double>{
          .x = samples_.x, .y = samples_.y, .velocity_x = samples_.dx, .velocity_y = samples_.dy});
  static_cast<void>(status);  // sizes agree, and the widest instruction set is there
  sums_.add_up(samples_.samples(), most_);
}

CurveSamples FourBarCurves::curve(std::size_t i) {
  for (std::size_t j = 0; j < one_.x.size(); ++j) {
    const std::size_t at = j * most_ + i;
    one_.x[j] = samples_.x[at];
    one_.y[j] = samples_.y[at];
    one_.dx[j] = samples_.dx[at];
    one_.dy[j] = samples_.dy[at];
  }
  return one_.samples();
}

}  // namespace cognate::problems
