#include "problems/path/certificate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/scale.hpp"

namespace cognate::problems {
namespace {

using synthesis::ProportionBox;
using synthesis::TimedPath;

Range limits_of(const std::optional<double>& given, const std::optional<Range>& bounds) {
  if (given) return {*given, *given};
  return bounds.value_or(Range{0, kInfinity});
}

std::array<Range, 4> length_limits(const PathProblem& problem) {
  const Given& given = problem.given;
  const Bounds& bounds = problem.bounds;
  return {limits_of(given.crank, bounds.crank), limits_of(given.coupler, bounds.coupler),
          limits_of(given.rocker, bounds.rocker), limits_of(given.frame, bounds.frame)};
}

/// Greatest distance of the coupler point from B that the file allows; empty if any.
std::optional<double> farthest_point(const PathProblem& problem) {
  if (const auto& point = problem.given.coupler_point) return std::hypot(point->x, point->y);
  const auto& box = problem.bounds.coupler_point;
  if (!box) return std::nullopt;
  const double reach = std::hypot(std::max(std::abs(box->min.x), std::abs(box->max.x)),
                                  std::max(std::abs(box->min.y), std::abs(box->max.y)));
  if (!std::isfinite(reach)) return std::nullopt;
  return reach * (1 + 2 * kCheckTolerance);
}

Given with_frame(Given given) {
  if (!given.pivot_a || !given.pivot_d) return given;
  const Vec2d frame = *given.pivot_d - *given.pivot_a;
  given.frame = std::hypot(frame.x, frame.y);
  given.frame_angle = std::atan2(frame.y, frame.x);
  return given;
}

/// The crank's phase from the frame line: known, or anything.
Range phase_range(const PathProblem& problem) {
  const auto& frame_angle = problem.given.frame_angle;
  if (problem.crank_reference == CrankReference::frame) return {0, 0};
  if (problem.crank_reference == CrankReference::global && frame_angle) {
    return {-*frame_angle, -*frame_angle};
  }
  return {0, synthesis::Interval::above(kTurn)};
}

/// The points seen from the crank pivot where that is given, along the direction in which the
/// crank's zero lies where that is known.
TimedPath timed_path(const PathProblem& scaled, bool clockwise) {
  TimedPath path;
  const bool increments = scaled.crank_reference == CrankReference::first;
  const auto& frame_angle = scaled.given.frame_angle;
  path.direction_fixed = scaled.crank_reference == CrankReference::global ||
                         (scaled.crank_reference == CrankReference::frame && frame_angle);
  const bool along_frame = scaled.crank_reference == CrankReference::frame && frame_angle;
  const std::complex<double> turn = std::polar(1.0, along_frame ? -*frame_angle : 0.0);
  path.pivot_fixed = scaled.given.pivot_a.has_value();
  const Vec2d origin = scaled.given.pivot_a.value_or(Vec2d{});
  for (std::size_t j = 0; j < scaled.points.size(); ++j) {
    const Vec2d point = scaled.points[j] - origin;
    path.points.push_back(turn * std::complex(point.x, point.y));
    const double angle = scaled.crank_angles[j] - (increments ? scaled.crank_angles.front() : 0);
    path.crank_angles.push_back(std::remainder(clockwise ? -angle : angle, kTurn));
  }
  path.weights = scaled.weights;
  path.weights.resize(path.points.size(), 1.0);
  path.lengths = certified_lengths(length_limits(scaled));
  path.farthest_point = farthest_point(scaled).value_or(kFarthestPoint);
  return path;
}

/// Of boxes of one sense.
void judge_each(const synthesis::PathBound& bound, std::span<const ProportionBox> boxes,
                double target, std::span<synthesis::StageVerdict> verdicts) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const synthesis::BoxBound found = bound(boxes[i], target);
    verdicts[i] = {found.least < target ? 0 : 2, found.split};
  }
}

synthesis::BranchResult prove(const PathDomain& domain, const synthesis::StageOptions& options) {
  return synthesis::staged_search(
      whole_parts(domain), options,
      [&](std::span<const PathPart> parts, double target, double first_target,
          std::span<synthesis::StageVerdict> verdicts) {
        judge(domain, parts, target, first_target, verdicts);
      },
      [](const PathPart& part, int side) { return halves(part, side); });
}

}  // namespace

