/// @file A mechanism of any type but a chain in a page. `mechanism` takes one, the other calls say
/// what the program says of it and draws it by.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "app/drawing/mechanism_poses.hpp"
#include "app/drawing/mechanism_shapes.hpp"
#include "app/report/kernel/numbers.hpp"
#include "problems/evaluation/motion_summary.hpp"
#include "problems/evaluation/type_quantities.hpp"
#include "problems/evaluation/whole_motion.hpp"
#include "problems/mechanism/mechanism_types.hpp"

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

/// Takes what one key holds.
template <class Type>
struct TakeKey {
  Reader& in;
  Type& made;

  void operator()(const problems::PivotsKey<Type>& pivots) const {
    made.*pivots.first = in.point();
    made.*pivots.second = in.point();
  }
  void operator()(const problems::PlaceKey<Type>& place) const { made.*place.of = in.point(); }
  void operator()(const problems::DirectionKey<Type>& direction) const {
    made.*direction.of = in.direction();
  }
  void operator()(const problems::InclinationKey<Type>& line) const {
    made.*line.of = in.direction();
  }
  void operator()(const problems::AssemblyKey<Type>& assembly) const {
    made.*assembly.of = in.assembly();
  }
  void operator()(const problems::PointKey<Type>& point) const {
    const bool has = in.number() != 0;
    const Vec2d at = in.point();
    if (has) made.*point.of = at;
  }
  /// A length or an offset.
  template <class Number>
  void operator()(const Number& number) const {
    made.*number.of = in.number();
  }
};

MechanismDescription description(std::string_view type, Reader& in) {
  MechanismDescription made;
  problems::for_each_mechanism_type([&]<class Type>(std::type_identity<Type>) {
    if constexpr (problems::SimpleType<Type>) {
      using Traits = problems::TypeTraits<Type>;
      if (Traits::kWord != type) return;
      Type dimensions;
      for (const auto& key : Traits::kKeys) std::visit(TakeKey<Type>{in, dimensions}, key.holds);
      made = dimensions;
    }
  });
  return made;
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

/// Takes a mechanism: the `letters` of its type's name, its dimensions in the order of the type's
/// keys, points as x and y, directions as angles in radians, an assembly by its sign, a point that
/// may be missing behind whether it is there; then start and end of the drive, and `points` points
/// of bodies, each with the number of its body.
COGNATE_EXPORT(mechanism) void take_mechanism(int letters, int points) {
  Reader in;
  problem = {};
  std::string type;
  for (int i = 0; i < letters; ++i) type += static_cast<char>(in.number());
  problem.mechanism = problems::named(description(type, in));
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

/// What the program says of the mechanism taken: its quantities by type and over its motion, each a
/// line of the name and the value, parted by a tab. A value that is a number is written as #, and
/// stands in the block, in the order of the lines. Returns the length of the text, which begins at
/// `text`.
COGNATE_EXPORT(mechanism_quantities) int mechanism_quantities() {
  const problems::Deadline none{problems::Run{}};
  auto quantities = problems::type_quantities(problem.mechanism, problem.drive.start);
  const auto assembly_ranges =
      problems::follow_until(problem, problem.drive.start, problem.drive.end, none);
  const auto of_motion =
      problems::quantities_of(problems::summarise(problem, assembly_ranges, none));
  quantities.insert(quantities.end(), of_motion.begin(), of_motion.end());
  Writer out;
  text.clear();
  for (const problems::Quantity& quantity : quantities) {
    text += quantity.name + '\t';
    if (const auto* value = std::get_if<double>(&quantity.value)) {
      text += '#';
      out.put(*value);
    } else if (const auto* is = std::get_if<bool>(&quantity.value)) {
      text += *is ? "true" : "false";
    } else {
      text += std::get<std::string>(quantity.value);
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
