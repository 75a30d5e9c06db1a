#include "analysis/mechanism/group_track.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/group_closure.hpp"
#include "analysis/mechanism/group_equations.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate {
namespace {

using Node = GroupTrack::Node;
using Elimination = Eigen::PartialPivLU<GroupMatrix>;

/// Parts of the drive's scale: the longest step, and the step at which an end is looked for.
constexpr double kLongest = kTurn / 360;
constexpr double kShortest = 1e-7;
/// How far, in parts of the group, Newton's method may have to go from a prediction, and by which
/// factor its second step must be shorter than its first: it then converges to the position next to
/// the prediction (Deuflhard 2004, section 2.1).
constexpr double kFarthest = 0.05;
constexpr double kContraction = 0.1;
constexpr double kSettled = 1e-9;
/// And from what is drawn.
constexpr double kDrawnWell = 1e-2;

/// The bodies of a mechanism as far as a group, which is moved by itself.
class GroupMover {
 public:
  GroupMover(const TrackedRun& along, int dyad)
      : run_(along.run),
        before_{along.mechanism.drive,
                {along.mechanism.dyads.begin(), along.mechanism.dyads.begin() + dyad}},
        group_(std::get<Group>(along.mechanism.dyads[static_cast<std::size_t>(dyad)])),
        first_(static_cast<std::size_t>(body_count(before_))),
        equations_(group_, first_),
        sides_(along.run.sides.size()),
        bodies_(first_ + group_.drawn.size()),
        closures_(before_.dyads.size()) {}

  std::size_t first() const { return first_; }
  const Group& group() const { return group_; }
  const GroupEquations& equations() const { return equations_; }
  std::span<BodyMotion<double, 1>> bodies() { return bodies_; }
  std::span<BodyMotion<double, 1>> of_group() { return bodies().subspan(first_); }

  /// Moves what the group depends on.
  void drive_to(double drive) {
    sides_or_none_at(run_, drive, sides_);
    place_groups(run_, drive, bodies());
    evaluate<1>(before_, drive_position(before_, drive),
                std::span(sides_).first(before_.dyads.size()), bodies(), closures_);
  }

  GroupMatrix matrix() const { return equations_.matrix<1>(bodies_); }
  double sine() const { return group_sine(matrix()); }

  /// One step of Newton's method; its length.
  double improve() {
    const GroupVector step = Elimination(matrix()).solve(-equations_.residual<1>(bodies_));
    if (!step.allFinite()) return std::numeric_limits<double>::infinity();
    equations_.move<1>(step, bodies());
    return step.lpNorm<Eigen::Infinity>();
  }

  /// Closes the group to rounding, with its rates.
  bool close() { return close_group_of<1>(group_, first_, 1, bodies()).discriminant >= 0; }

  Node node(double drive) { return {drive, {of_group().begin(), of_group().end()}, false}; }

 private:
  const AssemblyRange& run_;
  Mechanism<double> before_;
  const Group& group_;
  std::size_t first_;
  GroupEquations equations_;
  std::vector<double> sides_;
  std::vector<BodyMotion<double, 1>> bodies_;
  std::vector<DyadClosure<double>> closures_;
};

/// The motion of a group near its dead point, where the drive turns back: with one of the group's
/// own unknowns as the variable, along which all else is smooth.
class NearDeadPoint {
 public:
  /// From `base`, which is near.
  NearDeadPoint(GroupMover& mover, const Node& base) : mover_(mover), base_(base) {
    const double arm = mover.equations().arm();
    for (std::size_t i = 0; i < base.bodies.size(); ++i) {
      const auto& body = base.bodies[i];
      const std::array rates{body.origin[1].x, body.origin[1].y, arm * body.turn[0]};
      for (std::size_t k = 0; k < rates.size(); ++k) {
        if (std::abs(rates[k]) <= std::abs(rate_)) continue;
        rate_ = rates[k];
        variable_ = static_cast<Eigen::Index>(3 * i + k);
      }
    }
  }

  /// Of the variable by the drive, at the base.
  double rate() const { return rate_; }

