/// The dyads where no pivot is given: anywhere about two or three poses, and of parallel poses.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/guidance/dyad_options.hpp"
#include "synthesis/exact/motion/degenerate_poses.hpp"
#include "synthesis/exact/motion/guidance_forms.hpp"
#include "synthesis/exact/motion/seen_from_body.hpp"
#include "synthesis/exact/motion/three_poses.hpp"
#include "synthesis/exact/motion/two_poses.hpp"

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::DyadSolutions;
using synthesis::GuidanceStatus;
using synthesis::GuidingDyad;
using synthesis::Pose;

/// The rr dyad of the moving pivot at[0], at[1] (extents, body axes), and what it becomes where its
/// positions are collinear; with two poses at[2] gives its fixed pivot on the bisector.
std::optional<GuidingDyad> free_link(const MotionProblem& problem, const DyadPlace& at) {
  const double extent = synthesis::extent(problem.poses);
  const Vec2d pivot = extent * Vec2d{at[0], at[1]};
  if (problem.poses.size() == 3) {
    const auto found = synthesis::dyads_with_moving_pivot(fixed_size<3>(problem.poses), pivot);
    if (found.status != GuidanceStatus::found) return std::nullopt;
    return found.storage[0];
  }
  const auto line = synthesis::fixed_pivots_of(fixed_size<2>(problem.poses), pivot);
  if (!line || !(std::abs(at[2]) < 0.999)) return std::nullopt;
  return synthesis::rr_dyad(problem.poses, pivot,
                            line->point + (extent * along(at[2])) * line->direction);
}

/// With three poses the slider or block along the direction at[0] (radians), with two that of the
/// moving or fixed pivot at[0], at[1] (extents from the first pose).
DyadSolutions free_slides(const MotionProblem& problem, DyadKind kind, const DyadPlace& at) {
  const bool slider = kind == DyadKind::pr;
  if (problem.poses.size() == 3) {
    const auto poses = fixed_size<3>(problem.poses);
    const Vec2d direction{std::cos(at[0]), std::sin(at[0])};
    return slider ? synthesis::dyads_with_slide_direction(poses, direction)
                  : synthesis::dyads_with_line_direction(poses, direction);
  }
  const auto poses = fixed_size<2>(problem.poses);
  const Vec2d way = synthesis::extent(poses) * Vec2d{at[0], at[1]};
  if (slider) return synthesis::slider_of(poses, way);
  const Vec2d fixed = poses[0].at + way;
  const auto seen = synthesis::seen_from_body(poses, fixed);
  return synthesis::seen_from_frame(synthesis::slider_of(seen, Vec2d{}), poses, fixed);
}

DyadKind kind_of(const DyadPlace& at) {
  return static_cast<DyadKind>(static_cast<int>(at[3]));
}

/// A dyad of the kind that at[3] numbers.
std::optional<GuidingDyad> free_dyad(const MotionProblem& problem, const DyadPlace& at) {
  std::optional<GuidingDyad> dyad;
  if (kind_of(at) == DyadKind::rr) {
    dyad = free_link(problem, at);
  } else if (const auto found = free_slides(problem, kind_of(at), at);
             found.status == GuidanceStatus::found) {
    dyad = found.storage[0];
  }
  return dyad && allows(problem, dyad->kind) ? dyad : std::nullopt;
}

/// Places of links, sliders or blocks from which a search begins.
void add_free_choices(const MotionProblem& problem, DyadKind kind, DyadChoices& options) {
  constexpr int kDirections = 12, kSlidePlaces = 4;
  const auto number = static_cast<double>(kind);
  const bool three = problem.poses.size() == 3;
  if (kind == DyadKind::rr) {
    const std::vector<double> along_line =
        three ? std::vector<double>{0} : std::vector<double>{-0.7, -0.4, -0.15, 0.15, 0.4, 0.7};
    for (const double at_line : along_line) {
      add_grid(three ? 10 : 6, {0, 0, at_line, number}, {0, 0, three ? 0 : 0.2}, options);
    }
    return;
  }
  if (!three) return add_grid(kSlidePlaces, {0, 0, 0, number}, {}, options);
  constexpr double kStep = kPi / kDirections;
  for (int i = 0; i < kDirections; ++i) {
    const DyadPlace at{(i + 0.5) * kStep, 0, 0, number};
    if (const auto dyad = options.dyad_at(at)) options.choices.push_back({*dyad, at, {kStep}});
  }
}

