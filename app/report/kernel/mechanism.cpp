/// @file A mechanism of any type but a chain in a page. `mechanism` takes one, the other calls say
/// what the program says of it and draws it by.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "app/report/kernel/numbers.hpp"
#include "app/report/mechanism_poses.hpp"
#include "app/report/mechanism_shapes.hpp"
#include "problems/evaluation/motion_summary.hpp"
#include "problems/evaluation/type_facts.hpp"
#include "problems/evaluation/whole_motion.hpp"

namespace cognate::page {
namespace {

using problems::MechanismDescription;

problems::AnalysisProblem problem;
std::string text;

/// Reads the numbers of a mechanism one after the other.
class Reader {
 public:
  double number() { return given_[at_++]; }
  Vec2d point() {
    const double x = number();
    return {x, number()};
  }
  Vec2d direction() {
    const double angle = number();
    return {std::cos(angle), std::sin(angle)};
  }
  Assembly assembly() { return number() < 0 ? Assembly::crossed : Assembly::open; }

 private:
  std::span<const double> given_ = numbers();
  std::size_t at_ = 0;
};

/// Writes numbers one after the other, as far as there is room.
class Writer {
 public:
  void put(double value) {
    if (count_ < out_.size()) out_[count_++] = value;
  }
  void put(const Vec2d& v) {
    put(v.x);
    put(v.y);
  }
  void put(const Attached<double>& place) {
    put(place.body);
    put(place.at);
  }
  void put(const std::vector<double>& list) {
    for (const double value : list) put(value);
  }
  int count() const { return static_cast<int>(count_); }

