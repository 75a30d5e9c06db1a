#include "problems/certificate/path_question.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "problems/linkage/certifying.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/certificate.hpp"
#include "problems/path/scale.hpp"

namespace cognate::problems {

PathQuestion path_question(const PathProblem& problem, bool clockwise) {
  const Given& given = problem.given;
  const auto frame_angle = given.pivot_a && given.pivot_d
                               ? std::optional(angle_of(*given.pivot_d - *given.pivot_a))
                               : given.frame_angle;
  const bool increments = problem.crank_reference == CrankReference::first;
  const bool along_frame = problem.crank_reference == CrankReference::frame && frame_angle;
  PathQuestion question;
  question.pivot_fixed = given.pivot_a.has_value();
  question.direction_fixed = problem.crank_reference == CrankReference::global || along_frame;
  question.weights = problem.weights;
  question.weights.resize(problem.points.size(), 1.0);
  question.turned = along_frame ? -*frame_angle : 0.0;
  question.origin = given.pivot_a.value_or(problem.points.front());
  const QuadComplex turn{cosine(Quad(question.turned)), sine(Quad(question.turned))};
  for (std::size_t j = 0; j < problem.points.size(); ++j) {
    const Vec2d& point = problem.points[j];
    const QuadComplex from{Quad(point.x) - question.origin.x, Quad(point.y) - question.origin.y};
    question.points.push_back(along_frame ? turn * from : from);
    const Quad angle =
        Quad(problem.crank_angles[j]) - (increments ? Quad(problem.crank_angles.front()) : Quad(0));
    question.angles.emplace_back(clockwise ? Quad(-angle) : angle);
  }
  return question;
}

double path_error(const PathQuestion& question, const FourBar& linkage, double zero) {
  const Quad a_x = Quad(linkage.pivot_a.x) - question.origin.x;
  const Quad a_y = Quad(linkage.pivot_a.y) - question.origin.y;
  const Quad d_x = Quad(linkage.pivot_d.x) - question.origin.x;
  const Quad d_y = Quad(linkage.pivot_d.y) - question.origin.y;
  const Quad coupler = linkage.coupler, rocker = linkage.rocker;
  const Vec2d point = linkage.coupler_point.value_or(Vec2d{});
  const Quad turn_x = cos(Quad(question.turned)), turn_y = sin(Quad(question.turned));
  Quad sum = 0;
  for (std::size_t j = 0; j < question.points.size(); ++j) {
    const Quad angle = question.angles[j].angle + zero;
    const Quad b_x = a_x + linkage.crank * cos(angle), b_y = a_y + linkage.crank * sin(angle);
    const Quad x = d_x - b_x, y = d_y - b_y, square = x * x + y * y;
    const Quad along = (square + coupler * coupler - rocker * rocker) / 2;
    const Quad height_square = coupler * coupler * square - along * along;
    if (height_square < 0) return kInfinity;
    const Quad height =
        linkage.assembly == Assembly::open ? Quad(sqrt(height_square)) : Quad(-sqrt(height_square));
    const Quad u_x = (along * x - height * y) / (square * coupler);
    const Quad u_y = (along * y + height * x) / (square * coupler);
    const Quad p_x = b_x + point.x * u_x - point.y * u_y;
    const Quad p_y = b_y + point.x * u_y + point.y * u_x;
    const QuadComplex& wanted = question.points[j];
    const Quad off_x = turn_x * p_x - turn_y * p_y - wanted.re.middle();
    const Quad off_y = turn_y * p_x + turn_x * p_y - wanted.im.middle();
    sum += question.weights[j] * (off_x * off_x + off_y * off_y);
  }
  return static_cast<double>(sum);
}

std::array<Range, 4> path_lengths(const PathProblem& problem) {
  const Given& given = problem.given;
  const Bounds& bounds = problem.bounds;
  const auto limits = [](const std::optional<double>& value, const std::optional<Range>& range) {
    return value ? Range{*value, *value} : range.value_or(Range{0, kInfinity});
  };
  auto frame = given.frame;
  if (given.pivot_a && given.pivot_d) frame = norm(*given.pivot_d - *given.pivot_a);
  return {limits(given.crank, bounds.crank), limits(given.coupler, bounds.coupler),
          limits(given.rocker, bounds.rocker), limits(frame, bounds.frame)};
}

double path_ratio(const PathProblem& problem) {
  return largest_ratio(path_lengths(problem), problem.constraints).value_or(kCertifiedLinkRatio);
}

double path_farthest(const PathProblem& problem) {
  if (const auto& point = problem.given.coupler_point) return norm(*point);
  const double unbounded = kFarthestPoint * PathScale(problem).size;
  const auto& box = problem.bounds.coupler_point;
  if (!box) return unbounded;
  const double reach = std::hypot(std::max(std::abs(box->min.x), std::abs(box->max.x)),
                                  std::max(std::abs(box->min.y), std::abs(box->max.y)));
  return std::isfinite(reach) ? reach * (1 + 2 * kCheckTolerance) : unbounded;
}

}  // namespace cognate::problems
