// A full turn of the same four-bar in 3600 positions: arrays out, on the machine's vector
// instructions. A column that is given is computed, any other is not.
#include <algorithm>
#include <cmath>
#include <cognate/batch.hpp>
#include <cognate/units.hpp>
#include <cstdio>
#include <vector>

using namespace cognate::literals;

int main() {
  constexpr std::size_t kPositions = 3600;
  cognate::FourBar linkage;
  linkage.pivot_d = {13, 0};
  linkage.crank = 1;
  linkage.coupler = 13;
  linkage.rocker = 15;
  const auto cranks = cognate::CrankTable<double>::full_turn(kPositions);
  std::vector<double> sines(kPositions), cosines(kPositions);
  const auto status = cognate::evaluate_batch(
      linkage, cranks, {.transmission_sin = sines, .transmission_cos = cosines});
  if (status != cognate::BatchStatus::done) return 1;

  // By the law of cosines the extremes stand where the crank is in line with the frame.
  const auto [least, greatest] = std::ranges::minmax(cosines);
  std::printf("transmission angle from %.3f to %.3f degrees\n", std::acos(greatest) / 1_deg,
              std::acos(least) / 1_deg);
}

// transmission angle from 50.132 to 59.490 degrees