/// Whether a link that carries the body without turning it turns by less than half a turn. Else
/// every parallelogram of such links passes through its dead points.
bool is_less_than_half_turn(const std::vector<Pose>& poses, const GuidingDyad& link) {
  std::vector<double> angles;
  for (const Pose& pose : poses) {
    const Vec2d at = link.moving - link.fixed + (pose.at - poses[0].at);
    angles.push_back(std::atan2(at.y, at.x));
  }
  std::ranges::sort(angles);
  double widest = angles.front() + kTurn - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) {
    widest = std::max(widest, angles[i] - angles[i - 1]);
  }
  return widest > kPi;
}

}  // namespace

DyadChoices dyad_of_translation(const MotionProblem& problem) {
  DyadChoices options;
  options.is_degenerate = true;
  const auto found = synthesis::degenerate_dyads(problem.poses, GuidanceStatus::translation);
  std::string note = "No pose is turned against another (the poles are at infinity)";
  if (found.count == 0) {
    note += ", and their origins lie on no common circle or line: no dyad guides the body.";
  } else if (found.storage[0].kind == DyadKind::pr) {
    note +=
        ", and their origins lie on a straight line, as all positions of every point of the body "
        "do: a slide on the frame guides it, and no two dyads, which would both slide in that "
        "direction.";
  } else if (!allows(problem, DyadKind::rr)) {
    note += ": links alone (RR) guide the body, which mechanism.dyads does not allow.";
  } else {
    note +=
        ": equal and parallel links guide the body, and a moving pivot and its fixed pivot may be "
        "moved together anywhere.";
    const GuidingDyad link = found.storage[0];
    if (!is_less_than_half_turn(problem.poses, link)) {
      note +=
          " From the first pose to the last the links turn by half a turn or more, so that every "
          "such parallelogram passes through its dead points, where a third link must carry it on.";
    }
    options.dyad_at = [link,
                       all = problem.poses](const DyadPlace& at) -> std::optional<GuidingDyad> {
      const Vec2d in_body = link.length * Vec2d{at[0], at[1]};
      const Vec2d moving = synthesis::to_frame(all[0], in_body);
      return synthesis::rr_dyad(all, in_body, link.fixed + (moving - link.moving));
    };
    add_grid(10, {}, {}, options);
  }
  options.notes.push_back(std::move(note));
  return options;
}

DyadChoices free_dyad(const MotionProblem& problem) {
  const auto status = synthesis::GuidanceForms(problem.poses).status();
  if (problem.poses.size() == 3 && status == GuidanceStatus::translation) {
    return dyad_of_translation(problem);
  }
  DyadChoices options;
  if (problem.poses.size() == 3 && status == GuidanceStatus::rotation) {
    options.notes.push_back("The three poses: " + as_sentence(sentence(status)));
    return options;
  }
  if (!(synthesis::extent(problem.poses) > 0)) {
    options.notes.push_back(
        "The body's origin stands still: the poses are turns about it, and a pin "
        "there does all of it. Give moving_pivots for another guidance.");
    return options;
  }
  options.dyad_at = [problem](const DyadPlace& at) { return free_dyad(problem, at); };
  const bool open = problem.dyads.size() == names<DyadKind>().size();
  for (const DyadKind kind : open ? std::vector{DyadKind::rr} : problem.dyads) {
    add_free_choices(problem, kind, options);
  }
  return options;
}

}  // namespace cognate::problems
