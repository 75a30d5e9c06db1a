#include "synthesis/exact/nine_point/path_system.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/exact/nine_point/start_set.hpp"

namespace cognate::synthesis {

PathClass class_of(std::span<const PathPose> positions) {
  const auto has_angle = [](const PathPose& position) { return position.angle.has_value(); };
  const auto oriented = std::count_if(positions.begin(), positions.end(), has_angle);
  const int poses = std::max(1, static_cast<int>(oriented));
  return {poses, static_cast<int>(positions.size()) - poses};
}

Vec2d to_plane(const PathSystem& system, std::complex<double> z) {
  return system.origin + system.scale * Vec2d{z.real(), z.imag()};
}

namespace nine_point {
namespace {

using Complex = std::complex<double>;

/// Coordinates of this size can still be squared and summed.
constexpr double kLargest = 1e150;
/// Positions nearer than this to each other, by the size of all, are the same but for rounding.
constexpr double kCoincident = 1e-13;

bool pose_is_finite(const PathPose& position) {
  return std::abs(position.at.x) <= kLargest && std::abs(position.at.y) <= kLargest &&
         std::isfinite(position.angle.value_or(0));
}

/// Two positions that ask for the same, if there are any: index −1 is the reference.
std::optional<std::array<int, 2>> find_coincident(const PathSystem& system) {
  const int poses = system.kind.poses - 1, count = static_cast<int>(system.d.size());
  const auto d = [&](int j) { return j < 0 ? Complex(0) : system.d[j]; };
  const auto t = [&](int j) { return j < 0 ? Complex(1) : system.t[j]; };
  for (int j = 0; j < count; ++j) {
    for (int i = -1; i < j; ++i) {
      const bool turned = j < poses && std::abs(t(i) - t(j)) > kCoincident;
      if (!turned && std::abs(d(i) - d(j)) <= kCoincident) return std::array{i, j};
    }
  }
  return std::nullopt;
}

void fill(PathSystem& system, std::span<const PathPose> positions) {
  const PathPose& reference = positions[system.reference];
  const bool has_poses = system.kind.poses > 1;
  const auto add = [&](bool poses) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (static_cast<int>(i) == system.reference) continue;
      if ((has_poses && positions[i].angle.has_value()) != poses) continue;
      const Vec2d d = positions[i].at - reference.at;
      system.d.emplace_back(d.x, d.y);
      system.order.push_back(static_cast<int>(i));
      if (poses) system.t.push_back(std::polar(1.0, *positions[i].angle - *reference.angle));
    }
  };
  add(true);
  add(false);
}

}  // namespace

SystemOrStatus make_system(std::span<const PathPose> positions, Count count) {
  SystemOrStatus made;
  PathSystem& system = made.system;
  system.kind = class_of(positions);
  const bool fits = count == Count::any ? positions.size() > 1 : known_count(system.kind) != 0;
  if (positions.empty() || !fits) {
    made.status = ExactPathStatus::wrong_count;
    return made;
  }
  if (!std::all_of(positions.begin(), positions.end(), pose_is_finite)) {
    made.status = ExactPathStatus::not_finite;
    return made;
  }
  if (system.kind.poses > 1) {
    const auto pose = std::find_if(positions.begin(), positions.end(),
                                   [](const PathPose& at) { return at.angle.has_value(); });
    system.reference = static_cast<int>(pose - positions.begin());
  }
  system.origin = positions[system.reference].at;
  fill(system, positions);
  double largest = 0, sum = 0;
  for (const Complex& d : system.d) largest = std::max(largest, std::abs(d));
  for (const Complex& d : system.d) sum += std::norm(d / largest);
  if (largest > 0) {
    system.scale = largest * std::sqrt(sum / static_cast<double>(system.d.size()));
    for (Complex& d : system.d) d /= system.scale;
  }
  if (const auto same = find_coincident(system)) {
    made.status = ExactPathStatus::coincident;
    const auto caller = [&](int j) { return j < 0 ? system.reference : system.order[j]; };
    made.coincident = {caller((*same)[0]), caller((*same)[1])};
  }
  return made;
}

}  // namespace nine_point
}  // namespace cognate::synthesis
