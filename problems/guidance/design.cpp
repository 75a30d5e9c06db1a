#include "problems/guidance/design.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/evaluation/mechanism_metrics.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidedMechanism;
using synthesis::GuidingDyad;
using synthesis::Pose;

constexpr double kSizePenalty = 0.1;
constexpr double kAtPoses = 0.1;

SlideDescription slide(const Guide<double>& guide) {
  return {guide.through, angle_of(guide.direction), guide.offset, "frame"};
}

/// The chain of a driving slider and an RPR dyad, the block on the frame.
NamedMechanism slider_and_block(const Mechanism<double>& chain) {
  const auto& drive = std::get<DrivingSlider<double>>(chain.drive);
  const auto& dyad = std::get<Rpr<double>>(chain.dyads.front());
  NamedMechanism made;
  made.mechanism = chain;
  made.bodies = {"frame", "slider", "block", "bar"};
  made.points = {{"D", {0, dyad.block.at}}, {"B", {1, {0, 0}}}};
  made.output = 3;
  ChainDescription described;
  described.pivots = {{"D", dyad.block.at}};
  described.drive = SliderDescription{slide(drive.guide), "B", "slider"};
  DyadDescription block;
  block.type = DyadType::rpr;
  block.joins = {"D", "B"};
  block.offset = dyad.offset;
  block.assembly = dyad.assembly;
  block.names = {"block", "bar"};
  described.dyads = {block};
  made.description = described;
  return made;
}

struct NamedOf {
  NamedMechanism operator()(const Mechanism<double>& chain) const {
    return slider_and_block(chain);
  }
  template <class Type>
  NamedMechanism operator()(const Type& type) const {
    return named(MechanismDescription(type));
  }
};

std::vector<DriveState> states_of(const GuidedMechanism& guided) {
  std::vector<DriveState> states;
  for (const auto& station : guided.stations) {
    states.push_back({station.drive, {sign(station.side)}});
  }
  return states;
}

/// The lengths of links, coupler and frame, as far as the pair has them.
std::vector<double> links_of(const DyadPair& pair) {
  std::vector<double> links;
  for (const GuidingDyad* dyad : {&pair.first, &pair.second}) {
    if (dyad->kind == DyadKind::rr) links.push_back(dyad->length);
  }
  if (pair.first.kind != DyadKind::rp && pair.second.kind != DyadKind::rp) {
    links.push_back(norm(pair.second.in_body - pair.first.in_body));
  }
  if (pair.first.kind != DyadKind::pr && pair.second.kind != DyadKind::pr) {
    links.push_back(norm(pair.second.fixed - pair.first.fixed));
  }
  return links;
}

/// How far the slider or the block of a dyad goes at most from where it is at the first pose.
double travel(std::span<const Pose> poses, const GuidingDyad& dyad) {
  double farthest = 0;
  for (const Pose& pose : poses) {
    farthest = std::max(farthest, dyad.kind == DyadKind::pr
                                      ? norm(synthesis::to_frame(pose, dyad.in_body) - dyad.moving)
                                      : norm(synthesis::to_body(pose, dyad.fixed) - dyad.in_body));
  }
  return farthest;
}

/// What it counts that lengths, and ways of slides, differ by more than a designer would accept.
double slenderness(std::span<const Pose> poses, const DyadPair& pair) {
  constexpr double kEasy = 3, kUsual = 10, kMost = 1e3, kRejected = 10;
  auto lengths = links_of(pair);
  for (const GuidingDyad* dyad : {&pair.first, &pair.second}) {
    if (dyad->kind != DyadKind::rr) lengths.push_back(travel(poses, *dyad));
  }
  const auto [shortest, longest] = std::ranges::minmax(lengths);
  const double ratio = longest / shortest;
  const auto beyond = [&](double limit) { return std::log(std::max(ratio / limit, 1.0)); };
  return 0.02 * beyond(kEasy) + 0.2 * beyond(kUsual) + (ratio <= kMost ? 0 : kRejected);
}

