#include "problems/chain/starts/draw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"
#include "synthesis/chain/sweep.hpp"

namespace cognate::problems {
namespace {

using synthesis::ChainLine;
using synthesis::LineType;

/// Of the points of a body so many are drawn close to its second joint: the best dwells are there.
constexpr double kShareAtJoint = 0.2;

/// |cos μ| of links that hold a three-pin link beyond which none is drawn.
constexpr double kNearDead = 0.97;

double log_uniform(std::mt19937_64& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

const DrawnCurve& whole_turn() {
  static const DrawnCurve directions = [] {
    DrawnCurve all;
    for (int i = 0; i < kDrawnPositions; ++i) {
      all[static_cast<std::size_t>(i)] = unit_vector(kTurn * i / kDrawnPositions);
    }
    return all;
  }();
  return directions;
}

struct Distances {
  double least, greatest;
};

Distances distances(const DrawnCurve& a, const DrawnCurve& b) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double square = squared_norm(a[i] - b[i]);
    least = std::min(least, square);
    greatest = std::max(greatest, square);
  }
  return {std::sqrt(least), std::sqrt(greatest)};
}

/// How far a curve reaches in a direction, from the origin.
Distances extent(const DrawnCurve& curve, const Vec2d& direction) {
  const auto [least, greatest] =
      std::ranges::minmax(curve, {}, [&](const Vec2d& point) { return dot(direction, point); });
  return {dot(direction, least), dot(direction, greatest)};
}

class Drawing {
 public:
  /// `is_part`: the positions are those of a part of the turn.
  Drawing(const ChainSpace& space, const DrawnCurve& cranks, bool is_part, std::mt19937_64& random)
      : space_(space),
        cranks_(cranks),
        is_part_(is_part),
        random_(random),
        curves_(space.lines.size()) {
    drawn_.design.parameters.resize(space.given.size());
    drawn_.design.side.assign(space.lines.size(), 0);
    placed_.assign(space.lines.size(), false);
  }

  std::optional<DrawnChain> chain() {
    for (std::size_t k = 0; k < space_.lines.size(); ++k) {
      if (!draw_line(k)) return std::nullopt;
    }
    drawn_.curve = curves_[static_cast<std::size_t>(space_.topology->trace)];
    return drawn_;
  }

 private:
  bool draw_line(std::size_t k) {
    const ChainLine& line = space_.lines[k].line;
    switch (line.type) {
      case LineType::pivot:
        if (is_given(k, 0) && is_given(k, 1)) put_pivot(k, {});
        return true;
      case LineType::crank:
        return draw_crank(k);
      case LineType::dyad:
        return draw_dyad(k);
      case LineType::attached:
        return draw_attached(k);
      case LineType::guide:
      case LineType::heading:
        return true;
      case LineType::slider:
        return draw_slider(k);
      case LineType::third_pin:
        return draw_three_pins(k - synthesis::kThirdPin);
      case LineType::third_link:
      case LineType::drawn:
      case LineType::first_pin:
      case LineType::second_pin:
        return true;  // with the third pin
    }
    return false;
  }

  /// Of parameter i of line k among all parameters.
  std::size_t place_of(std::size_t k, int i) const {
    const int place = space_.lines[k].parameter + i;
    return static_cast<std::size_t>(place);
  }

  std::optional<double> given(std::size_t k, int i) const { return space_.given[place_of(k, i)]; }
  bool is_given(std::size_t k, int i) const { return given(k, i).has_value(); }

  double put(std::size_t k, int i, double drawn) {
    const double value = given(k, i).value_or(drawn);
    drawn_.design.parameters[place_of(k, i)] = value;
    return value;
  }

  void put_pivot(std::size_t k, const Vec2d& drawn) {
    const Vec2d at{put(k, 0, drawn.x), put(k, 1, drawn.y)};
    curves_[k].fill(at);
    placed_[k] = true;
  }

