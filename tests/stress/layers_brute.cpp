#include "tests/stress/layers_brute.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

namespace cognate::test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double point_segment(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
  const double s = t < 0 ? 0 : t > 1 ? 1 : t;
  return std::hypot(p.x - a.x - s * dx, p.y - a.y - s * dy);
}

double side(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

double segment_segment(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return 0;
  return std::min({point_segment(a, c, d), point_segment(b, c, d), point_segment(c, a, b),
                   point_segment(d, a, b)});
}

bool in_triangle(const Vec2d& p, const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  const double u = side(a, b, p), v = side(b, c, p), w = side(c, a, p);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

/// Of the hulls of any points: a point is in a hull if it is in a triangle of its corners.
double hulls(const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
  double least = kInfinite;
  for (const Vec2d& p : a) {
    for (const Vec2d& q : a) {
      for (const Vec2d& r : b) {
        for (const Vec2d& s : b) least = std::min(least, segment_segment(p, q, r, s));
      }
    }
  }
  const auto holds = [](const std::vector<Vec2d>& hull, const Vec2d& p) {
    for (std::size_t i = 0; i < hull.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        for (std::size_t m = 0; m < k; ++m) {
          if (std::abs(side(hull[i], hull[k], hull[m])) > 0 &&
              in_triangle(p, hull[i], hull[k], hull[m])) {
            return true;
          }
        }
      }
    }
    return false;
  };
  return holds(a, b.front()) || holds(b, a.front()) ? 0 : least;
}

/// The worst room of all that shares a layer; by `layers` of the links, from 1.
double worst_room(const std::vector<int>& layers, const std::vector<std::pair<int, int>>& reach,
                  const std::vector<std::vector<char>>& member,
                  const std::vector<std::vector<double>>& link_link,
                  const std::vector<std::vector<double>>& pin_link,
                  const std::vector<std::vector<double>>& pin_pin) {
  double room = kInfinite;
  for (std::size_t a = 0; a < layers.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (layers[a] == layers[b]) room = std::min(room, link_link[a][b]);
    }
  }
  for (std::size_t p = 0; p < reach.size(); ++p) {
    for (std::size_t b = 0; b < layers.size(); ++b) {
      const bool between = reach[p].first < layers[b] && layers[b] < reach[p].second;
      if (between && !member[p][b]) room = std::min(room, pin_link[p][b]);
    }
    for (std::size_t q = 0; q < p; ++q) {
      const int low = std::max(reach[p].first, reach[q].first);
      const int high = std::min(reach[p].second, reach[q].second);
      if (high - low >= 2) room = std::min(room, pin_pin[p][q]);
    }
  }
  return room;
}

}  // namespace

BruteLayers::BruteLayers(const problems::NamedMechanism& mechanism,
                         const problems::LayerSizes& sizes, double from, double to, int count)
    : mechanism_(mechanism), clearance_(sizes.clearance) {
  for (int i = 0; i <= count; ++i) {
    // Closer together at both ends, where a motion may be as the root of the drive.
    drives_.push_back(from + (to - from) * 0.5 * (1 - std::cos(std::numbers::pi * i / count)));
    samples_.push_back(poses(drives_.back()));
  }
  add_parts(sizes);
  measure();
}

std::vector<BruteLayers::Pose> BruteLayers::poses(double drive) const {
  std::vector<Pose> at{{}};
  const auto place = [&](const Attached<double>& point) {
    const Pose& body = at[static_cast<std::size_t>(point.body)];
    const double c = std::cos(body.angle), s = std::sin(body.angle);
    return Vec2d{body.x + c * point.at.x - s * point.at.y,
                 body.y + s * point.at.x + c * point.at.y};
  };
  const auto& crank = std::get<Crank<double>>(mechanism_.mechanism.drive);
  at.push_back({crank.pivot.x, crank.pivot.y, drive});
  for (const Dyad<double>& dyad : mechanism_.mechanism.dyads) {
    if (const auto* rrr = std::get_if<Rrr<double>>(&dyad)) {
      // The law of cosines at the first point.
      const Vec2d a = place(rrr->first), b = place(rrr->second);
      const double d = std::hypot(b.x - a.x, b.y - a.y), l = rrr->first_length;
      const double m = rrr->second_length;
      const double cosine = std::clamp((d * d + l * l - m * m) / (2 * d * l), -1.0, 1.0);
      const double turn = rrr->assembly == Assembly::open ? 1 : -1;
      const double first = std::atan2(b.y - a.y, b.x - a.x) + turn * std::acos(cosine);
      const Vec2d joint{a.x + l * std::cos(first), a.y + l * std::sin(first)};
      at.push_back({a.x, a.y, first});
      at.push_back({b.x, b.y, std::atan2(joint.y - b.y, joint.x - b.x)});
    } else if (const auto* rpr = std::get_if<Rpr<double>>(&dyad)) {
      // A bar through its pivot, without an offset.
      const Vec2d block = place(rpr->block), pivot = place(rpr->pivot);
      const double angle = std::atan2(block.y - pivot.y, block.x - pivot.x);
      at.push_back({block.x, block.y, angle});
      at.push_back({pivot.x, pivot.y, angle});
    } else {
      // A guide of the frame: the foot of the point on it, and from there along it.
      const auto& rrp = std::get<Rrp<double>>(dyad);
      const Vec2d a = place(rrp.point), v = rrp.guide.direction;
      const Vec2d t{rrp.guide.through.x - v.y * rrp.guide.offset,
                    rrp.guide.through.y + v.x * rrp.guide.offset};
      const double foot = (a.x - t.x) * v.x + (a.y - t.y) * v.y;
      const double h = std::hypot(t.x + foot * v.x - a.x, t.y + foot * v.y - a.y);
      const double ahead =
          (rrp.assembly == Assembly::open ? 1 : -1) * std::sqrt(rrp.length * rrp.length - h * h);
      const Vec2d pin{t.x + (foot + ahead) * v.x, t.y + (foot + ahead) * v.y};
      at.push_back({a.x, a.y, std::atan2(pin.y - a.y, pin.x - a.x)});
      at.push_back({pin.x, pin.y, std::atan2(v.y, v.x)});
    }
  }
  return at;
}

