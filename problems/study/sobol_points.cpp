#include <boost/random/sobol.hpp>
#include <vector>

#include "problems/basics/counter_random.hpp"
#include "problems/study/sampling.hpp"

namespace cognate::problems {

UnitPoints sobol_points(std::size_t dimensions, std::uint64_t seed) {
  std::vector<std::uint64_t> shift(dimensions, 0);
  for (std::size_t d = 0; d < dimensions && seed != 0; ++d) shift[d] = random_word(seed, d, 0);
  return [shift = std::move(shift), engine = boost::random::sobol(dimensions)](
             std::int64_t first, std::span<double> points) mutable {
    const std::size_t dimensions = shift.size();
    std::size_t i = 0;
    // The library leaves out the point 0: its element n is point n + 1.
    if (first == 0) {
      for (; i < dimensions && i < points.size(); ++i) points[i] = unit_number(shift[i]);
    }
    engine.seed(static_cast<std::uint64_t>(first == 0 ? 0 : first - 1));
    for (; i < points.size(); ++i) points[i] = unit_number(engine() ^ shift[i % dimensions]);
  };
}

}  // namespace cognate::problems
