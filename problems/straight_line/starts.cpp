#include "problems/straight_line/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/coupler_curve/parallel_cranks.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"
#include "problems/basics/counter_random.hpp"
#include "problems/linkage/linkage_constraints.hpp"
#include "problems/straight_line/model.hpp"
#include "problems/straight_line/placing.hpp"
#include "synthesis/exact/straight_line/straight_points.hpp"

namespace cognate::problems {
namespace {

constexpr int kSamples = 120;
/// Fewer steps say nothing of how straight a segment is: two samples are always in line.
constexpr std::size_t kLeastCells = 4;
/// Stretches less straight than this, over their length, are not worth refining.
constexpr double kWorthRefining = 0.03;
/// How much less straight than requested a start may be, and how bent it may be in any case: what
/// refinement makes of it is a hundred times as straight.
constexpr double kLoose = 6, kBent = 0.01;

/// Kronecker's sequence by the powers of the root of x^(d+1) = x + 1, which fills a cube of d
/// dimensions evenly from any index on (Roberts 2018, "The unreasonable effectiveness of
/// quasirandom sequences"), moved by a vector that the seed gives.
class KroneckerPoints {
 public:
  static constexpr int kDimensions = 8;

  KroneckerPoints(std::uint64_t seed, std::uint64_t index) {
    constexpr double kRoot = 1.0850702454914508;  // x^9 = x + 1
    double step = 1;
    for (std::uint64_t dimension = 0; double& x : x_) {
      step /= kRoot;
      const double shift = unit_number(split_mix(seed, dimension++));
      x = std::fmod(shift + step * double(index % (1U << 24)), 1.0);
    }
  }

  double next() { return x_[static_cast<std::size_t>(at_++ % kDimensions)]; }
  double between(double low, double high) { return low + (high - low) * next(); }
  double logarithmic(double low, double high) { return low * std::pow(high / low, next()); }

 private:
  std::array<double, kDimensions> x_{};
  int at_ = 0;
};

std::array<double, 4> random_links(KroneckerPoints& points) {
  std::array<double, 4> links;
  for (double& link : links) link = points.logarithmic(0.12, 1);
  return links;
}

Lengths<double> lengths_of(const LinkageSegment& drawn) {
  const auto& [crank, coupler, rocker, frame] = drawn.dimensions.links;
  return {crank, coupler, rocker, frame};
}

/// Ball's point at a random position of a random linkage.
bool draw_ball_point(KroneckerPoints& points, LinkageSegment& drawn) {
  drawn.dimensions.links = random_links(points);
  const auto& [crank, coupler, rocker, frame] = drawn.dimensions.links;
  const FourBar linkage{{0, 0}, {frame, 0}, crank, coupler, rocker, drawn.assembly, {}};
  const auto found = synthesis::straight_points(linkage, points.between(0, kTurn), 4);
  if (found.points.empty()) return false;
  drawn.dimensions.point = found.points.front().coupler_point;
  return true;
}

bool draw_parallel_cranks(KroneckerPoints& points, LinkageSegment& drawn) {
  const ParallelCranks cranks{points.logarithmic(0.12, 1), points.logarithmic(0.12, 1),
                              points.logarithmic(0.12, 1), 0,
                              points.next() < 0.5 ? CrankSides::same : CrankSides::opposite};
  const auto linkage = four_bar(cranks);
  const auto point = five_point_contact(cranks);
  if (!linkage || !point) return false;
  const Lengths<double> links = lengths(*linkage);
  drawn.dimensions = {{links.crank, links.coupler, links.rocker, links.frame}, *point};
  drawn.assembly = linkage->assembly;
  return true;
}

/// Shapes, their size ignored.
bool draw_four_bar(KroneckerPoints& points, SegmentFamily family, LinkageSegment& drawn) {
  auto& [links, point] = drawn.dimensions;
  links = random_links(points);
  switch (family) {
    case SegmentFamily::symmetric_curve: {
      links[2] = links[1];
      const double angle = points.between(-kPi, kPi);
      point = links[1] * (Vec2d{1, 0} + unit_vector(angle * angle * angle / (kPi * kPi)));
      return true;
    }
    case SegmentFamily::equal_cranks:
      links[2] = links[0];
      point = {0.5 * links[1], points.between(-1.2, 1.2)};
      if (points.next() < 0.25) point.y = 0;
      return true;
    case SegmentFamily::on_coupler_line:
      point = {points.between(-1.5, 1.5), 0};
      return true;
    case SegmentFamily::ball_point:
      return draw_ball_point(points, drawn);
    case SegmentFamily::parallel_cranks:
      return draw_parallel_cranks(points, drawn);
    default:
      point = {points.between(-1.2, 1.2), points.between(-1.2, 1.2)};
      return true;
  }
}

void draw_slider_crank(KroneckerPoints& points, SegmentFamily family, LinkageSegment& drawn) {
  auto& [links, point] = drawn.dimensions;
  links = {points.logarithmic(0.12, 1), points.logarithmic(0.12, 1), points.between(-0.7, 0.7), 1};
  point = {points.between(-1.2, 1.2), points.between(-1.2, 1.2)};
  if (family == SegmentFamily::isosceles_slider) {
    links[1] = links[0];
    links[2] *= 0.2;
    point = {-links[0], 0.3 * point.y};
  } else if (family == SegmentFamily::on_coupler_line) {
    point.y = 0;
  }
}

std::vector<SegmentFamily> families(MechanismType type) {
  using enum SegmentFamily;
  if (type == MechanismType::slider_crank) return {any, on_coupler_line, isosceles_slider};
  return {any, symmetric_curve, equal_cranks, on_coupler_line, ball_point, parallel_cranks};
}

}  // namespace

std::string_view name(SegmentFamily family) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(SegmentFamily::count)> kNames{
      "any",        "symmetric-curve", "equal-cranks",    "coupler-line",
      "ball-point", "parallel-cranks", "isosceles-slider"};
  return kNames.at(static_cast<std::size_t>(family));
}

