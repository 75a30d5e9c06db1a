#include "problems/cam/search.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/cam/extremes.hpp"
#include "problems/cam/limits.hpp"
#include "problems/cam/model.hpp"

namespace cognate::problems {
namespace {

using cam::Cam;
using cam::ExtremeAt;
using cam::FollowerMotion;

constexpr int kMostRounds = 30;
/// Local extremes that are taken of one limit in one round.
constexpr std::size_t kMostPlaces = 40;
/// What a limit may be broken by before its position is added.
constexpr double kBroken = 0.3 * kCamFeasibility;
/// A relaxation that ends with more is taken to have no solution near its start.
constexpr double kHopeless = 1e-6;

bool covers(cam::MotionPart stretch, cam::Stroke stroke) {
  using cam::MotionPart, cam::Stroke;
  return stretch == MotionPart::whole || (stretch == MotionPart::rises && stroke == Stroke::rise) ||
         (stretch == MotionPart::falls && stroke == Stroke::fall);
}

std::optional<cam::CamQuantity> quantity_of(CamObjective objective) {
  switch (objective) {
    case CamObjective::pressure_angle:
      return cam::CamQuantity::pressure_angle;
    case CamObjective::contact_force:
      return cam::CamQuantity::contact_force;
    case CamObjective::torque:
      return cam::CamQuantity::torque;
    case CamObjective::contact_stress:
      return cam::CamQuantity::squared_stress;
    case CamObjective::size:
      break;
  }
  return std::nullopt;
}

/// Positions of a cam as shares of its motion's segments.
class SegmentShares {
 public:
  SegmentShares(const CamVariables& variables, std::span<const double> x) {
    double begin = 0;
    for (const auto& segment : variables.motion(x)) {
      spans_.push_back({begin, segment.over});
      begin += segment.over;
    }
  }
  SegmentPlace place(const Cam& cam, const cam::TurnPlace& place) const {
    const int segment = cam.programme.pieces()[static_cast<std::size_t>(place.piece)].segment;
    const Span& span = spans_[static_cast<std::size_t>(segment)];
    return {segment, std::clamp((place.angle - span.begin) / span.over, 0.0, 1.0)};
  }

 private:
  struct Span {
    double begin, over;
  };
  std::vector<Span> spans_;
};

class Exchange {
 public:
  Exchange(const CamVariables& variables, synthesis::Solver solver, const Deadline& deadline,
           Work& work)
      : variables_(variables),
        quantity_(quantity_of(variables.problem().objective)),
        solver_(solver),
        deadline_(deadline),
        work_(work) {
    for (const CamLimit& limit : cam_limits(variables.problem())) {
      places_.limits.push_back({limit, {}});
    }
  }

  std::optional<CamCandidate> run(std::vector<double> x) {
    auto cam = cam_at(variables_, x);
    if (!cam) return std::nullopt;
    begin_with_even_places(*cam, x);
    add_broken(*cam, x, -kInfinity);
    CamCandidate best = candidate(*cam, x);
    unit_ = best.objective > 0 && std::isfinite(best.objective) ? best.objective : 1;
    for (int round = 0; round < kMostRounds && !deadline_.reached(); ++round) {
      x = solve_relaxed(x);
      cam = cam_at(variables_, x);
      if (!cam) break;
      const CamCandidate here = candidate(*cam, x);
      if (is_better(here, best)) best = here;
      // What even the relaxation cannot keep more positions cannot mend.
      if (!add_broken(*cam, x, kBroken) || relaxed_violation_ > kHopeless) break;
    }
    return best;
  }

 private:
  /// Some positions of every stroke, so that the first solution is not far off.
  void begin_with_even_places(const Cam& cam, std::span<const double> x) {
    constexpr std::size_t kMostParts = 60;
    const SegmentShares shares(variables_, x);
    const auto& parts = cam.programme.stroke_parts();
    const std::size_t step = parts.size() / kMostParts + 1;
    for (std::size_t i = 0; i < parts.size(); i += step) {
      const auto& part = parts[i];
      const auto& piece = cam.programme.pieces()[static_cast<std::size_t>(part.piece)];
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double t = std::lerp(part.from, part.to, share);
        const auto place = shares.place(cam, {piece.begin + t * piece.span, part.piece, t});
        for (auto& limit : places_.limits) {
          if (covers(limit.limit.stretch, part.stroke)) limit.places.push_back(place);
        }
        if (quantity_) places_.objective.push_back(place);
      }
    }
  }

  /// Adds the positions where `cam` breaks its limits by more than `broken`, and those that its
  /// objective's greatest value stands in; returns whether there were any.
  bool add_broken(const Cam& cam, std::span<const double> x, double broken) {
    const SegmentShares shares(variables_, x);
    bool added = false;
    for (auto& [limit, places] : places_.limits) {
      const auto missing = [&, &limit = limit](const FollowerMotion<double>& m) {
        return -margin(limit, cam.system, m, variables_.unit());
      };
      added |=
          add(cam, shares, local_maxima(cam.programme, limit.stretch, missing, broken), places);
    }
    added |= add_objective(cam, shares, broken);
    added |= add_face(cam, shares, broken);
    return added;
  }

