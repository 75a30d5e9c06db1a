#include "problems/chain/starts/heading.hpp"

#include <vector>

#include "analysis/numbers/angle.hpp"
#include "problems/chain/free_chain.hpp"

namespace cognate::problems {

double turn_body(const ScaledChain& problem, std::span<const std::size_t> which,
                 std::span<const double> cranks, synthesis::ChainDesign& design) {
  const WantedHeadings& wanted = problem.headings;
  const auto line = static_cast<std::size_t>(wanted.line);
  double& own = design.parameters[static_cast<std::size_t>(problem.lines[line].parameter)];
  own = 0;
  const std::vector<double> side(design.side.begin(), design.side.end());
  FreeChain chain(problem, design.parameters, side);
  Vec2d mean;
  for (std::size_t i = 0; i < which.size(); ++i) {
    chain.at(cranks[i]);
    const double turned = chain.turned(wanted.line, wanted.directions[which[i]]);
    mean = mean + (1.0 / double(which.size())) * unit_vector(-turned);
  }
  own = angle_of(mean);
  return wanted.weight * wanted.weight * (2 - 2 * norm(mean));
}

}  // namespace cognate::problems