  bool draw_crank(std::size_t k) {
    const auto pivot = static_cast<std::size_t>(space_.lines[k].line.first);
    const bool anchored = space_.is_anchored();
    if (!placed_[pivot]) put_pivot(pivot, anchored ? around({}, 3) : Vec2d{});
    const double length = put(k, 0, anchored ? log_uniform(random_, 0.1, 2) : 1);
    crank_length_ = length;
    if (is_part_) least_radius_ = length;
    for (std::size_t i = 0; i < curves_[k].size(); ++i) {
      curves_[k][i] = curves_[pivot][i] + length * cranks_[i];
    }
    return true;
  }

  Vec2d around(const Vec2d& centre, double farthest) {
    return centre + uniform(random_, 0, farthest) * unit_vector(uniform(random_, 0, kTurn));
  }

  /// A pivot somewhere beside the curve of the point with which dyad k joins it; where both lengths
  /// are given, as far from there as these reach.
  void place_pivot_beside(std::size_t k, std::size_t pivot, std::size_t other) {
    Vec2d centre;
    for (const Vec2d& point : curves_[other]) centre = centre + (1.0 / kDrawnPositions) * point;
    double square = 0;
    for (const Vec2d& point : curves_[other]) square += squared_norm(point - centre);
    const double radius = std::max(least_radius_, std::sqrt(square / kDrawnPositions));
    const Vec2d direction = unit_vector(uniform(random_, 0, kTurn));
    double distance = radius * log_uniform(random_, 0.7, 6);
    const auto first = given(k, 0), second = given(k, 1);
    if (first && second) {
      distance = uniform(random_, std::abs(*first - *second), *first + *second);
    }
    put_pivot(pivot, centre + distance * direction);
  }

  bool draw_dyad(std::size_t k) {
    const ChainLine& line = space_.lines[k].line;
    const auto p = static_cast<std::size_t>(line.first), q = static_cast<std::size_t>(line.second);
    if (!placed(p) && !placed(q)) put_pivot(p, around({}, 3));
    if (!placed(p)) place_pivot_beside(k, p, q);
    if (!placed(q)) place_pivot_beside(k, q, p);
    const auto lengths = draw_lengths(k, distances(curves_[p], curves_[q]));
    if (!lengths) return false;
    const double a = put(k, 0, lengths->x), b = put(k, 1, lengths->y);
    const auto assembly = space_.topology->lines[k].assembly;
    const bool open = assembly ? *assembly == Assembly::open : uniform(random_, 0, 1) < 0.5;
    drawn_.design.side[k] = open ? 1 : -1;
    for (std::size_t i = 0; i < curves_[k].size(); ++i) {
      curves_[k][i] = synthesis::dyad_joint(curves_[p][i], curves_[q][i], a, b, open ? 1.0 : -1.0);
      if (!is_finite(curves_[k][i])) return false;
    }
    return true;
  }

  /// A guide beside or across the curve of the point that the slider's link joins, with a link that
  /// keeps its transmission angle within the limit.
  bool draw_slider(std::size_t k) {
    const ChainLine& line = space_.lines[k].line;
    const auto p = static_cast<std::size_t>(line.first), g = static_cast<std::size_t>(line.second);
    const auto through = static_cast<std::size_t>(space_.lines[g].line.first);
    if (!placed(p)) put_pivot(p, around({}, 3));
    const Vec2d guide = unit_vector(put(g, 0, uniform(random_, -kPi / 2, kPi / 2)));
    const auto [least, greatest] = extent(curves_[p], perp(guide));
    const double half = std::max(0.5 * (greatest - least), 1e-3 * least_radius_);
    const double level = 0.5 * (least + greatest) + 2 * half * uniform(random_, -1, 1);
    if (!placed(through)) {
      put_pivot(through, level * perp(guide) + around(curves_[p].front(), 3));
    }
    const double from = dot(perp(guide), curves_[through].front());
    const double at = from + put(g, 1, level - from);
    const double farthest = std::max(std::abs(at - least), std::abs(at - greatest));
    const double sine = std::min(space_.cosine_limit, 0.98) * log_uniform(random_, 0.1, 1);
    const double length = put(k, 0, farthest / sine);
    const auto assembly = space_.topology->lines[k].assembly;
    const bool open = assembly ? *assembly == Assembly::open : uniform(random_, 0, 1) < 0.5;
    drawn_.design.side[k] = open ? 1 : -1;
    const Vec2d on = curves_[through].front() + (at - from) * perp(guide);
    for (std::size_t i = 0; i < curves_[k].size(); ++i) {
      curves_[k][i] = synthesis::slider_pin(curves_[p][i], on, guide, length, open ? 1.0 : -1.0);
      if (!is_finite(curves_[k][i])) return false;
    }
    return true;
  }

