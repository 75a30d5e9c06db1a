#include "problems/straight_line/solutions.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/linkage/change_point.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

using synthesis::CouplerLinkage;
using synthesis::FamilyMember;
using synthesis::NoStraightPoint;

std::string_view reason(NoStraightPoint why, int contact) {
  switch (why) {
    case NoStraightPoint::not_closed:
      return "the linkage cannot be assembled at this position of the crank";
    case NoStraightPoint::change_point:
      return "all links are in line (a change point), where the motion is undetermined";
    case NoStraightPoint::parallel_motion:
      return "the coupler slides without turning, as in a parallelogram: all its points move as "
             "the crank pin does, and none has an inflection";
    case NoStraightPoint::at_infinity:
      return "Ball's point is at infinity, or as good as there: the cranks are parallel and the "
             "coupler stands aslant, so that the points of the inflection line have contact of "
             "three points and no more";
    case NoStraightPoint::at_pole:
      return "Ball's point falls on the coupler's pole, where nothing moves";
    case NoStraightPoint::at_slider:
      return "Ball's point is the slider's own pin, which moves straight in any case; another one "
             "exists only where crank and coupler are in line with the slide line, and points of "
             "contact of four where the crank stands across it";
    case NoStraightPoint::too_few:
      return contact == 5
                 ? "Ball's point of this position has contact of four points, not of five; "
                   "remove crank_deg or a length, and it is chosen for that"
                 : "the inflection circle's points have less than the contact requested, "
                   "as far as rounding allows";
    case NoStraightPoint::misses_coupler_line:
      return "the inflection circle does not meet the coupler line";
    case NoStraightPoint::none:
      break;
  }
  return "";
}

std::vector<Assembly> assemblies(const StraightLineProblem& problem) {
  if (problem.given.assembly) return {*problem.given.assembly};
  return {Assembly::open, Assembly::crossed};
}

constexpr std::array<double Lengths<double>::*, 4> kLengths{
    &Lengths<double>::crank, &Lengths<double>::coupler, &Lengths<double>::rocker,
    &Lengths<double>::frame};

/// Collects the solutions of one problem.
class Collector {
 public:
  explicit Collector(const StraightLineProblem& problem) : problem_(problem) {}

  StraightLineSolutions collect() {
    if (problem_.slider) {
      for (const Assembly assembly : assemblies(problem_)) add_linkage(slider_crank(assembly));
    } else if (problem_.cranks == CrankArrangement::parallel) {
      add_parallel();
    } else if (problem_.cranks == CrankArrangement::symmetric) {
      for (const Assembly assembly : assemblies(problem_)) add_symmetric(assembly);
    } else {
      for (const Assembly assembly : assemblies(problem_)) add_any(assembly);
    }
    return std::move(found_);
  }

 private:
  void note(const std::string& sentence) {
    for (const std::string& known : found_.notes) {
      if (known == sentence) return;
    }
    found_.notes.push_back(sentence);
  }

  void append(std::vector<synthesis::StraightLineSolution> some, std::string_view otherwise) {
    if (some.empty()) note(std::string(otherwise));
    std::ranges::move(some, std::back_inserter(found_.all));
  }

  /// The points of a position.
  void add_position(const FamilyMember& member) {
    const auto [why, inflection, points] =
        synthesis::straight_points(member.linkage, member.crank_angle, problem_.contact);
    for (const auto& point : points) {
      found_.all.push_back({member.linkage, member.crank_angle, point});
    }
    if (inflection) found_.position = member;
    if (points.empty()) note(fmt::format("No point: {}.", reason(why, problem_.contact)));
  }

  /// A linkage of given lengths, at its position or at all.
  void add_linkage(const CouplerLinkage& linkage) {
    if (problem_.crank_angle) {
      add_position({linkage, *problem_.crank_angle});
      return;
    }
    if (synthesis::crank_ranges(linkage, 0).empty()) {
      note("No point: the linkage cannot be assembled at any position of the crank.");
      return;
    }
    const auto* four_bar = std::get_if<FourBar>(&linkage);
    if (four_bar && change_point_class(lengths(*four_bar)) == ChangePointClass::parallelogram) {
      note(
          "The links make a parallelogram, whose coupler slides without turning on one of its ways "
          "to move: no point of it has an inflection there.");
    }
    append(synthesis::straight_positions(linkage, problem_.contact),
           problem_.slider ? "No point: only in a limit position with crank and coupler along the "
                             "slide line, or of contact of four with the crank across it, has a "
                             "slider-crank points of contact of four or more other than the "
                             "slider's pin."
                           : "No position of this assembly gives Ball's point contact of five "
                             "points.");
  }

