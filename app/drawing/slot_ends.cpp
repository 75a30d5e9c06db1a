#include "app/drawing/slot_ends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/numbers/golden_section.hpp"

namespace cognate::app {
namespace {

constexpr double kNowhere = -std::numeric_limits<double>::infinity();
constexpr int kGoldenSteps = 40;   // beyond them a maximum is flat to rounding
constexpr double kRoundUp = 1e-9;  // of a rail, for what golden section leaves

/// One block on its rail.
class Travel {
 public:
  Travel(const LinkShapes& shown, FollowedMotion<0>& motion, std::size_t bearer, const Rail& rail)
      : drive_(shown.poses.drive),
        motion_(motion),
        bearer_(bearer),
        traveller_(static_cast<std::size_t>(rail.traveller)),
        origin_(rail.from) {
    const Vec2d way = rail.to - rail.from;
    length_ = norm(way);
    if (length_ > 0) direction_ = (1 / length_) * way;
  }

  Rail stretched(const Rail& rail) {
    if (length_ == 0) return rail;
    const double beyond = std::max(0.0, farthest(1) - length_) + kRoundUp * length_;
    const double before = std::max(0.0, farthest(-1)) + kRoundUp * length_;
    return {rail.from - before * direction_, rail.to + beyond * direction_, rail.traveller};
  }

 private:
  /// How far the block comes along `side` times the direction of the rail.
  double farthest(double side) {
    const auto reach = [&](double drive) { return side * travelled(drive, side); };
    std::vector<double> at;
    for (const double drive : drive_) at.push_back(reach(drive));
    double greatest = *std::ranges::max_element(at);
    for (std::size_t k = 0; k < at.size(); ++k) {
      const std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, at.size() - 1);
      if (at[k] == kNowhere || at[k] < at[before] || at[k] < at[after]) continue;
      const auto shortfall = [&](double drive) { return -reach(drive); };
      const auto peak = golden_section(shortfall, drive_[before], drive_[after], kGoldenSteps);
      greatest = std::max(greatest, -peak.least());
    }
    return greatest;
  }

  /// The block's place on the rail; so that it counts nowhere, −∞ times `side` where there is none.
  double travelled(double drive, double side) {
    if (!motion_.move_to(drive)) return side * kNowhere;
    const auto& bearer = motion_.bodies()[bearer_];
    const Vec2d way = motion_.bodies()[traveller_].origin[0] - bearer.origin[0];
    const double s = dot(conj(bearer.direction) * way - origin_, direction_);
    return std::isfinite(s) ? s : side * kNowhere;
  }

  const std::vector<double>& drive_;
  FollowedMotion<0>& motion_;
  std::size_t bearer_, traveller_;
  Vec2d origin_{}, direction_{1, 0};
  double length_ = 0;
};

}  // namespace

void reach_slot_ends(LinkShapes& shown, FollowedMotion<0>& motion) {
  for (std::size_t i = 0; i < shown.links.size(); ++i) {
    BodyShape& shape = shown.links[i].shape;
    for (Rail& rail : shape.rails) {
      const Rail longer = Travel(shown, motion, i, rail).stretched(rail);
      std::ranges::replace(shape.outline, rail.from, longer.from);
      std::ranges::replace(shape.outline, rail.to, longer.to);
      rail = longer;
    }
  }
}

}  // namespace cognate::app
