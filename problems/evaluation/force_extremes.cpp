#include "problems/evaluation/force_extremes.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numeric>

#include "analysis/cam/extremes.hpp"
#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/inverse_dynamics.hpp"
#include "problems/evaluation/smooth_pieces.hpp"

namespace cognate::problems {
namespace {

/// Distances from the end of a piece, in parts of the drive's scale, at which growth is judged, the
/// nearer first; and how near to the end the extremes are looked for.
struct EndDistances {
  double near, far;
  double bounded, unbounded;
};
constexpr EndDistances kDead{1e-10, 1e-8, 1e-10, 1e-4}, kAtChange{1e-3, 1e-2, 5e-3, 5e-3};

/// Growth like 1/√distance keeps |f| √distance; what is bounded makes a tenth of it or less.
constexpr double kGrows = 0.5;
/// Of the size of what a force is made of: at the nearer distance less than this is rounding.
constexpr double kRounding = 1e-3;

/// What forces are made of: the size of their terms.
struct ForceSizes {
  double drive = 0;     ///< of the virtual work, by the drive's coordinate
  double reaction = 0;  ///< of loads, weights and inertia
};

/// The forces at any place of a motion under given loads.
class ForceMotion {
 public:
  ForceMotion(const AnalysisProblem& problem, const AssemblyRanges& assembly_ranges)
      : problem_(problem),
        joints_(joints(problem.mechanism.mechanism)),
        motion_(problem.mechanism.mechanism, assembly_ranges),
        dynamics_(problem.mechanism.mechanism, problem.inertias, problem.gravity),
        forces_(dynamics_.forces()) {}

  std::size_t joint_count() const { return joints_.joints.size(); }
  bool slides(std::size_t joint) const {
    return joints_.joints[joint].type == JointType::prismatic;
  }

  double drive(double place, const std::vector<Load>& loads) {
    if (!motion_.move_to(place)) return std::nan("");
    return dynamics_.drive<2>(motion_.bodies(), problem_.drive.rate, loads);
  }

  /// The normal force of a slide, with its sign; of a pin |F|², which is smooth where F vanishes.
  double reaction(double place, const std::vector<Load>& loads, std::size_t joint) {
    if (!motion_.move_to(place)) return std::nan("");
    if (!dynamics_.solve<2>(motion_.bodies(), problem_.drive.rate, loads, forces_)) {
      return std::nan("");
    }
    const Vec2d& force = forces_.reactions[joint].force;
    if (!slides(joint)) return squared_norm(force);
    const Joint& slide = joints_.joints[joint];
    const auto& guide = motion_.bodies()[static_cast<std::size_t>(slide.at.body)];
    return cross(guide.direction * slide.direction, force);
  }

  ForceSizes sizes(double place, const std::vector<Load>& loads) {
    ForceSizes sizes;
    if (!motion_.move_to(place)) return sizes;
    const auto bodies = motion_.bodies();
    for (const Load& load : loads) {
      const auto& body = bodies[static_cast<std::size_t>(load.at.body)];
      const auto at = point_motion<double, 2>(body, load.at.at);
      add(norm(load.force), norm(at[1]), sizes);
      sizes.drive += std::abs(load.torque * body.turn[0]);
      sizes.reaction += std::abs(load.torque) / reach();
    }
    const auto [speed, gain] = problem_.drive.rate;
    for (std::size_t i = 1; i < problem_.inertias.size(); ++i) {
      const auto& [mass, centre, moment] = problem_.inertias[i];
      const auto at = point_motion<double, 2>(bodies[i], centre);
      const double pull = norm((speed * speed) * at[2] + gain * at[1]) + norm(problem_.gravity);
      add(mass * pull, norm(at[1]), sizes);
      const double turn = speed * speed * bodies[i].turn[1] + gain * bodies[i].turn[0];
      sizes.drive += std::abs(moment * turn * bodies[i].turn[0]);
      sizes.reaction += std::abs(moment * turn) / reach();
    }
    return sizes;
  }

 private:
  static void add(double force, double rate, ForceSizes& sizes) {
    sizes.drive += force * rate;
    sizes.reaction += force;
  }

  /// The greatest distance of a body from the first that moves.
  double reach() const {
    double greatest = 0;
    const auto bodies = motion_.bodies();
    for (const auto& body : bodies.subspan(1)) {
      greatest = std::max(greatest, norm(body.origin[0] - bodies[1].origin[0]));
    }
    return greatest > 0 ? greatest : 1;
  }