  CouplerLinkage slider_crank(Assembly assembly) const {
    return SliderCrank{problem_.given.pivot_a.value_or(Vec2d{}),
                       *problem_.given.crank,
                       *problem_.given.coupler,
                       problem_.slider->offset,
                       unit_vector(problem_.slider->direction),
                       assembly};
  }

  void add_parallel() {
    const Given& given = problem_.given;
    const ParallelCranks cranks{*given.crank, *given.coupler, *given.rocker, problem_.coupler_angle,
                                problem_.sides};
    auto linkage = four_bar(cranks);
    if (!linkage) {
      note(
          "No point: the coupler is in line with the parallel cranks, where the motion is "
          "undetermined.");
      return;
    }
    if (!inflection_line_x(cranks)) {
      note(
          "No point: equal cranks to the same side make a parallelogram, whose coupler slides "
          "without turning: all its points move as the crank pin does, and none has an "
          "inflection.");
      return;
    }
    constexpr double kUpright = 0.5 * kPi;
    const double angle = problem_.crank_angle.value_or(kUpright);
    if (problem_.crank_angle) linkage->pivot_d = unit_vector(angle - kUpright) * linkage->pivot_d;
    add_position({*linkage, angle});
  }

  void add_symmetric(Assembly assembly) {
    const auto& [crank, coupler, rocker, frame, direction, a, d, point, side] = problem_.given;
    const double l1 = crank.value_or(0), l2 = coupler.value_or(0), l4 = frame.value_or(0);
    if (!crank || !coupler || !frame) {
      const auto missing = !crank     ? &Lengths<double>::crank
                           : !coupler ? &Lengths<double>::coupler
                                      : &Lengths<double>::frame;
      append(synthesis::symmetric_lengths(l1, l2, l4, assembly, missing),
             "No length gives a symmetric position of one of the assemblies contact of five "
             "points.");
      return;
    }
    const auto position = synthesis::symmetric_position(l1, l2, l4, assembly);
    if (position) {
      add_position(*position);
    } else {
      note("No point: the cranks are too short for a symmetric position of one of the assemblies.");
    }
  }

  void add_any(Assembly assembly) {
    const Given& given = problem_.given;
    const std::array<std::optional<double>, 4> lengths{given.crank, given.coupler, given.rocker,
                                                       frame_length()};
    const FourBar linkage = four_bar_of(lengths, assembly);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      if (lengths[i]) continue;
      append(synthesis::straight_lengths(linkage, kLengths[i], *problem_.crank_angle),
             "No length gives Ball's point contact of five points in one of the assemblies.");
      return;
    }
    add_linkage(linkage);
  }

  std::optional<double> frame_length() const {
    const Given& given = problem_.given;
    if (given.frame || !given.pivot_a || !given.pivot_d) return given.frame;
    return norm(*given.pivot_d - *given.pivot_a);
  }

  FourBar four_bar_of(const std::array<std::optional<double>, 4>& lengths,
                      Assembly assembly) const {
    const Given& given = problem_.given;
    const Vec2d along = lengths[3].value_or(1.0) * unit_vector(given.frame_angle.value_or(0));
    const Vec2d a = given.pivot_a   ? *given.pivot_a
                    : given.pivot_d ? *given.pivot_d - along
                                    : Vec2d{};
    return {a,
            given.pivot_d && lengths[3] ? *given.pivot_d : a + along,
            lengths[0].value_or(1),
            lengths[1].value_or(1),
            lengths[2].value_or(1),
            assembly,
            {}};
  }

  const StraightLineProblem& problem_;
  StraightLineSolutions found_;
};

}  // namespace

StraightLineSolutions find_solutions(const StraightLineProblem& problem) {
  return Collector(problem).collect();
}

}  // namespace cognate::problems