  /// Moves the variable by `way` from the base; the derivative of the drive by it.
  double move_by(double way) {
    std::ranges::copy(base_.bodies, mover_.of_group().begin());
    drive_ = base_.drive;
    GroupVector step = GroupVector::Zero(mover_.equations().size());
    step[variable_] = way;
    for (int i = 0; i < kMostSteps; ++i) {
      mover_.equations().move<1>(step, mover_.bodies());
      const Elimination elimination(bordered());
      step = elimination.solve(-mover_.equations().residual<1>(mover_.bodies()));
      if (!step.allFinite()) break;
      const double size = step.lpNorm<Eigen::Infinity>();
      drive_ += step[variable_];
      step[variable_] = 0;
      if (size <= 4 * kEpsilon * mover_.equations().arm()) break;
    }
    const GroupVector column = mover_.matrix().col(variable_);
    const GroupVector rates = Elimination(bordered()).solve(-column);
    return rates[variable_];
  }

  /// Where the last move led to.
  Node dead_node() {
    Node node = mover_.node(drive_);
    node.is_dead = true;
    return node;
  }
  GroupTrack::Beyond beyond() {
    GroupTrack::Beyond beyond{drive_, {}};
    for (const auto& body : mover_.of_group()) {
      beyond.bodies.push_back({body.origin[0], body.direction});
    }
    return beyond;
  }

 private:
  static constexpr int kMostSteps = 12;

  /// The matrix of the equations with the drive in the place of the variable.
  GroupMatrix bordered() {
    for (BodyMotion<double, 1>& body : mover_.of_group()) {
      body.origin[1] = {};
      body.turn[0] = 0;
    }
    mover_.drive_to(drive_);
    GroupMatrix matrix = mover_.matrix();
    matrix.col(variable_) = mover_.equations().rest<1, 1>(mover_.bodies());
    return matrix;
  }

  GroupMover& mover_;
  const Node& base_;
  double rate_ = 0;
  Eigen::Index variable_ = 0;
  double drive_ = 0;
};

/// Follows a group from where it is drawn to both ends.
class Tracker {
 public:
  Tracker(const TrackedRun& along, int dyad, const std::function<bool()>& stop)
      : run_(along.run), scale_(along.scale), stop_(stop), mover_(along, dyad) {}

  std::optional<GroupTrack> track(double drawn) {
    const auto start = begin(drawn);
    if (!start) return std::nullopt;
    GroupTrack::BothBeyond beyond;
    std::vector<Node> nodes = march(*start, run_.from);
    beyond[0] = std::move(beyond_);
    std::ranges::reverse(nodes);
    nodes.push_back(*start);
    beyond_.reset();
    for (Node& node : march(*start, run_.to)) nodes.push_back(std::move(node));
    beyond[1] = std::move(beyond_);
    if (nodes.size() < 2) return std::nullopt;
    return GroupTrack(mover_.first(), std::move(nodes), std::move(beyond));
  }

 private:
  std::optional<Node> begin(double drawn) {
    mover_.drive_to(drawn);
    place_drawn(mover_.group(), mover_.of_group());
    if (!(mover_.improve() <= kDrawnWell * mover_.equations().arm()) || !mover_.close()) {
      return std::nullopt;
    }
    sign_ = mover_.sine();
    return mover_.node(drawn);
  }

  /// The position at `drive` next to that which the rates at `from` predict.
  std::optional<Node> next(const Node& from, double drive) {
    mover_.drive_to(drive);
    const double way = drive - from.drive;
    GroupVector prediction(mover_.equations().size());
    for (std::size_t i = 0; i < from.bodies.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(3 * i);
      const auto& body = from.bodies[i];
      mover_.of_group()[i] = body;
      prediction[row] = way * body.origin[1].x;
      prediction[row + 1] = way * body.origin[1].y;
      prediction[row + 2] = way * body.turn[0] * mover_.equations().arm();
    }
    if (!prediction.allFinite()) return std::nullopt;
    mover_.equations().move<1>(prediction, mover_.bodies());
    const double size = mover_.equations().arm();
    const double first = mover_.improve();
    if (!(first <= kFarthest * size)) return std::nullopt;
    const double second = mover_.improve();
    if (!(second <= std::max(kContraction * first, kSettled * size))) return std::nullopt;
    if (!mover_.close() || mover_.sine() * sign_ <= 0) return std::nullopt;
    return mover_.node(drive);
  }

  /// The nodes after `start` on the way to `end`.
  std::vector<Node> march(const Node& start, double end) {
    std::vector<Node> nodes;
    const double sense = end < start.drive ? -1 : 1;
    double step = kLongest * scale_;
    const auto last = [&]() -> const Node& { return nodes.empty() ? start : nodes.back(); };
    while (last().drive != end && !(stop_ && stop_())) {
      const bool is_last = std::abs(end - last().drive) <= step;
      auto node = next(last(), is_last ? end : last().drive + sense * step);
      if (node) {
        nodes.push_back(std::move(*node));
        step = std::min(1.5 * step, kLongest * scale_);
      } else if (step > kShortest * scale_) {
        step /= 2;
      } else {
        if (auto dead = dead_end(last(), end, step)) nodes.push_back(std::move(*dead));
        break;
      }
    }
    return nodes;
  }

