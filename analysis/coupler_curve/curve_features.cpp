#include "analysis/coupler_curve/curve_features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/coupler_curve/traced_curve.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"

namespace cognate {
namespace {

constexpr double kCuspSpeed = 1e-10;  ///< relative: the point stands still
constexpr double kNearCusp = 1e-6;    ///< relative: about the root of the rounding of a cusp
constexpr double kSamePlace = 1e-6;   ///< of the unit: two positions show one point
constexpr double kSamePose = 1e-9;    ///< one position, found from two arcs

/// A point found, with the position of the links that distinguishes it from another.
struct Found {
  CurvePoint point;
  TracedPoint traced;
};

double relative_speed(const TracedPoint& point) {
  return norm(point.motion[1]) / point.speed;
}

bool same_pose(const LinkPose& a, const LinkPose& b) {
  return norm(a.crank - b.crank) + norm(a.coupler - b.coupler) < kSamePose;
}

/// Im[(1 − z) P conj(P − E)], E = z·D from A: zero on the circle through A, D and E, and on the
/// line A–D where they are collinear.
class FociCircle {
 public:
  explicit FociCircle(const TracedCurve& curve)
      : rest_(Vec2d{1, 0} - curve.ratio()), third_pivot_(curve.frame() * curve.ratio()) {}

  double value(const TracedPoint& p) const {
    return (rest_ * p.motion[0] * conj(p.motion[0] - third_pivot_)).y;
  }
  double slope(const TracedPoint& p) const {
    return (rest_ *
            (p.motion[1] * conj(p.motion[0] - third_pivot_) + p.motion[0] * conj(p.motion[1])))
        .y;
  }

 private:
  Vec2d rest_, third_pivot_;
};

/// Finds features and places them in the plane of the pivots.
class Search {
 public:
  Search(const FourBar& linkage, std::optional<int> circuit)
      : linkage_(linkage), curve_(linkage, circuit), frame_angle_(frame_angle(linkage)) {
    const Vec2d frame = linkage.pivot_d - linkage.pivot_a;
    frame_direction_ = (1 / norm(frame)) * frame;
  }

  CurveFeatures run() {
    find_cusps();
    find_inflections();
    find_double_points();
    return std::move(features_);
  }

 private:
  template <class Function, class Slope>
  std::vector<Found> zeros(Function f, Slope slope) const {
    std::vector<Found> found;
    for (const ArcPlace& place : curve_.zeros(f, slope)) {
      const Found next{placed(place), curve_.at(place)};
      const bool is_known = std::ranges::any_of(found, [&](const Found& other) {
        return other.point.circuit == next.point.circuit &&
               same_pose(other.traced.pose, next.traced.pose);
      });
      if (!is_known) found.push_back(next);
    }
    return found;
  }

  CurvePoint placed(const ArcPlace& place) const {
    const TracedPoint point = curve_.at(place);
    const auto& [crank, coupler, rocker] = point.pose;
    const Vec2d at = linkage_.pivot_a + curve_.unit() * (frame_direction_ * point.motion[0]);
    const double angle = std::atan2(crank.y, crank.x) + frame_angle_;
    const Assembly side = cross(coupler, rocker) < 0 ? Assembly::crossed : Assembly::open;
    return {at, {in_one_turn(angle), side}, place.arc->circuit};
  }

  void find_cusps() {
    const auto f = [](const TracedPoint& p) { return dot(p.motion[1], p.motion[2]); };
    const auto slope = [](const TracedPoint& p) {
      return squared_norm(p.motion[2]) + dot(p.motion[1], p.motion[3]);
    };
    for (const Found& found : zeros(f, slope)) {
      if (relative_speed(found.traced) < kCuspSpeed) features_.cusps.push_back(found.point);
    }
  }

  /// Whether what is found is a cusp, seen with rounding.
  bool is_cusp(const Found& found) const {
    return !features_.cusps.empty() && relative_speed(found.traced) < kNearCusp;
  }

  void find_inflections() {
    const auto f = [](const TracedPoint& p) { return cross(p.motion[1], p.motion[2]); };
    const auto slope = [](const TracedPoint& p) { return cross(p.motion[1], p.motion[3]); };
    for (const Found& found : zeros(f, slope)) {
      if (!is_cusp(found)) features_.inflections.push_back(found.point);
    }
  }

  void find_double_points() {
    const FociCircle circle(curve_);
    std::vector<Found> open = zeros([&](const TracedPoint& p) { return circle.value(p); },
                                    [&](const TracedPoint& p) { return circle.slope(p); });
    std::erase_if(open, [&](const Found& found) { return is_cusp(found); });
    while (open.size() > 1) {
      const Found last = open.back();
      open.pop_back();
      const auto distance = [&](const Found& other) {
        return norm(other.traced.motion[0] - last.traced.motion[0]);
      };
      const auto twin = std::ranges::min_element(open, {}, distance);
      if (distance(*twin) > kSamePlace) continue;
      features_.double_points.push_back(
          {0.5 * (twin->point.at + last.point.at), twin->point, last.point});
      open.erase(twin);
    }
  }

  FourBar linkage_;
  TracedCurve curve_;
  double frame_angle_ = 0;
  Vec2d frame_direction_;
  CurveFeatures features_;
};

bool traces_a_circle(const FourBar& linkage) {
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  const Vec2d from_b = *linkage.coupler_point, from_c = from_b - Vec2d{linkage.coupler, 0};
  return std::min(norm(from_b), norm(from_c)) <= kRounding * linkage.coupler;
}

/// As `CurvePoint::circuit` counts.
int number_of(const CircuitChoice& circuit, const Lengths<double>& links) {
  if (crank_rotates(links)) return circuit.assembly == Assembly::open ? 0 : 1;
  return crank_ranges(links).size() > 1 && circuit.half < 0 ? 1 : 0;
}

bool has_features(const FourBar& linkage) {
  return linkage.coupler_point && !traces_a_circle(linkage) && can_assemble(lengths(linkage));
}

}  // namespace

std::optional<CurveFeatures> curve_features(const FourBar& linkage) {
  if (!has_features(linkage)) return std::nullopt;
  return Search(linkage, std::nullopt).run();
}

std::optional<CurveFeatures> curve_features(const FourBar& linkage, const CircuitChoice& circuit) {
  if (!has_features(linkage)) return std::nullopt;
  return Search(linkage, number_of(circuit, lengths(linkage))).run();
}

}  // namespace cognate