void BruteLayers::add_parts(const problems::LayerSizes& sizes) {
  const auto& mechanism = mechanism_.mechanism;
  const std::size_t bodies = mechanism_.bodies.size();
  std::vector<std::vector<Vec2d>> corners(bodies);
  std::vector<int> owner(bodies);  // what stands for a body in pins; −1: the base
  for (std::size_t i = 0; i < bodies; ++i) owner[i] = i == 0 ? -1 : static_cast<int>(i);
  struct Joint {
    std::vector<Attached<double>> places;
  };
  const auto& crank = std::get<Crank<double>>(mechanism.drive);
  std::vector<Joint> joints{{{{0, crank.pivot}, {1, {0, 0}}}}};
  corners[1].push_back({crank.length, 0});
  for (std::size_t i = 0; i < mechanism.dyads.size(); ++i) {
    const int n = 2 + 2 * static_cast<int>(i);
    if (const auto* rrr = std::get_if<Rrr<double>>(&mechanism.dyads[i])) {
      joints.push_back({{rrr->first, {n, {0, 0}}}});
      joints.push_back({{{n, {rrr->first_length, 0}}, {n + 1, {rrr->second_length, 0}}}});
      joints.push_back({{rrr->second, {n + 1, {0, 0}}}});
    } else if (const auto* rpr = std::get_if<Rpr<double>>(&mechanism.dyads[i])) {
      joints.push_back({{rpr->block, {n, {0, 0}}}});
      joints.push_back({{rpr->pivot, {n + 1, {0, 0}}}});
      owner[static_cast<std::size_t>(n)] = n + 1;
      double near = kInfinite, far = -kInfinite;
      for (const auto& at : samples_) {
        const Pose &block = at[static_cast<std::size_t>(n)],
                   &bar = at[static_cast<std::size_t>(n) + 1];
        const double s = std::hypot(block.x - bar.x, block.y - bar.y);
        near = std::min(near, s);
        far = std::max(far, s);
      }
      corners[static_cast<std::size_t>(n) + 1].insert(
          corners[static_cast<std::size_t>(n) + 1].end(), {{near, 0}, {far, 0}});
    } else {
      const auto& rrp = std::get<Rrp<double>>(mechanism.dyads[i]);
      joints.push_back({{rrp.point, {n, {0, 0}}}});
      joints.push_back({{{n, {rrp.length, 0}}, {n + 1, {0, 0}}}});
      owner[static_cast<std::size_t>(n) + 1] = -1;
    }
  }
  for (const Joint& joint : joints) {
    for (const auto& place : joint.places) {
      corners[static_cast<std::size_t>(place.body)].push_back(place.at);
    }
  }
  for (const auto& point : mechanism_.points) {
    corners[static_cast<std::size_t>(point.at.body)].push_back(point.at.at);
  }
  for (std::size_t body = 1; body < bodies; ++body) {
    if (owner[body] != static_cast<int>(body)) continue;
    double width = sizes.link_width;
    for (const auto& own : sizes.widths) {
      if (own.link == mechanism_.bodies[body]) width = own.width;
    }
    links_.push_back(
        {mechanism_.bodies[body], static_cast<int>(body), corners[body], width / 2, {}});
  }
  // Joints that coincide at the second sample are one pin.
  std::vector<Vec2d> seen;
  for (const Joint& joint : joints) {
    const Attached<double>& at = joint.places.front();
    const Pose& pose = samples_[1][static_cast<std::size_t>(at.body)];
    const Vec2d here{pose.x + std::cos(pose.angle) * at.at.x - std::sin(pose.angle) * at.at.y,
                     pose.y + std::sin(pose.angle) * at.at.x + std::cos(pose.angle) * at.at.y};
    std::size_t which = 0;
    while (which < seen.size() &&
           std::hypot(seen[which].x - here.x, seen[which].y - here.y) > 1e-7) {
      ++which;
    }
    if (which == seen.size()) {
      seen.push_back(here);
      pins_.push_back({"", at.body, {at.at}, sizes.pin_diameter / 2, {}});
    }
    for (const auto& place : joint.places) {
      pins_[which].joins.push_back(owner[static_cast<std::size_t>(place.body)]);
    }
  }
}