/// The acute angle of two directions, of any length.
double acute_angle(const Vec2d& a, const Vec2d& b) {
  return std::atan2(std::abs(cross(a, b)), std::abs(dot(a, b)));
}

/// The least acute transmission angle at the poses of a four-bar; of two slides their angle; else
/// what it is over the motion.
double transmission_at_poses(const MotionProblem& problem, const DyadPair& pair,
                             const Metrics& metrics) {
  if (pair.first.kind != pair.second.kind) return metrics.transmission_acute_min;
  if (pair.first.kind != DyadKind::rr) {
    return acute_angle(pair.first.direction, pair.second.direction);
  }
  double least = kRightAngle;
  for (const Pose& pose : problem.poses) {
    const Vec2d c = synthesis::to_frame(pose, pair.second.in_body);
    const Vec2d b = synthesis::to_frame(pose, pair.first.in_body);
    least = std::min(least, acute_angle(c - b, c - pair.second.fixed));
  }
  return least;
}

double merit(const MotionProblem& problem, const DyadPair& pair, const Metrics& metrics) {
  const double extent = synthesis::extent(problem.poses);
  const double size = extent > 0 ? longest_link(pair) / extent : 0;
  return metrics.transmission_acute_min + kAtPoses * transmission_at_poses(problem, pair, metrics) -
         kSizePenalty * std::log1p(size) - slenderness(problem.poses, pair);
}

bool is_number(const Metrics& metrics) {
  return std::isfinite(metrics.transmission_min + metrics.transmission_max +
                       metrics.transmission_acute_min + metrics.time_ratio.value_or(0));
}

/// Four-bars without what only a finished design needs.
Metrics metrics_of(const GuidedMechanism& guided, const NamedMechanism* mechanism) {
  if (const auto* linkage = std::get_if<FourBar>(&guided.type)) {
    std::vector<CrankPosition> positions;
    for (const auto& station : guided.stations) positions.push_back({station.drive, station.side});
    return design_metrics(*linkage, std::span<const CrankPosition>(positions), MotionKind{});
  }
  return mechanism_metrics(*mechanism, states_of(guided), PointOrder::cyclic);
}

/// The body at a station, as the kernel places it. A station at a dead point may lie beyond it by
/// rounding; it is then moved by as little as helps.
std::optional<Pose> placed(const GuidedMechanism& guided, const synthesis::DriveStation& station) {
  MechanismMotion<0> motion(guided.chain);
  for (double& side : motion.sides()) side = sign(station.side);
  for (const double nudge : {0.0, 1e-12, -1e-12, 1e-9, -1e-9, 1e-7, -1e-7}) {
    if (!motion.move_to(station.drive + nudge)) continue;
    const auto& body = motion.bodies()[static_cast<std::size_t>(guided.body)];
    return Pose{body.origin[0] + body.direction * guided.body_in_link.at,
                angle_of(body.direction) + guided.body_in_link.angle};
  }
  return std::nullopt;
}

/// How far the body, as the kernel places it, is from its poses: distances and angles.
struct Misses {
  std::vector<double> place, angle;
};

/// Empty where the kernel does not place the body at a pose.
std::optional<Misses> misses(std::span<const Pose> poses, const GuidedMechanism& guided) {
  Misses all;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto pose = placed(guided, guided.stations[i]);
    if (!pose) return std::nullopt;
    all.place.push_back(norm(pose->at - poses[i].at));
    all.angle.push_back(std::abs(std::remainder(pose->angle - poses[i].angle, kTurn)));
  }
  return all;
}

/// Whether the kernel finds the body where requested, as near as the poses' own rounding and
/// a part in 1e6 of their extent. Nearly parallel slides and links far longer than the extent may
/// leave it elsewhere.
bool is_on_poses(std::span<const Pose> poses, const DyadPair& pair, const TargetError& error,
                 double turned) {
  constexpr double kPart = 1e-6;
  constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
  const double extent = synthesis::extent(poses);
  double farthest = 0;
  for (const Pose& pose : poses) farthest = std::max(farthest, norm(pose.at));
  const double size = extent > 0 ? extent : longest_link(pair);
  return error.max <= kPart * size + kRounding * farthest && turned <= kPart;
}