 private:
  std::span<double> out_ = numbers();
  std::size_t count_ = 0;
};

FourBar four_bar(Reader& in) {
  FourBar linkage{.pivot_a = in.point(), .pivot_d = in.point()};
  linkage.crank = in.number();
  linkage.coupler = in.number();
  linkage.rocker = in.number();
  linkage.assembly = in.assembly();
  const bool traces = in.number() != 0;
  const Vec2d point = in.point();
  if (traces) linkage.coupler_point = point;
  return linkage;
}

template <class SliderCrankLike>
SliderCrankLike slider_crank(Reader& in) {
  SliderCrankLike made{.pivot = in.point()};
  made.crank = in.number();
  made.coupler = in.number();
  made.offset = in.number();
  made.direction = in.direction();
  made.assembly = in.assembly();
  return made;
}

template <class GuideBarLike>
GuideBarLike guide_bar(Reader& in) {
  GuideBarLike made{.pivot_a = in.point(), .pivot_c = in.point()};
  made.crank = in.number();
  made.offset = in.number();
  made.assembly = in.assembly();
  return made;
}

ScotchYoke scotch_yoke(Reader& in) {
  ScotchYoke made{.pivot = in.point()};
  made.crank = in.number();
  made.offset = in.number();
  made.direction = in.direction();
  made.slot = in.direction();
  return made;
}

TangentGenerator tangent_generator(Reader& in) {
  TangentGenerator made{.pivot = in.point()};
  made.offset = in.number();
  made.direction = in.direction();
  return made;
}

EllipticTrammel elliptic_trammel(Reader& in) {
  EllipticTrammel made{.centre = in.point()};
  made.length = in.number();
  made.direction = in.direction();
  made.second_line = in.direction();
  return made;
}

OldhamCoupling oldham_coupling(Reader& in) {
  OldhamCoupling made{.pivot_a = in.point(), .pivot_d = in.point()};
  made.slot = in.direction();
  return made;
}

MechanismDescription description(problems::MechanismType type, Reader& in) {
  using enum problems::MechanismType;
  switch (type) {
    case four_bar:
      return page::four_bar(in);
    case slider_crank:
      return page::slider_crank<SliderCrank>(in);
    case guide_bar:
      return page::guide_bar<GuideBar>(in);
    case oscillating_block:
      return page::guide_bar<OscillatingBlock>(in);
    case fixed_block:
      return page::slider_crank<FixedBlock>(in);
    case scotch_yoke:
      return page::scotch_yoke(in);
    case tangent_generator:
      return page::tangent_generator(in);
    case elliptic_trammel:
      return page::elliptic_trammel(in);
    case oldham_coupling:
    case chain:
      return page::oldham_coupling(in);
  }
  return FourBar{};
}

void put_shape(const app::BodyShape& shape, Writer& out) {
  out.put(static_cast<double>(shape.outline.size()));
  for (const Vec2d& corner : shape.outline) out.put(corner);
  out.put(static_cast<double>(shape.rails.size()));
  for (const app::Rail& rail : shape.rails) {
    out.put(rail.from);
    out.put(rail.to);
  }
  out.put(shape.block);
}

}  // namespace

/// Takes a mechanism of a type (its number in problems::MechanismType): its dimensions in the order
/// of its description, points as x and y, directions as angles in radians, an assembly by its sign,
/// of a four-bar whether it has a coupler point and that; then start and end of the drive, and
/// `points` points of bodies, each with the number of its body.
COGNATE_EXPORT(mechanism) void take_mechanism(int type, int points) {
  Reader in;
  problem = {};
  problem.mechanism = problems::named(description(static_cast<problems::MechanismType>(type), in));
  problem.drive.start = in.number();
  problem.drive.end = in.number();
  for (int i = 0; i < points; ++i) {
    const auto body = static_cast<std::size_t>(in.number());
    problems::add_point(problem.mechanism, "", problem.mechanism.bodies.at(body), in.point());
  }
}

/// Gives how many positions and bodies the motion has, the drive at each position, and of each body
/// its places (x, y, angle; NaN where it has none); then of each body its outline, rails and
/// whether it is a block, and all pins and named points by body and place. Returns whether the
/// mechanism can be assembled anywhere.
COGNATE_EXPORT(mechanism_motion) int mechanism_motion(int samples) {
  const auto& mechanism = problem.mechanism;
  const auto poses =
      app::sample_poses(mechanism.mechanism, problem.drive.start, problem.drive.end, samples);
  const auto shapes = app::mechanism_shapes(mechanism, poses);
  Writer out;
  out.put(static_cast<double>(poses.size()));
  out.put(static_cast<double>(poses.bodies.size()));
  out.put(poses.drive);
  for (const app::BodyTrack& body : poses.bodies) {
    out.put(body.x);
    out.put(body.y);
    out.put(body.angle);
  }
  for (const app::BodyShape& shape : shapes.bodies) put_shape(shape, out);
  out.put(static_cast<double>(shapes.pins.size()));
  for (const app::Pin& pin : shapes.pins) {
    out.put(pin.at);
    out.put(pin.fixed);
  }
  out.put(static_cast<double>(mechanism.points.size()));
  for (const auto& point : mechanism.points) out.put(point.at);
  const auto placed = [](const app::BodyTrack& body) {
    return std::ranges::any_of(body.x, [](double x) { return std::isfinite(x); });
  };
  return std::ranges::all_of(poses.bodies, placed) ? 1 : 0;
}

/// What the program says of the mechanism taken: its facts by type and over its motion, each a line
/// of the name and the value, parted by a tab. A value that is a number is written as #, and stands
/// in the block, in the order of the lines. Returns the length of the text, which begins at `text`.
COGNATE_EXPORT(mechanism_facts) int mechanism_facts() {
  const problems::Deadline none{problems::Run{}};
  auto facts = problems::type_facts(problem.mechanism, problem.drive.start);
  const auto course = problems::follow_until(problem, problem.drive.start, problem.drive.end, none);
  const auto summary = problems::summarise(problem, course, none);
  facts.insert(facts.end(), summary.facts.begin(), summary.facts.end());
  Writer out;
  text.clear();
  for (const problems::Fact& fact : facts) {
    text += fact.name + '\t';
    if (const auto* value = std::get_if<double>(&fact.value)) {
      text += '#';
      out.put(*value);
    } else if (const auto* is = std::get_if<bool>(&fact.value)) {
      text += *is ? "true" : "false";
    } else {
      text += std::get<std::string>(fact.value);
    }
    text += '\n';
  }
  return static_cast<int>(text.size());
}

/// Where the text of the last call begins.
COGNATE_EXPORT(text) const char* text_begin() {
  return text.data();
}

}  // namespace cognate::page
