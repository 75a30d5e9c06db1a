#include "problems/chain/three_pin/transmission.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"

namespace cognate::problems {
namespace {

constexpr int kDrives = 720, kPeakSteps = 30;

/// A link that holds a pin: the pin, and the direction of the link.
struct Holding {
  Vec2d pin, along;
};

/// The direction from the crossing of the lines of two links to `point`; of parallel lines that of
/// the lines.
Vec2d from_crossing(const Holding& one, const Holding& other, const Vec2d& point) {
  const double turning = cross(one.along, other.along);
  return turning * (point - one.pin) - cross(other.pin - one.pin, other.along) * one.along;
}

class PinTransmission {
 public:
  PinTransmission(const Mechanism<double>& mechanism, const AssemblyRanges& motion, int dyad)
      : motion_(mechanism, motion),
        group_(std::get<Group>(mechanism.dyads[static_cast<std::size_t>(dyad)])),
        first_(static_cast<std::size_t>(first_body(mechanism, dyad))) {}

  /// |cos μ| of the link of a pin; more than any where the mechanism cannot be assembled.
  double cosine(std::size_t pin, double drive) {
    if (!motion_.move_to(drive)) return 2;
    const Holding own = holding(pin);
    const Vec2d arm = from_crossing(holding((pin + 1) % 3), holding((pin + 2) % 3), own.pin);
    return std::abs(dot(own.along, arm)) / norm(arm);
  }

 private:
  Holding holding(std::size_t pin) const {
    const auto& body = motion_.bodies()[first_ + pin];
    const Vec2d held = group_.joints[3 + pin].first.at;
    return {point_motion(body, held)[0], body.direction};
  }

  FollowedMotion<0> motion_;
  const Group& group_;
  std::size_t first_;
};

double greatest_cosine(PinTransmission& links, std::size_t pin, const AssemblyRanges& motion) {
  const double step = (motion.end - motion.start) / kDrives;
  double greatest = 0, at = motion.start;
  for (int i = 0; i <= kDrives; ++i) {
    const double drive = motion.start + i * step, here = links.cosine(pin, drive);
    if (here > greatest) {
      greatest = here;
      at = drive;
    }
  }
  const auto lowered = [&](double drive) { return -links.cosine(pin, drive); };
  const double from = std::max(motion.start, at - step), to = std::min(motion.end, at + step);
  const double peak = golden_section(lowered, from, to, kPeakSteps).middle();
  return std::min(1.0, std::max(greatest, links.cosine(pin, peak)));
}

}  // namespace

std::array<double, 3> least_pin_transmission(const Mechanism<double>& mechanism,
                                             const AssemblyRanges& motion, int dyad) {
  PinTransmission links(mechanism, motion, dyad);
  std::array<double, 3> least{};
  for (std::size_t pin = 0; pin < least.size(); ++pin) {
    least[pin] = std::acos(greatest_cosine(links, pin, motion));
  }
  return least;
}

bool returns_after_turn(const Mechanism<double>& mechanism, const AssemblyRanges& turn) {
  constexpr double kSame = 1e-6;  // radians by which directions are one
  FollowedMotion<0> motion(mechanism, turn);
  if (!motion.move_to(turn.start)) return false;
  std::vector<Vec2d> began;
  for (const auto& body : motion.bodies()) began.push_back(body.direction);
  if (!motion.move_to(turn.end)) return false;
  for (std::size_t i = 0; i < began.size(); ++i) {
    if (norm(motion.bodies()[i].direction - began[i]) > kSame) return false;
  }
  return true;
}

}  // namespace cognate::problems