void add_quantities(const DyadPair& pair, const GuidedMechanism& guided, double turned,
                    std::vector<Quantity>& quantities) {
  const auto kinds = [](const GuidingDyad& dyad) { return std::string(to_string(dyad.kind)); };
  quantities.push_back({"dyads", kinds(pair.first) + "+" + kinds(pair.second)});
  quantities.push_back(quantity(kAngleErrorKey, turned));
  quantities.push_back(quantity(kBodyAngleKey, std::remainder(guided.body_in_link.angle, kTurn)));
}

void add_moving_bounds(const MotionProblem& problem, const DyadPair& pair,
                       std::vector<ConstraintCheck>& checks) {
  const double allowance = kCheckTolerance * longest_link(pair);
  const auto add = [&](const std::string& name, double value, double least, double greatest) {
    const bool inside = value >= least - allowance && value <= greatest + allowance;
    checks.push_back({"bounds." + name, value, Range{least, greatest}, inside});
  };
  const auto add_box = [&](const std::string& name, const GuidingDyad& dyad,
                           const std::optional<Box>& box) {
    if (!box || dyad.kind == DyadKind::rp) return;
    add(name + ".u", dyad.in_body.x, box->min.x, box->max.x);
    add(name + ".v", dyad.in_body.y, box->min.y, box->max.y);
  };
  add_box("moving_pivot_a", pair.first, problem.moving_bounds[0]);
  add_box("moving_pivot_d", pair.second, problem.moving_bounds[1]);
}

void add_drive(const GuidedMechanism& guided, Design& design) {
  const bool slides = driven_by_length(guided.chain.drive);
  int number = 0;
  for (const auto& station : guided.stations) {
    if (slides) {
      design.metrics.quantities.push_back({"slide_" + std::to_string(++number), station.drive});
    } else {
      design.crank_angles.push_back(in_one_turn(station.drive));
    }
  }
}

}  // namespace

TargetError error_of(std::span<const double> misses) {
  TargetError error;
  for (const double miss : misses) {
    error.sum_of_squares += miss * miss;
    error.max = std::max(error.max, miss);
  }
  error.rms = std::sqrt(error.sum_of_squares / double(misses.size()));
  return error;
}

NamedMechanism named_mechanism(const GuidedMechanism& guided) {
  NamedMechanism made = std::visit(NamedOf{}, guided.type);
  if (!made.four_bar()) {
    add_point(made, "P", made.bodies[static_cast<std::size_t>(guided.body)],
              guided.body_in_link.at);
  }
  return made;
}

double longest_link(const DyadPair& pair) {
  const auto links = links_of(pair);
  return links.empty() ? 0 : *std::ranges::max_element(links);
}

std::optional<Judgement> judge(const MotionProblem& problem, const DyadPair& pair,
                               std::span<const Pose> reached) {
  const auto guided = synthesis::guided_mechanism(pair.first, pair.second, reached);
  if (guided.fault != synthesis::PairingFault::none) return std::nullopt;
  std::vector<ConstraintCheck> checks;
  Metrics metrics;
  if (const auto* linkage = std::get_if<FourBar>(&guided.type)) {
    metrics = metrics_of(guided, nullptr);
    add_cycle_metrics(problem.constraints, *linkage, CycleOutput::coupler_point, metrics);
    checks = check_constraints(problem.constraints, problem.bounds, Given{}, *linkage, metrics);
  } else {
    const NamedMechanism mechanism = named_mechanism(guided);
    metrics = metrics_of(guided, &mechanism);
    checks = check_constraints(problem.constraints, problem.bounds, mechanism, metrics);
  }
  if (!is_number(metrics)) return std::nullopt;
  add_moving_bounds(problem, pair, checks);
  return Judgement{violation(checks), merit(problem, pair, metrics)};
}

