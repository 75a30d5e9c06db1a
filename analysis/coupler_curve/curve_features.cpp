#include "analysis/coupler_curve/curve_features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "analysis/coupler_curve/circuits.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate {
namespace {

/// A place on one of the circuits' arcs.
struct ArcPlace {
  const CircuitArc* arc = nullptr;
  double place = 0;
};

/// The coupler point there, in the frame's axes and the curve's unit, with its derivatives.
struct TracedPoint {
  LinkPose pose;
  std::array<Vec2d, 4> motion;
  double speed = 0;  ///< the sum of the speeds that B and P about B have, which P's cannot exceed
};

/// A four-bar's coupler curve over the lengths divided by a power of two. The linkage has a coupler
/// point.
class TracedCurve {
 public:
  /// The curve on all circuits, or on one alone.
  explicit TracedCurve(const FourBar& linkage, std::optional<int> circuit = std::nullopt);

  const Circuits& circuits() const { return circuits_; }
  double unit() const { return unit_; }
  double frame() const { return links_.frame; }

  /// (P − B)/(C − B).
  Vec2d ratio() const { return (1 / links_.coupler) * point_; }

  TracedPoint at(const ArcPlace& where) const;

  /// Zeros of `f` over all circuits where it changes its sign; `slope` is its derivative by the
  /// curve's parameter, either way: it shows where to look for two zeros in one cell. Both take a
  /// TracedPoint. Places at which the motion itself stands still (change points) are left out.
  template <class Function, class Slope>
  std::vector<ArcPlace> zeros(Function f, Slope slope) const {
    std::vector<ArcPlace> found;
    const TracedPoint* sample = samples_.data();
    for (const CircuitArc& arc : circuits_.arcs()) {
      const auto value = [&](double place) { return f(at({&arc, place})); };
      const auto change = [&](double place) { return slope(at({&arc, place})); };
      const auto add = [&](double place) {
        if (moves({&arc, place})) found.push_back({&arc, place});
      };
      const auto refine = [&](double a, double at_a, double b, double at_b) {
        add(better_end(value, bracket_zero(value, a, at_a, b, at_b)));
      };
      for (int k = 0; k < kCells; ++k, ++sample) {
        const double a = place_of(arc, k), at_a = f(sample[0]);
        const double b = place_of(arc, k + 1), at_b = f(sample[1]);
        if (at_a == 0) {
          add(a);
        } else if (at_a * at_b < 0) {
          refine(a, at_a, b, at_b);
        } else if (const double change_a = slope(sample[0]), change_b = slope(sample[1]);
                   at_b != 0 && change_a * change_b < 0) {
          const double peak = bracket_zero(change, a, change_a, b, change_b).first;
          const double at_peak = value(peak);
          if (at_peak * at_a < 0) {
            refine(a, at_a, peak, at_peak);
            refine(peak, at_peak, b, at_b);
          }
        }
      }
      ++sample;
    }
    return found;
  }

 private:
  static constexpr int kCells = 480;

  static double place_of(const CircuitArc& arc, int cell) {
    return arc.from + (arc.to - arc.from) * cell / kCells;
  }

  bool moves(const ArcPlace& where) const;

  double unit_ = 1;
  Lengths<double> links_;
  Vec2d point_;
  double arm_ = 0;  ///< of the point about B
  Circuits circuits_;
  std::vector<TracedPoint> samples_;  ///< the ends of the cells of each arc
};

double unit_of(const Lengths<double>& links) {
  return std::ldexp(1.0,
                    std::ilogb(std::max({links.crank, links.coupler, links.rocker, links.frame})));
}

Lengths<double> divided(const Lengths<double>& links, double unit) {
  return {links.crank / unit, links.coupler / unit, links.rocker / unit, links.frame / unit};
}

TracedCurve::TracedCurve(const FourBar& linkage, std::optional<int> circuit)
    : unit_(unit_of(lengths(linkage))),
      links_(divided(lengths(linkage), unit_)),
      point_((1 / unit_) * *linkage.coupler_point),
      arm_(norm(point_)),
      circuits_(links_) {
  if (circuit) circuits_.keep(*circuit);
  samples_.reserve(circuits_.arcs().size() * (kCells + 1));
  for (const CircuitArc& arc : circuits_.arcs()) {
    for (int k = 0; k <= kCells; ++k) samples_.push_back(at({&arc, place_of(arc, k)}));
  }
}

TracedPoint TracedCurve::at(const ArcPlace& where) const {
  const LinkPose pose = circuits_.at(*where.arc, where.place);
  const BodyMotion<double, 3> coupler = coupler_motion(links_, pose);
  return {pose, point_motion(coupler, point_),
          std::sqrt(squared_norm(coupler.origin[1])) + std::abs(coupler.turn[0]) * arm_};
}

bool TracedCurve::moves(const ArcPlace& where) const {
  constexpr double kStill = 1e-7;
  const auto [e1, e2, e3] = circuits_.at(*where.arc, where.place);
  return std::max({std::abs(cross(e2, e3)), std::abs(cross(e3, e1)), std::abs(cross(e1, e2))}) >
         kStill;
}

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