SegmentStarts::SegmentStarts(const StraightLineProblem& problem) : problem_(problem) {}

/// Enlarges what was drawn to the lengths given, takes these, and brings the others within their
/// bounds. Without any the size is left.
void SegmentStarts::bring_to_scale(LinkageSegment& drawn) const {
  if (!has_scale(problem_)) return;
  const Given& given = problem_.given;
  const Bounds& bounds = problem_.bounds;
  const bool slides = drawn.type == MechanismType::slider_crank;
  const std::array<std::optional<double>, 4> fixed{
      given.crank, given.coupler, slides ? problem_.slider_offset : given.rocker, given.frame};
  const std::array<std::optional<Range>, 4> ranges{
      bounds.crank, bounds.coupler, slides ? std::nullopt : bounds.rocker, bounds.frame};
  auto& links = drawn.dimensions.links;
  double factor = problem_.goal->length.value_or(1);
  double most = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (ranges[i]) most = std::min(most, ranges[i]->max / links[i]);
  }
  if (std::isfinite(most)) factor = most;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (fixed[i] && *fixed[i] != 0 && links[i] > 0) {
      factor = *fixed[i] / links[i];
      break;
    }
  }
  drawn = enlarged(drawn, factor);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (fixed[i]) links[i] = *fixed[i];
    if (ranges[i]) links[i] = std::clamp(links[i], std::max(ranges[i]->min, 1e-6), ranges[i]->max);
  }
  Vec2d& point = drawn.dimensions.point;
  if (bounds.coupler_point) {
    point = {std::clamp(point.x, bounds.coupler_point->min.x, bounds.coupler_point->max.x),
             std::clamp(point.y, bounds.coupler_point->min.y, bounds.coupler_point->max.y)};
  }
  if (given.coupler_point) point = *given.coupler_point;
}

bool SegmentStarts::accept(LinkageSegment& drawn) const {
  bring_to_scale(drawn);
  if (drawn.type == MechanismType::slider_crank) return true;
  const Lengths<double> links = lengths_of(drawn);
  if (!can_assemble(links)) return false;
  const Constraints& constraints = problem_.constraints;
  const auto& required = constraints.required_class;
  if (required && !is_of_class(mobility_class(links), *required)) return false;
  const auto [least, most] = std::ranges::minmax(drawn.dimensions.links);
  return !constraints.link_ratio_max || most <= 1.2 * *constraints.link_ratio_max * least;
}