double BruteLayers::distance(const Part& a, const Part& b, const std::vector<Pose>& at) const {
  const auto placed = [&](const Part& part) {
    const Pose& pose = at[static_cast<std::size_t>(part.body)];
    std::vector<Vec2d> all;
    for (const Vec2d& p : part.corners) {
      all.push_back({pose.x + std::cos(pose.angle) * p.x - std::sin(pose.angle) * p.y,
                     pose.y + std::sin(pose.angle) * p.x + std::cos(pose.angle) * p.y});
    }
    return all;
  };
  return hulls(placed(a), placed(b)) - a.radius - b.radius - clearance_;
}

double BruteLayers::least(const Part& a, const Part& b) const {
  double room = kInfinite;
  for (const auto& at : samples_) room = std::min(room, distance(a, b, at));
  return room;
}

void BruteLayers::measure() {
  const auto table = [&](const std::vector<Part>& rows, const std::vector<Part>& columns) {
    std::vector<std::vector<double>> room;
    for (const Part& a : rows) {
      room.emplace_back();
      for (const Part& b : columns) room.back().push_back(&a == &b ? kInfinite : least(a, b));
    }
    return room;
  };
  link_link_ = table(links_, links_);
  pin_link_ = table(pins_, links_);
  pin_pin_ = table(pins_, pins_);
  for (const Part& pin : pins_) {
    for (std::size_t a = 0; a < links_.size(); ++a) {
      for (std::size_t b = 0; b < links_.size(); ++b) {
        const auto joins = [&](std::size_t link) {
          return std::ranges::find(pin.joins, links_[link].body) != pin.joins.end();
        };
        if (a != b && joins(a) && joins(b)) link_link_[a][b] = -kInfinite;
      }
    }
  }
}

bool BruteLayers::is_allowed(const std::vector<int>& layers) const {
  problems::LayerResult result;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    result.links.push_back({links_[i].name, 0, layers[i]});
  }
  return interference(result) < 0;
}

double BruteLayers::interference(const problems::LayerResult& result) const {
  std::vector<int> layers;
  for (const Part& link : links_) {
    const auto found =
        std::ranges::find(result.links, link.name, &problems::LayerResult::Link::name);
    if (found == result.links.end() || found->layer < 1) return kInfinite;
    layers.push_back(found->layer);
  }
  std::vector<std::pair<int, int>> reach;
  std::vector<std::vector<char>> member;
  for (const Part& pin : pins_) {
    int low = std::numeric_limits<int>::max(), high = 0;
    member.emplace_back(links_.size(), 0);
    for (const int body : pin.joins) {
      if (body < 0) low = 0;
      for (std::size_t i = 0; i < links_.size(); ++i) {
        if (links_[i].body != body) continue;
        low = std::min(low, layers[i]);
        high = std::max(high, layers[i]);
        member.back()[i] = 1;
      }
    }
    reach.emplace_back(low, high);
  }
  return -worst_room(layers, reach, member, link_link_, pin_link_, pin_pin_);
}

std::optional<int> BruteLayers::fewest() const {
  const std::size_t links = links_.size();
  for (int count = 1; count <= static_cast<int>(links); ++count) {
    std::vector<int> layers(links, 1);
    for (;;) {
      if (is_allowed(layers)) return count;
      std::size_t digit = 0;
      while (digit < links && layers[digit] == count) layers[digit++] = 1;
      if (digit == links) break;
      ++layers[digit];
    }
  }
  return std::nullopt;
}

bool BruteLayers::confirms(const problems::LayerConflict& conflict, double slack) const {
  if (conflict.first_is_pin || conflict.second_is_pin || !conflict.drive) return true;
  const auto first = std::ranges::find(links_, conflict.first, &Part::name);
  const auto second = std::ranges::find(links_, conflict.second, &Part::name);
  if (first == links_.end() || second == links_.end()) return false;
  if (distance(*first, *second, poses(*conflict.drive)) > slack) return false;
  for (std::size_t i = 0; i < samples_.size() && drives_[i] < *conflict.drive; ++i) {
    if (distance(*first, *second, samples_[i]) < -slack) return false;
  }
  return true;
}

}  // namespace cognate::test