std::optional<Judgement> judge(const MotionProblem& problem, const DyadPair& pair) {
  return judge(problem, pair, problem.poses);
}

namespace {

/// Everything but the error and what depends on it.
std::optional<Design> plain_design(const MotionProblem& problem, const DyadPair& pair,
                                   const GuidedMechanism& guided, const std::string& origin) {
  Design design;
  design.mechanism = named_mechanism(guided);
  design.metrics = metrics_of(guided, &design.mechanism);
  if (!is_number(design.metrics)) return std::nullopt;
  if (const FourBar* linkage = design.mechanism.four_bar()) {
    add_cycle_metrics(problem.constraints, *linkage, CycleOutput::coupler_point, design.metrics);
  }
  design.constraints =
      check_constraints(problem.constraints, problem.bounds, design.mechanism, design.metrics);
  add_moving_bounds(problem, pair, design.constraints);
  design.origin = origin;
  return design;
}

}  // namespace

std::optional<Design> motion_design(const MotionProblem& problem, const DyadPair& pair,
                                    const std::string& origin) {
  const auto guided = synthesis::guided_mechanism(pair.first, pair.second, problem.poses);
  if (guided.fault != synthesis::PairingFault::none) return std::nullopt;
  auto design = plain_design(problem, pair, guided, origin);
  const auto missed = misses(problem.poses, guided);
  if (!design || !missed) return std::nullopt;
  design->error = error_of(missed->place);
  const double turned = std::ranges::max(missed->angle);
  if (!is_on_poses(problem.poses, pair, design->error, turned)) return std::nullopt;
  design->metrics.precision_residual = std::max(pair.first.residual, pair.second.residual);
  design->metrics.condition = std::max(pair.first.condition, pair.second.condition);
  add_quantities(pair, guided, turned, design->metrics.quantities);
  add_drive(guided, *design);
  return design;
}

std::optional<Design> nearest_design(const MotionProblem& problem, const DyadPair& pair,
                                     std::span<const Pose> reached, const std::string& origin) {
  const auto guided = synthesis::guided_mechanism(pair.first, pair.second, reached);
  if (guided.fault != synthesis::PairingFault::none) return std::nullopt;
  auto design = plain_design(problem, pair, guided, origin);
  const auto missed = misses(problem.poses, guided);
  if (!design || !missed) return std::nullopt;
  std::vector<double> together;
  for (std::size_t i = 0; i < missed->place.size(); ++i) {
    together.push_back(std::hypot(missed->place[i], problem.angle_weight * missed->angle[i]));
  }
  design->error = error_of(together);
  const TargetError place = error_of(missed->place), angle = error_of(missed->angle);
  add_quantities(pair, guided, angle.max, design->metrics.quantities);
  design->metrics.quantities.push_back({"angle_error_rms_deg", degrees(angle.rms)});
  design->metrics.quantities.push_back({"position_error_rms", place.rms});
  design->metrics.quantities.push_back({"position_error_max", place.max});
  add_drive(guided, *design);
  return design;
}

std::optional<DyadPair> pair_of(const MotionProblem& problem, const Design& design) {
  if (!design.mechanism.four_bar()) return std::nullopt;
  const FourBar& linkage = *design.mechanism.four_bar();
  const auto angle = find_quantity(design.metrics.quantities, kBodyAngleKey);
  if (!linkage.coupler_point || !angle) return std::nullopt;
  const Pose body_in_link{*linkage.coupler_point, *angle};
  const auto link = [&](const Vec2d& in_link, const Vec2d& fixed, double length) {
    GuidingDyad dyad =
        synthesis::rr_dyad(problem.poses, synthesis::to_body(body_in_link, in_link), fixed);
    dyad.length = length;
    return dyad;
  };
  return DyadPair{link({0, 0}, linkage.pivot_a, linkage.crank),
                  link({linkage.coupler, 0}, linkage.pivot_d, linkage.rocker)};
}

}  // namespace cognate::problems