/// The curve in one range of the crank; false where there is none.
bool SegmentStarts::sample(const LinkageSegment& drawn, bool second_range) {
  const CouplerMotion<double> motion(drawn.type, drawn.dimensions, sign(drawn.assembly));
  CrankRange range{0, kTurn};
  closed_ = drawn.type == MechanismType::slider_crank || crank_rotates(lengths_of(drawn));
  if (!closed_) {
    const auto ranges = crank_ranges(lengths_of(drawn));
    if (ranges.empty()) return false;
    range = second_range ? ranges.back() : ranges.front();
  }
  angles_ = crowded(range.from, range.to, kSamples);
  if (closed_) {
    angles_.resize(kSamples);
    for (int i = 0; i < kSamples; ++i) angles_[static_cast<std::size_t>(i)] = kTurn * i / kSamples;
  }
  curve_.clear();
  for (const double angle : angles_) {
    const CouplerPoint<double> point = motion.at(angle);
    const bool sound =
        point.closes && std::abs(point.transmission_cosine) < std::cos(kDeadPointMargin);
    curve_.push_back(sound ? point.at : Vec2d{kNaN, kNaN});
  }
  return true;
}

std::optional<SegmentStart> SegmentStarts::best_segment(const LinkageSegment& drawn) {
  const StraightLineGoal& goal = *problem_.goal;
  const bool scaled = has_scale(problem_);
  const double size = largest_dimension(drawn), shortest = size / size_limit(problem_);
  SegmentLimits limits;
  limits.least_cells = kLeastCells;
  const auto& turn = problem_.segment.crank_range;
  if (turn && closed_) {
    const double step = kTurn / kSamples;
    const auto cells = [step](double angle) {
      return std::max(kLeastCells, static_cast<std::size_t>(angle / step));
    };
    limits.least_cells = cells(turn->min);
    limits.most_cells = cells(turn->max + step);
  }
  SampledSegment found;
  const SegmentObjective objective = objective_of(problem_);
  if (objective == SegmentObjective::deviation) {
    const double least = scaled && goal.length ? std::max(shortest, *goal.length) : shortest;
    found = segments_.straightest(curve_, closed_, least, kWorthRefining, limits);
  } else {
    const double length = goal.length.value_or(1);
    const double asked = goal.deviation ? *goal.deviation / length : *goal.deviation_relative;
    const double relative = std::clamp(kLoose * asked, kBent, 0.1);
    found = segments_.longest(curve_, closed_, relative, limits);
  }
  if (!(found.length > 0)) return std::nullopt;
  SegmentStart start;
  start.segment = drawn;
  const std::size_t count = angles_.size();
  const auto angle = [&](std::size_t i) {
    return i < count ? angles_[i] : angles_[i - count] + kTurn;
  };
  const double from = angle(found.from), to = angle(found.to);
  start.segment.centre = 0.5 * (from + to);
  start.segment.reach = 0.5 * (to - from);
  start.segment.line = std::atan2(found.direction.y, found.direction.x);
  start.segment.length = found.length;
  const Vec2d& end = curve_[found.from];
  start.segment.height = cross(found.direction, end);
  switch (objective) {
    case SegmentObjective::deviation:
      start.score = found.deviation / found.length;
      break;
    case SegmentObjective::length:
      start.score = 1 / found.length;
      break;
    case SegmentObjective::size:
      start.score = size / found.length;
      break;
  }
  if (!scaled) start.segment = enlarged(start.segment, goal.length.value_or(1) / found.length);
  return start;
}

/// In the best of its places; how far that is off counts like deviation.
void SegmentStarts::bring_into_place(SegmentStart& start) const {
  constexpr double kWeight = 4;
  start.segment = placed(problem_, start.segment);
  start.score *= 1 + kWeight * place_violation(problem_, start.segment);
}

std::optional<SegmentStart> SegmentStarts::draw(std::uint64_t seed, std::uint64_t index) {
  const auto all = families(problem_.type);
  const SegmentFamily family = all[index % all.size()];
  KroneckerPoints points(seed + 977 * static_cast<std::uint64_t>(family), index / all.size());
  LinkageSegment drawn;
  drawn.type = problem_.type;
  const double chance = points.next();
  const Assembly either = chance < 0.5 ? Assembly::open : Assembly::crossed;
  drawn.assembly = problem_.given.assembly.value_or(either);
  const bool second_range = chance * 4 - std::floor(chance * 4) < 0.5;
  if (problem_.type == MechanismType::slider_crank) {
    draw_slider_crank(points, family, drawn);
  } else if (!draw_four_bar(points, family, drawn)) {
    return std::nullopt;
  }
  if (problem_.given.assembly && drawn.assembly != *problem_.given.assembly) return std::nullopt;
  drawn = enlarged(drawn, 1 / largest_dimension(drawn));
  if (!accept(drawn) || !sample(drawn, second_range)) return std::nullopt;
  auto start = best_segment(drawn);
  if (!start) return start;
  start->family = family;
  if (limits_place(problem_)) bring_into_place(*start);
  return start;
}

}  // namespace cognate::problems
