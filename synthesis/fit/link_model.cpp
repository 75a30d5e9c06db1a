#include "synthesis/fit/link_model.hpp"

#include <cmath>

#include "analysis/numbers/angle.hpp"

namespace cognate::synthesis {

LinkModel::LinkModel(std::span<const Pose> poses, double unit) {
  for (const Pose& pose : poses) {
    at_.push_back(pose.at);
    direction_.push_back(unit_vector(pose.angle));
  }
  const double far = kReach * unit;
  variables_ = {Variable{"moving pivot u", -far, far, unit},
                {"moving pivot v", -far, far, unit},
                {"fixed pivot x", -far, far, unit},
                {"fixed pivot y", -far, far, unit},
                {"length", 0, far, unit}};
}

bool LinkModel::residuals(std::span<const double> x, std::span<double> r,
                          std::span<double> jacobian, std::span<double>) const {
  const Vec2d moving{x[0], x[1]}, fixed{x[2], x[3]};
  for (std::size_t j = 0; j < at_.size(); ++j) {
    const Vec2d arm = at_[j] + direction_[j] * moving - fixed;
    const double distance = norm(arm);
    if (!(distance > 0)) return false;
    r[j] = distance - x[4];
    if (jacobian.empty()) continue;
    const Vec2d along = (1 / distance) * arm;
    const Vec2d in_body = conj(direction_[j]) * along;
    const std::array<double, 5> slopes{in_body.x, in_body.y, -along.x, -along.y, -1};
    for (std::size_t i = 0; i < slopes.size(); ++i) jacobian[5 * j + i] = slopes[i];
  }
  return true;
}

}  // namespace cognate::synthesis