  /// A link somewhere about what holds it, where the crank is at angle 0; the lengths follow. It
  /// must be led through the turn and back to where it began.
  bool draw_three_pins(std::size_t base) {
    constexpr double kNear = 0.5, kFar = 6;  // of the crank
    const double size = std::max(least_radius_, crank_length_);
    const auto pin = [&](const Vec2d& about) {
      return about +
             size * log_uniform(random_, kNear, kFar) * unit_vector(uniform(random_, 0, kTurn));
    };
    const auto holders = points_that_hold(base);
    std::array<Vec2d, 3> pins;
    pins[0] = pin(curves_[holders[0]].front());
    pins[1] = pin(pins[0]);
    pins[2] = pin(pins[0]);
    for (std::size_t i = 0; i < pins.size(); ++i) {
      if (!placed(holders[i])) put_pivot(holders[i], pin(pins[i]));
    }
    put_three_pins(base, holders, pins);
    return lead_three_pins(base);
  }

  std::array<std::size_t, 3> points_that_hold(std::size_t base) const {
    const auto from = [&](int line) {
      return static_cast<std::size_t>(
          space_.lines[base + static_cast<std::size_t>(line)].line.first);
    };
    return {from(synthesis::kFirstPin), from(synthesis::kSecondPin), from(0)};
  }

  void put_three_pins(std::size_t base, const std::array<std::size_t, 3>& holders,
                      const std::array<Vec2d, 3>& pins) {
    const auto length = [&](std::size_t i) { return norm(pins[i] - curves_[holders[i]].front()); };
    const Vec2d way = pins[1] - pins[0];
    const double distance = norm(way);
    const Vec2d third = conj((1 / distance) * way) * (pins[2] - pins[0]);
    put(base, 0, length(2));
    for (std::size_t i = 0; i < 2; ++i) {
      put(base + synthesis::kDrawnLine + i, 0, pins[i].x);
      put(base + synthesis::kDrawnLine + i, 1, pins[i].y);
    }
    put(base + synthesis::kFirstPin, 0, length(0));
    put(base + synthesis::kSecondPin, 0, length(1));
    put(base + synthesis::kSecondPin, 1, distance);
    put(base + synthesis::kThirdPin, 0, third.x);
    put(base + synthesis::kThirdPin, 1, third.y);
  }

  bool lead_three_pins(std::size_t base) {
    const std::vector<double> side(drawn_.design.side.begin(), drawn_.design.side.end());
    const synthesis::ChainView<double> view{space_.lines.data(),
                                            static_cast<int>(base) + synthesis::kThirdPin + 1,
                                            drawn_.design.parameters.data(), side.data()};
    synthesis::ChainPlace<double> place;
    synthesis::place_lines<synthesis::Kept::nothing>(view, cranks_.front(), place);
    const Vec2d* pins = place.at + base + synthesis::kFirstPin;
    const Vec2d began = pins[0];
    for (std::size_t i = 0; i < kDrawnPositions; ++i) {
      if (i > 0) synthesis::place<synthesis::Kept::distances>(view, cranks_[i], place);
      if (!is_finite(pins[0]) || is_near_dead(view, place, base)) return false;
      for (std::size_t pin = 0; pin < 3; ++pin) {
        curves_[base + synthesis::kFirstPin + pin][i] = pins[pin];
      }
    }
    synthesis::place<synthesis::Kept::distances>(view, cranks_.front(), place);
    return norm(pins[0] - began) < 1e-6 * crank_length_;
  }

