#include "analysis/tolerance/affine_mechanism.hpp"

namespace cognate {

AffineMechanism::AffineMechanism(MechanismWithPoints<double> nominal,
                                 const std::vector<std::vector<double>>& slopes)
    : nominal_(std::move(nominal)), dimensions_(slopes.size()) {
  const std::size_t count = numbers(nominal_).size();
  begin_.assign(1, 0);
  for (std::size_t number = 0; number < count; ++number) {
    for (std::size_t dimension = 0; dimension < slopes.size(); ++dimension) {
      const double factor = slopes[dimension][number];
      if (factor == 0) continue;
      dimension_.push_back(dimension);
      factor_.push_back(factor);
    }
    begin_.push_back(factor_.size());
  }
}

std::vector<double> AffineMechanism::numbers(const MechanismWithPoints<double>& nominal) {
  std::vector<double> all;
  const auto record = [&](double number) {
    all.push_back(number);
    return number;
  };
  convert<double>(nominal.mechanism, record);
  for (const Attached<double>& point : nominal.points) {
    all.push_back(point.at.x);
    all.push_back(point.at.y);
  }
  return all;
}

}  // namespace cognate
