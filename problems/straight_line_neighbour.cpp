#include "problems/straight_line_neighbour.hpp"

#include "problems/counter_random.hpp"

namespace cognate::problems {

std::optional<LineStretch> neighbour(const LineStretch& stretch, double share, std::uint64_t seed,
                                     std::uint64_t stream) {
  std::uint64_t index = 0;
  const auto change = [&] {
    return share * (2 * unit_number(random_word(seed, stream, index++)) - 1);
  };
  LineStretch near = stretch;
  for (double& link : near.dimensions.links) link *= 1 + change();
  const double size = largest_dimension(stretch);
  near.dimensions.point.x += change() * size;
  near.dimensions.point.y += change() * size;
  near.centre += change() * stretch.reach;
  near.reach *= 1 + change();
  return fit_line(near) ? std::optional(near) : std::nullopt;
}

}  // namespace cognate::problems
