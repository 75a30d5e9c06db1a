#include "synthesis/exact/straight_line/straight_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cognate::synthesis {
namespace {

/// Points farther off than this many sizes are as good as at infinity.
constexpr double kReach = 1e6;

Vec2d gradient(const CircleOrLine& locus, const Vec2d& z) {
  return (2 * locus.square) * z + locus.linear;
}

/// 1/|sine| of the angle between two directions.
double crossing(const Vec2d& a, const Vec2d& b) {
  const double sine = std::abs(cross(a, b)) / (norm(a) * norm(b));
  return sine > 0 ? 1 / sine : std::numeric_limits<double>::infinity();
}

/// Collects the points of one position.
class Finder {
 public:
  Finder(const CouplerPosition& position, int wanted)
      : position_(position),
        wanted_(wanted),
        second_(contact_locus(position.series, 2)),
        third_(contact_locus(position.series, 3)) {}

  StraightPoints find() {
    if (is_still()) return {NoStraightPoint::change_point, {}, {}};
    const auto four = four_point_contact(position_.series, position_.size);
    if (four.kind == FourPointContact::Kind::none)
      return {NoStraightPoint::parallel_motion, {}, {}};
    found_.inflection = second_;
    const bool locus = four.kind == FourPointContact::Kind::locus;
    if (locus) {
      add_five_points();
    } else {
      add_ball(four.ball);
    }
    // Where all loci are one, as in an elliptic trammel, no point of it stands out.
    if (wanted_ == 3 || (locus && (wanted_ == 4 || found_.points.empty()))) {
      add_on_coupler_line();
      add_inflection_pole();
      if (locus) add_on_inflection_line();
    }
    if (!found_.points.empty()) found_.why = NoStraightPoint::none;
    return found_;
  }

 private:
  bool is_still() const {
    constexpr double kStill = 1e-12;
    return norm(position_.series.pin[1]) <= kStill * position_.size &&
           norm(position_.series.direction[1]) <= kStill;
  }

  void add(StraightPointKind kind, const Vec2d& z, double crossing_condition) {
    const double far = norm(z) / position_.size;
    const Vec2d point = position_.in_coupler(z);
    const Contact found = contact(position_.series, z, position_.size);
    if (!(far <= kReach)) {
      found_.why = NoStraightPoint::at_infinity;
    } else if (is_slider(z)) {
      found_.why = NoStraightPoint::at_slider;
    } else if (found.points == 0) {
      found_.why = NoStraightPoint::at_pole;
    } else if (found.points < wanted_) {
      found_.why = NoStraightPoint::too_few;
    } else if (!is_known(z)) {
      found_.points.push_back({kind, point, found, crossing_condition * std::max(1.0, far)});
    }
  }

  bool is_slider(const Vec2d& z) const {
    constexpr double kSame = 1e-7;
    return position_.slider && norm(*position_.slider - z) <= kSame * position_.size;
  }

  bool is_known(const Vec2d& z) const {
    constexpr double kSame = 1e-9;
    const Vec2d point = position_.in_coupler(z);
    return std::ranges::any_of(found_.points, [&](const StraightPoint& other) {
      return norm(other.coupler_point - point) <= kSame * position_.size;
    });
  }

  void add_on_coupler_line() {
    const Vec2d along = position_.series.direction[0];
    for (const auto& distance : meet(second_, {}, along)) {
      if (!distance) continue;
      const Vec2d z = *distance * along;
      add(StraightPointKind::coupler_line, z, crossing(gradient(second_, z), perp(along)));
    }
    if (found_.points.empty()) found_.why = NoStraightPoint::misses_coupler_line;
  }

  void add_inflection_pole() {
    const double reach = kReach * position_.size;
    const auto circle = as_circle(second_, reach);
    const auto pole = finite(pole_point(position_.series), reach);
    if (!circle || !pole) return;
    add(StraightPointKind::inflection_pole, 2.0 * circle->centre - *pole, 1);
  }

  /// Where the pole is at infinity and the whole line has the contact, its point level with B; if
  /// that is the slider's pin, the one as far from it as the longest link is long.
  void add_on_inflection_line() {
    const auto line = as_line(second_, position_.size);
    if (!line) return;
    const Vec2d foot = line->through - dot(line->through, line->direction) * line->direction;
    const double away = is_slider(foot) ? position_.size : 0;
    add(StraightPointKind::inflection_line, foot + away * line->direction, 1);
  }

  void add_ball(const ProjectivePoint& ball) {
    const auto z = finite(ball, kReach * position_.size);
    if (!z) {
      if (found_.points.empty()) found_.why = NoStraightPoint::at_infinity;
      return;
    }
    add(StraightPointKind::ball, *z, crossing(gradient(second_, *z), gradient(third_, *z)));
  }

  /// Where all of the inflection locus has contact of four points, the fifth is where it meets the
  /// next locus.
  void add_five_points() {
    const CircleOrLine fourth = contact_locus(position_.series, 4);
    const auto line = as_line(second_, position_.size);
    const auto chord = line ? line : as_line(common_chord(second_, fourth), position_.size);
    if (!chord) return;
    for (const auto& distance : meet(line ? fourth : second_, chord->through, chord->direction)) {
      if (!distance) continue;
      const Vec2d z = chord->through + *distance * chord->direction;
      const double condition = crossing(gradient(second_, z), gradient(fourth, z));
      constexpr double kOneLocus = 1e10;
      if (condition < kOneLocus) add(StraightPointKind::five_point, z, condition);
    }
  }

  const CouplerPosition& position_;
  int wanted_;
  CircleOrLine second_, third_;
  StraightPoints found_;
};

}  // namespace

std::string_view name(StraightPointKind kind) {
  constexpr std::array<std::string_view, 5> kNames{"coupler-line", "inflection-pole", "ball-point",
                                                   "five-point-contact", "inflection-line"};
  return kNames[static_cast<std::size_t>(kind)];
}

StraightPoints straight_points(const CouplerPosition& position, int contact) {
  return Finder(position, contact).find();
}

StraightPoints straight_points(const CouplerLinkage& linkage, double crank_angle, int contact) {
  const auto position = coupler_position(linkage, crank_angle);
  if (!position) return {NoStraightPoint::not_closed, {}, {}};
  return straight_points(*position, contact);
}

}  // namespace cognate::synthesis