  /// What ends the motion within some steps of `near`: the end of the run, at which what the group
  /// depends on is dead, or the group's own dead point.
  std::optional<Node> dead_end(const Node& near, double end, double step) {
    if (auto dead = dead_point(near, end < near.drive ? -step : step)) return dead;
    if (std::abs(end - near.drive) > 8 * step) return std::nullopt;
    mover_.drive_to(end);
    std::ranges::copy(near.bodies, mover_.of_group().begin());
    if (!mover_.close()) return std::nullopt;
    Node node = mover_.node(end);
    node.is_dead = true;
    return node;
  }

  /// Where the drive turns back, as seen from `near`.
  std::optional<Node> dead_point(const Node& near, double step) {
    NearDeadPoint motion(mover_, near);
    const auto rate = [&](double way) { return motion.move_by(way); };
    const double most = kFarthest * mover_.equations().arm();
    const double at_near = rate(0);
    for (double way = step * motion.rate(); std::abs(way) < most; way *= 2) {
      const double beyond = rate(way);
      if (!std::isfinite(beyond)) return std::nullopt;
      if (beyond * at_near > 0) continue;
      const bool ascends = way > 0;
      const auto bracket = ascends ? bracket_zero(rate, 0, at_near, way, beyond)
                                   : bracket_zero(rate, way, beyond, 0, at_near);
      const double dead = better_end(rate, bracket);
      rate(dead);
      Node node = motion.dead_node();
      if (!((node.drive - near.drive) * step > 0)) return std::nullopt;
      rate(2 * dead);
      beyond_ = motion.beyond();
      return node;
    }
    return std::nullopt;
  }

  const AssemblyRange& run_;
  double scale_;
  const std::function<bool()>& stop_;
  GroupMover mover_;
  double sign_ = 1;
  std::optional<GroupTrack::Beyond> beyond_;  ///< the dead point found last
};

/// The cubic through two values and their rates.
Vec2d cubic(double t, double width, const std::array<Vec2d, 2>& a, const std::array<Vec2d, 2>& b) {
  const double u = 1 - t;
  return (u * u * (1 + 2 * t)) * a[0] + (t * t * (1 + 2 * u)) * b[0] + (width * t * u * u) * a[1] -
         (width * t * t * u) * b[1];
}

Placement between(double t, double width, const BodyMotion<double, 1>& a,
                  const BodyMotion<double, 1>& b) {
  return {cubic(t, width, a.origin, b.origin),
          cubic(t, width, {a.direction, a.turn[0] * perp(a.direction)},
                {b.direction, b.turn[0] * perp(b.direction)})};
}

Placement lerp(double t, const BodyMotion<double, 1>& a, const BodyMotion<double, 1>& b) {
  return {a.origin[0] + t * (b.origin[0] - a.origin[0]),
          a.direction + t * (b.direction - a.direction)};
}

}  // namespace

Placement GroupTrack::placement(double drive, std::size_t body) const {
  const auto after = std::ranges::upper_bound(nodes_, drive, {}, &Node::drive);
  const auto index = std::clamp<std::ptrdiff_t>(after - nodes_.begin(), 1, std::ssize(nodes_) - 1);
  const Node& a = nodes_[static_cast<std::size_t>(index - 1)];
  const Node& b = nodes_[static_cast<std::size_t>(index)];
  const double width = b.drive - a.drive;
  const double t = std::clamp((drive - a.drive) / width, 0., 1.);
  Placement found;
  if (a.is_dead) {
    found = lerp(std::sqrt(t), a.bodies[body], b.bodies[body]);
  } else if (b.is_dead) {
    found = lerp(std::sqrt(1 - t), b.bodies[body], a.bodies[body]);
  } else {
    found = between(t, width, a.bodies[body], b.bodies[body]);
  }
  found.direction = (1 / norm(found.direction)) * found.direction;
  return found;
}

std::optional<GroupTrack> track_group(const TrackedRun& along, int dyad, double drawn,
                                      const std::function<bool()>& stop) {
  return Tracker(along, dyad, stop).track(drawn);
}

}  // namespace cognate