std::vector<PathPart> whole_parts(const PathDomain& domain) {
  std::vector<PathPart> parts;
  for (std::size_t sense = 0; sense < domain.bounds.size(); ++sense) {
    for (const ProportionBox& box : domain.roots) parts.push_back({box, sense});
  }
  return parts;
}

std::pair<PathPart, PathPart> halves(const PathPart& part, int side) {
  const auto [first, second] = synthesis::halves(part.box, side);
  return {PathPart{first, part.sense}, PathPart{second, part.sense}};
}

void judge(const PathDomain& domain, std::span<const PathPart> parts, double target,
           double first_target, std::span<synthesis::StageVerdict> verdicts) {
  std::vector<ProportionBox> boxes;
  std::vector<std::size_t> place;
  for (std::size_t sense = 0; sense < domain.bounds.size(); ++sense) {
    boxes.clear();
    place.clear();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].sense != sense) continue;
      boxes.push_back(parts[i].box);
      place.push_back(i);
    }
    std::vector<synthesis::StageVerdict> found(boxes.size());
    if (domain.provers.empty()) {
      judge_each(domain.bounds[sense], boxes, target, found);
    } else {
      domain.provers[sense].judge(boxes, target, first_target, found);
    }
    for (std::size_t i = 0; i < place.size(); ++i) verdicts[place[i]] = found[i];
  }
}

PathDomain path_domain(const PathProblem& problem) {
  const PathScale scale(problem);
  PathProblem scaled = scale.into(problem);
  scaled.given = with_frame(scaled.given);
  const auto given_ratio = largest_ratio(length_limits(scaled), scaled.constraints);
  const double ratio = given_ratio.value_or(kCertifiedLinkRatio);
  const auto limits = proportion_limits(scaled.constraints, ratio);
  PathDomain domain;
  domain.to_file = scale.size * scale.size;
  domain.roots = proportion_roots(scaled.constraints, scaled.given, length_limits(scaled), ratio,
                                  phase_range(scaled));
  const bool either = scaled.crank_reference != CrankReference::first;
  for (const bool clockwise : {false, true}) {
    const CrankSense other = clockwise ? CrankSense::ccw : CrankSense::cw;
    if (either ? clockwise : scaled.crank_sense == other) continue;
    const TimedPath path = timed_path(scaled, clockwise);
    const auto has_proof = [&](const ProportionBox& root) { return has_path_proof(path, root); };
    if (std::ranges::all_of(domain.roots, has_proof)) domain.provers.emplace_back(path, limits);
    domain.bounds.emplace_back(path, limits);
  }
  domain.text = domain_text(scaled.constraints, scaled.given, ratio, given_ratio.has_value());
  if (!farthest_point(scaled)) {
    domain.text +=
        fmt::format(", coupler point within {:g} of B (likewise)", kFarthestPoint * scale.size);
  }
  return domain;
}

double path_objective(const PathProblem& problem, const Design& design) {
  double sum = 0;
  for (std::size_t j = 0; j < problem.points.size(); ++j) {
    const auto error = path_error(four_bar(design), std::span(problem.points).subspan(j, 1),
                                  std::span(design.crank_angles).subspan(j, 1));
    sum += (problem.weights.empty() ? 1.0 : problem.weights[j]) * error.sum_of_squares;
  }
  return sum;
}

Certificate certify(const PathProblem& problem, double upper, const Run& run,
                    const Deadline& deadline) {
  const PathDomain domain = path_domain(problem);
  const CertificateRun certificate(upper, problem.solve, run, deadline);
  if (certificate.met_exactly(kMetExactly * domain.to_file)) {
    return certificate.state_exact(domain.text);
  }
  if (!domain.provers.empty()) {
    const auto result = prove(domain, certificate.stages(domain.to_file));
    return certificate.state(result, domain.to_file, domain.text);
  }
  const auto options = certificate.options(domain.to_file);
  const auto result = synthesis::branch_and_bound(
      whole_parts(domain), options,
      [&](const PathPart& part) { return domain.bounds[part.sense](part.box, options.target); },
      [](const PathPart& part, int side) { return halves(part, side); });
  return certificate.state(result, domain.to_file, domain.text);
}

}  // namespace cognate::problems