  const AnalysisProblem& problem_;
  JointList joints_;
  FollowedMotion<2> motion_;
  InverseDynamics dynamics_;
  Forces forces_;
};

/// A piece as a function of t in [0, 1], over which the motion is smooth: at dead ends t goes with
/// the root of the distance.
class PieceMap {
 public:
  explicit PieceMap(const SmoothPiece& piece) : piece_(piece) {
    const bool from = piece.at_from == PieceEnd::dead, to = piece.at_to == PieceEnd::dead;
    power_from_ = from ? 2 : 1;
    power_to_ = to ? 2 : 1;
  }

  double drive(double t) const {
    const double length = piece_.to - piece_.from;
    if (power_from_ == power_to_) {
      if (power_from_ == 1) return piece_.from + length * t;
      // 3t² − 2t³ is 0 and 1 with its slope at both ends.
      return t < 0.5 ? piece_.from + length * t * t * (3 - 2 * t)
                     : piece_.to - length * (1 - t) * (1 - t) * (1 + 2 * t);
    }
    return power_from_ == 2 ? piece_.from + length * t * t : piece_.to - length * (1 - t) * (1 - t);
  }

  /// The derivative of `drive`.
  double rate(double t) const {
    const double length = piece_.to - piece_.from;
    if (power_from_ == power_to_) return power_from_ == 1 ? length : 6 * length * t * (1 - t);
    return 2 * length * (power_from_ == 2 ? t : 1 - t);
  }

  /// How far from an end in t the distance along the drive is `distance` (which is small).
  double share(bool at_from, double distance) const {
    const double part = distance / (piece_.to - piece_.from);
    if ((at_from ? power_from_ : power_to_) == 1) return part;
    return std::sqrt(power_from_ == power_to_ ? part / 3 : part);
  }

 private:
  const SmoothPiece& piece_;
  int power_from_ = 1, power_to_ = 1;
};

/// Collects the extremes of one quantity over the pieces.
class Collector {
 public:
  enum class Extremes { of_both_signs, of_magnitude };

  Collector(const AssemblyRanges& assembly_ranges, const std::vector<SmoothPiece>& pieces,
            Extremes of)
      : assembly_ranges_(assembly_ranges), pieces_(pieces), of_(of) {}

  /// Of `f(place, piece)`; `size_of(piece)` is that of its terms. With `squared` f is the square of
  /// what is judged at the ends.
  template <class Function, class Size>
  void collect(const Function& f, const Size& size_of, bool squared) {
    double size = 0;
    for (const SmoothPiece& piece : pieces_) size = std::max(size, size_of(piece));
    std::vector<Clearances> clearances;
    for (const SmoothPiece& piece : pieces_) {
      clearances.push_back(
          {clearance(f, piece, true, size, squared), clearance(f, piece, false, size, squared)});
    }
    if (is_settled()) return;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      add(f, pieces_[i], clearances[i], squared ? size * size : size);
    }
  }

  ForceBound least, greatest;

 private:
  /// How far from the ends of a piece the extremes are looked for.
  struct Clearances {
    double from, to;
  };

  /// Whether there are no extremes to look for.
  bool is_settled() const {
    if (of_ == Extremes::of_magnitude) return least.is_unbounded() || greatest.is_unbounded();
    return least.is_unbounded() && greatest.is_unbounded();
  }

  template <class Function>
  void add(const Function& f, const SmoothPiece& piece, const Clearances& clear, double size) {
    const PieceMap map(piece);
    const double from = map.share(true, clear.from), to = 1 - map.share(false, clear.to);
    if (!(from < to)) return;
    const auto at = [&](double t) { return f(map.drive(t), piece); };
    const auto found = cam::extremes(at, from, to, size);
    offer(least, -1, {found.least.value, map.drive(found.least.at)});
    offer(greatest, 1, {found.greatest.value, map.drive(found.greatest.at)});
  }

  /// How far from an end of a piece the extremes are looked for.
  template <class Function>
  double clearance(const Function& f, const SmoothPiece& piece, bool at_from, double size,
                   bool squared) {
    const PieceEnd end = at_from ? piece.at_from : piece.at_to;
    if (end == PieceEnd::smooth) return 0;
    const double place = at_from ? piece.from : piece.to;
    const EndDistances& distances = end == PieceEnd::dead ? kDead : kAtChange;
    const double room = std::min(assembly_ranges_.scale, 10 * (piece.to - piece.from));
    const auto judged = [&](double distance) {
      const double step = distance * room;
      const double value = f(place + (at_from ? step : -step), piece);
      return squared ? std::copysign(std::sqrt(std::abs(value)), value) : value;
    };
    const double near = judged(distances.near), far = judged(distances.far);
    const bool grows =
        std::abs(near) > kRounding * size && std::abs(near) * std::sqrt(distances.near) >
                                                 kGrows * std::abs(far) * std::sqrt(distances.far);
    if (grows) (near > 0 ? greatest : least).unbounded_at.push_back(place);
    if (!grows && end == PieceEnd::change) {
      const double value = f(place, piece);
      offer(least, -1, {value, place});
      offer(greatest, 1, {value, place});
    }
    return (grows ? distances.unbounded : distances.bounded) * room;
  }