  bool is_near_dead(const synthesis::ChainView<double>& view,
                    const synthesis::ChainPlace<double>& place, std::size_t base) const {
    const int first = static_cast<int>(base) + synthesis::kFirstPin;
    for (int pin = 0; pin < 3; ++pin) {
      const double cosine = synthesis::transmission_cosine(view, place, first + pin);
      if (std::abs(cosine) > std::max(kNearDead, space_.cosine_limit)) return true;
    }
    return false;
  }

  bool placed(std::size_t k) const {
    return space_.lines[k].line.type != LineType::pivot || placed_[k];
  }

  std::optional<Vec2d> draw_lengths(std::size_t k, const Distances& joined) {
    const double m = joined.least, most = joined.greatest;
    const bool rigid = std::ranges::count(space_.joints, static_cast<int>(k)) == 0;
    if (rigid || is_given(k, 0) || is_given(k, 1)) {
      const double size = 0.5 * (m + most);
      return Vec2d{size * log_uniform(random_, 0.3, 3), size * log_uniform(random_, 0.3, 3)};
    }
    const double limit = std::min(space_.cosine_limit, 0.98);
    for (int attempt = 0; attempt < 8; ++attempt) {
      double nearest = uniform(random_, -limit, limit), farthest = uniform(random_, -limit, limit);
      if (nearest < farthest) std::swap(nearest, farthest);
      // cos μ = (a² + b² − d²)/(2ab) at the least and the greatest distance d.
      const double product = (most - m) * (most + m) / (2 * (nearest - farthest));
      const double squares = m * m + 2 * product * nearest;
      const double difference = squares - 2 * product;
      if (!(difference >= 0) || !(product > 0)) continue;
      const double sum = std::sqrt(squares + 2 * product);
      const double half = 0.5 * std::sqrt(difference) * (uniform(random_, 0, 1) < 0.5 ? -1 : 1);
      return Vec2d{0.5 * sum + half, 0.5 * sum - half};
    }
    return std::nullopt;
  }

  bool draw_attached(std::size_t k) {
    const ChainLine& line = space_.lines[k].line;
    const auto p = static_cast<std::size_t>(line.first), q = static_cast<std::size_t>(line.second);
    const double length = norm(curves_[q][0] - curves_[p][0]);
    const bool at_joint = uniform(random_, 0, 1) < kShareAtJoint;
    const double farthest = at_joint ? 0.2 : 2.5, nearest = at_joint ? 0.005 : 0.15;
    const Vec2d drawn = (length * log_uniform(random_, nearest, farthest)) *
                            unit_vector(uniform(random_, 0, kTurn)) +
                        Vec2d{at_joint ? length : 0, 0};
    const Vec2d at{put(k, 0, drawn.x), put(k, 1, drawn.y)};
    for (std::size_t i = 0; i < curves_[k].size(); ++i) {
      const Vec2d axis = (1 / length) * (curves_[q][i] - curves_[p][i]);
      curves_[k][i] = curves_[p][i] + at * axis;
    }
    return true;
  }

  const ChainSpace& space_;
  const DrawnCurve& cranks_;
  bool is_part_;
  /// Of curves beside which pivots stand: those of a part of the turn may be as short as one likes.
  double least_radius_ = 0;
  double crank_length_ = 1;
  std::mt19937_64& random_;
  DrawnChain drawn_;
  std::vector<DrawnCurve> curves_;
  std::vector<bool> placed_;
};

}  // namespace

std::optional<DrawnChain> draw(const ChainSpace& space, std::mt19937_64& random) {
  return Drawing(space, whole_turn(), false, random).chain();
}

std::optional<DrawnChain> draw(const ChainSpace& space, const DrawnCurve& cranks,
                               std::mt19937_64& random) {
  return Drawing(space, cranks, true, random).chain();
}

}  // namespace cognate::problems