  bool add_objective(const Cam& cam, const SegmentShares& shares, double broken) {
    if (!quantity_ || is_endless(cam)) return false;
    const double above = reached_ * (1 + std::max(broken, 0.0));
    bool added = false;
    for (const double sign : {1.0, -1.0}) {
      const auto size = [&](const FollowerMotion<double>& m) {
        return sign * value_of(*quantity_, cam.system, m);
      };
      const double floor = broken > 0 ? above : -kInfinity;
      added |= add(cam, shares, local_maxima(cam.programme, cam::MotionPart::whole, size, floor),
                   places_.objective);
    }
    return added;
  }

  bool add_face(const Cam& cam, const SegmentShares& shares, double broken) {
    const auto& most = variables_.problem().constraints.face_width_max;
    if (!most) return false;
    const auto reach =
        turn_extremes(cam.programme, cam::MotionPart::whole, cam.system, cam::CamQuantity::reach);
    const double width = reach->greatest.value - reach->least.value;
    if (!(width - *most > broken * *most)) return false;
    places_.face.push_back(
        {shares.place(cam, reach->greatest.place), shares.place(cam, reach->least.place)});
    return true;
  }

  static bool add(const Cam& cam, const SegmentShares& shares, std::vector<ExtremeAt> maxima,
                  std::vector<SegmentPlace>& places) {
    if (maxima.size() > kMostPlaces) {
      std::ranges::partial_sort(maxima, maxima.begin() + kMostPlaces, std::ranges::greater{},
                                &ExtremeAt::value);
      maxima.resize(kMostPlaces);
    }
    bool added = false;
    for (const ExtremeAt& extreme : maxima) {
      const auto place = shares.place(cam, extreme.place);
      if (std::ranges::find(places, place) != places.end()) continue;
      places.push_back(place);
      added = true;
    }
    return added;
  }

  std::vector<double> solve_relaxed(std::span<const double> x) {
    const CamModel model(variables_, places_, unit_);
    synthesis::Options options;
    options.tolerance = variables_.problem().solve.tolerance.value_or(1e-14);
    options.feasibility = 0.1 * kCamFeasibility;
    options.time_limit = deadline_.remaining();
    options.interrupted = deadline_.flag();
    const auto solution = synthesis::solve(solver_, model, x, options);
    work_.solver_iterations += static_cast<std::uint64_t>(solution.iterations);
    work_.positions += solution.evaluations * static_cast<std::uint64_t>(model.constraint_count());
    work_.gradients += solution.gradients;
    reached_ = solution.objective * unit_;
    relaxed_violation_ = solution.violation;
    return solution.x;
  }

  CamCandidate candidate(const Cam& cam, std::span<const double> x) const {
    CamCandidate made{{x.begin(), x.end()}, objective(cam), 0, solver_};
    for (const auto& [limit, places] : places_.limits) {
      const auto missing = [&, &limit = limit](const FollowerMotion<double>& m) {
        return -margin(limit, cam.system, m, variables_.unit());
      };
      const auto worst = turn_extremes(cam.programme, limit.stretch, missing);
      if (worst && !(worst->greatest.value <= made.violation)) {
        const double missing_there = worst->greatest.value;
        made.violation = std::isfinite(missing_there) ? missing_there : kInfinity;
      }
    }
    made.violation = std::max(made.violation, turn_missed(x));
    const Range& base = variables_.problem().length(CamDimension::base_radius).bounds;
    const auto& d = cam.system.follower.dimensions;
    const double radius = d.base_radius;
    made.violation = std::max({made.violation, (base.min - radius) / variables_.unit(),
                               (radius - base.max) / variables_.unit(),
                               (d.roller_radius - radius) / variables_.unit()});
    const auto& width = variables_.problem().constraints.face_width_max;
    if (width)
      made.violation = std::max(made.violation, CamExtremes(cam).face_width() / *width - 1);
    return made;
  }

  /// Whether the objective is a stress, and the profile comes to a point.
  bool is_endless(const Cam& cam) const {
    return quantity_ == cam::CamQuantity::squared_stress &&
           !std::isfinite(CamExtremes(cam).stress().value);
  }

  /// By how many turns the angles of the motion miss one.
  double turn_missed(std::span<const double> x) const {
    double turn = 0;
    for (const auto& segment : variables_.motion(x)) turn += segment.over;
    return std::abs(turn / (kTurn)-1);
  }

  double objective(const Cam& cam) const {
    if (!quantity_) return cam.system.follower.dimensions.base_radius;
    if (is_endless(cam)) return kInfinity;
    const auto all = turn_extremes(cam.programme, cam::MotionPart::whole, cam.system, *quantity_);
    return std::max(std::abs(all->least.value), std::abs(all->greatest.value));
  }

  const CamVariables& variables_;
  std::optional<cam::CamQuantity> quantity_;
  synthesis::Solver solver_;
  const Deadline& deadline_;
  Work& work_;
  CamPlaces places_;
  double unit_ = 1;
  double relaxed_violation_ = 0;  ///< of the last relaxation's constraints
  double reached_ = 0;            ///< the objective at the positions of the last relaxation
};

}  // namespace

std::optional<CamCandidate> search_cam(const CamVariables& variables, std::vector<double> start,
                                       synthesis::Solver solver, const Deadline& deadline,
                                       Work& work) {
  return Exchange(variables, solver, deadline, work).run(std::move(start));
}

}  // namespace cognate::problems