  static void offer(ForceBound& bound, double sense, const ForceAt& at) {
    if (!std::isfinite(at.value)) return;
    if (!bound.extreme || sense * (at.value - bound.extreme->value) > 0) bound.extreme = at;
  }

  const AssemblyRanges& assembly_ranges_;
  const std::vector<SmoothPiece>& pieces_;
  Extremes of_;
};

/// The root of the mean of f² over the drive's coordinate in all pieces, by adaptive quadrature;
/// empty where there is no such number.
template <class Function>
std::optional<double> root_mean_square(const std::vector<SmoothPiece>& pieces, const Function& f) {
  constexpr unsigned kMostHalvings = 8;
  constexpr double kTolerance = 1e-10;
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 15>;
  double sum = 0, length = 0;
  for (const SmoothPiece& piece : pieces) {
    const PieceMap map(piece);
    const auto square = [&](double t) {
      const double value = f(map.drive(t), piece);
      return value * value * map.rate(t);
    };
    sum += Quadrature::integrate(square, 0., 1., kMostHalvings, kTolerance);
    length += piece.to - piece.from;
  }
  const double mean = sum / length;
  return std::isfinite(mean) ? std::optional(std::sqrt(mean)) : std::nullopt;
}

/// Places in order, each once.
void tidy(ForceBound& bound, double scale) {
  constexpr double kSamePlace = 1e-9;
  auto& places = bound.unbounded_at;
  std::ranges::sort(places);
  const auto repeated = std::ranges::unique(
      places, [&](double a, double b) { return std::abs(a - b) <= kSamePlace * scale; });
  places.erase(repeated.begin(), repeated.end());
  if (bound.is_unbounded()) bound.extreme.reset();
}

/// The greatest magnitude of what has these bounds.
ForceBound magnitude(ForceBound least, ForceBound greatest, bool squared) {
  if (squared) {
    if (greatest.extreme) greatest.extreme->value = std::sqrt(greatest.extreme->value);
    return greatest;
  }
  if (least.extreme && greatest.extreme) {
    if (-least.extreme->value > greatest.extreme->value) greatest.extreme = least.extreme;
    greatest.extreme->value = std::abs(greatest.extreme->value);
  }
  greatest.unbounded_at.insert(greatest.unbounded_at.end(), least.unbounded_at.begin(),
                               least.unbounded_at.end());
  return greatest;
}

}  // namespace

std::optional<ForceExtremes> force_extremes(const AnalysisProblem& problem,
                                            const AssemblyRanges& assembly_ranges,
                                            std::span<const Stroke> strokes,
                                            const Deadline& deadline) {
  const std::vector<SmoothPiece> pieces = smooth_pieces(problem, assembly_ranges, strokes);
  ForceMotion motion(problem, assembly_ranges);
  const auto sizes = [&](const SmoothPiece& piece) {
    return motion.sizes(std::midpoint(piece.from, piece.to), piece.loads);
  };
  ForceExtremes all;
  if (problem.output.torque) {
    Collector drive(assembly_ranges, pieces, Collector::Extremes::of_both_signs);
    const auto torque = [&](double place, const SmoothPiece& piece) {
      return motion.drive(place, piece.loads);
    };
    drive.collect(
        torque, [&](const SmoothPiece& piece) { return sizes(piece).drive; }, false);
    all.least_drive = std::move(drive.least);
    all.greatest_drive = std::move(drive.greatest);
    tidy(all.least_drive, assembly_ranges.scale);
    tidy(all.greatest_drive, assembly_ranges.scale);
    if (!all.least_drive.is_unbounded() && !all.greatest_drive.is_unbounded()) {
      all.drive_rms = root_mean_square(pieces, torque);
    }
  }
  for (std::size_t i = 0; problem.output.reactions && i < motion.joint_count(); ++i) {
    if (deadline.reached()) return std::nullopt;
    const bool squared = !motion.slides(i);
    Collector reaction(assembly_ranges, pieces, Collector::Extremes::of_magnitude);
    reaction.collect(
        [&](double place, const SmoothPiece& piece) {
          return motion.reaction(place, piece.loads, i);
        },
        [&](const SmoothPiece& piece) { return sizes(piece).reaction; }, squared);
    all.reactions.push_back(magnitude(reaction.least, reaction.greatest, squared));
    tidy(all.reactions.back(), assembly_ranges.scale);
  }
  if (deadline.reached()) return std::nullopt;
  return all;
}

}  // namespace cognate::problems
