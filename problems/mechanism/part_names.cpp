#include "problems/mechanism/part_names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::size_t kLongestName = 40;
constexpr std::string_view kFit = "expected a name of 1 to 40 letters, digits, - _ . or '";

// How many names a message lists.
constexpr std::size_t kMostListed = 20;

bool is_fit(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.' || c == '\'' || byte >= 0x80;
}

std::vector<std::string_view> body_names(const NamedParts& parts) {
  std::vector<std::string_view> words;
  for (const Body& body : parts.bodies) words.push_back(body.name);
  return words;
}

std::vector<std::string_view> point_names(const NamedParts& parts) {
  std::vector<std::string_view> words;
  for (const PointOnLink& point : parts.points) words.push_back(point.name);
  return words;
}

std::string suggestion(std::string_view word, const std::vector<std::string_view>& known) {
  if (word.size() < 3) return "";  // any letter is near to any other
  const auto meant = nearest(word, known);
  return meant ? ", perhaps for " + in_quotes(*meant) : "";
}

std::optional<Axes> axes_of_one(const PartNames& names, const Mention& mention, FaultList& faults) {
  if (const auto body = names.body(mention.name)) return Axes{.body = *body};
  if (const auto point = names.point(mention.name)) {
    const int body = bearer(names.parts(), names.parts().points[*point]).body;
    if (names.parts().bodies[body].slider) return Axes{.body = body};
    faults.add(
        mention.where,
        fmt::format(
            "{} has the point {}, which is the pin of no slider; expected the name of a body "
            "({}) or two points of one",
            mention.called, in_quotes(mention.name), listed(body_names(names.parts()))));
    return std::nullopt;
  }
  if (names.incomplete || fault_briefly(mention, faults)) return std::nullopt;
  const auto bodies = body_names(names.parts());
  auto known = bodies;
  std::ranges::copy(point_names(names.parts()), std::back_inserter(known));
  faults.add(mention.where,
             fmt::format("{} has {}{}, which is no part of this mechanism; there are the bodies {} "
                         "and the points {}",
                         mention.called, in_quotes(mention.name), suggestion(mention.name, known),
                         listed(bodies), point_list(names)));
  return std::nullopt;
}

std::optional<Axes> axes_of_two(const PartNames& names, const Mention& first, const Mention& second,
                                FaultList& faults) {
  const auto origin = find_point(names, first, faults);
  const auto towards = find_point(names, second, faults);
  if (!origin || !towards) return std::nullopt;
  const PointOnLink& from = names.parts().points[*origin];
  const PointOnLink& to = names.parts().points[*towards];
  const auto body = common_body(from, to);
  if (!body) {
    faults.add(
        second.where,
        fmt::format(
            "{}: no body has both {} (on {}) and {} (on {}); expected two points of one body",
            second.called, in_quotes(from.name), body_list(names.parts(), from.on),
            in_quotes(to.name), body_list(names.parts(), to.on)));
    return std::nullopt;
  }
  const Vec2d start = *place_on(from, *body);
  const Vec2d along = *place_on(to, *body) - start;
  const double distance = std::hypot(along.x, along.y);
  if (!(distance > 0)) {
    faults.add(second.where,
               fmt::format("{}: {} and {} coincide and give no direction; expected two "
                           "different points of one body",
                           second.called, in_quotes(from.name), in_quotes(to.name)));
    return std::nullopt;
  }
  return Axes{*body, start, {along.x / distance, along.y / distance}};
}

}  // namespace

std::string listed(std::vector<std::string_view> words) {
  const bool all = words.size() <= kMostListed;
  if (!all) words.resize(kMostListed);
  return quoted_list(words) + (all ? "" : " and others");
}

PartNames::PartNames(NamedParts parts) : parts_(std::move(parts)) {
  for (std::size_t i = 0; i < parts_.bodies.size(); ++i) {
    bodies_.emplace(parts_.bodies[i].name, static_cast<int>(i));
  }
  for (std::size_t i = 0; i < parts_.points.size(); ++i) {
    points_.emplace(parts_.points[i].name, i);
    announce(parts_.points[i].name);
  }
}

std::optional<std::size_t> PartNames::point(const std::string& name) const {
  const auto found = points_.find(name);
  return found == points_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<int> PartNames::body(const std::string& name) const {
  const auto found = bodies_.find(name);
  return found == bodies_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string_view> PartNames::all_points() const {
  std::vector<std::string_view> names;
  for (const PointOnLink& point : parts_.points) names.push_back(point.name);
  for (const std::string& name : announced_) {
    if (!point(name)) names.emplace_back(name);
  }
  return names;
}

void PartNames::announce(const std::string& point) {
  if (announced_index_.insert(point).second) announced_.push_back(point);
}

void PartNames::add_body(Body body) {
  bodies_.emplace(body.name, static_cast<int>(parts_.bodies.size()));
  parts_.bodies.push_back(std::move(body));
}

void PartNames::place(const std::string& point, const Attached<double>& on) {
  const auto [place, is_new] = points_.emplace(point, parts_.points.size());
  if (is_new) parts_.points.push_back({point, {}});
  parts_.points[place->second].on.push_back(on);
}

bool check_name(TableReader& table, Where where, std::string_view called, std::string_view name) {
  const bool fit =
      !name.empty() && name.size() <= kLongestName && std::ranges::all_of(name, is_fit);
  if (!fit) table.faults().add(where, fmt::format("{} is {}; {}", called, in_quotes(name), kFit));
  return fit;
}

std::optional<std::string> read_name(TableReader& table, std::string_view key) {
  auto name = table.text(key);
  if (!name || !check_name(table, table.where(key), table.name(key), *name)) return std::nullopt;
  return name;
}

std::optional<std::string> require_name(TableReader& table, std::string_view key,
                                        std::string_view what) {
  if (!table.has(key)) {
    table.fault(key, fmt::format("is missing; expected the name of {}", what));
    return std::nullopt;
  }
  return read_name(table, key);
}

std::optional<Mention> read_mention(TableReader& table, std::string_view key) {
  auto name = table.text(key);
  if (!name) return std::nullopt;
  return Mention{*std::move(name), table.where(key), table.name(key)};
}

std::optional<std::vector<Mention>> read_mentions(TableReader& table, std::string_view key,
                                                  const Count& count) {
  if (count.min <= 1 && table.has_text(key)) return std::vector{*read_mention(table, key)};
  auto texts = table.texts(key, count);
  if (!texts) return std::nullopt;
  std::vector<Mention> mentions;
  for (std::size_t i = 0; i < texts->size(); ++i) {
    mentions.push_back({std::move((*texts)[i]), table.where(key, i), table.name(key)});
  }
  return mentions;
}

void announce(PartNames& names, const Mention& point, FaultList& faults) {
  if (names.is_announced(point.name)) {
    faults.add(point.where,
               fmt::format("{} is {}, which is a point already; expected a name that no other "
                           "point has",
                           point.called, in_quotes(point.name)));
  } else if (names.body(point.name)) {
    faults.add(point.where,
               fmt::format("{} is {}, which is a body; expected a name that no body has",
                           point.called, in_quotes(point.name)));
  }
  names.announce(point.name);
}

void add_body(PartNames& names, const Mention& body, bool slider, std::string_view pin,
              FaultList& faults) {
  if (names.body(body.name)) {
    faults.add(body.where,
               fmt::format("{} is {}, which is a body already; expected a name that no other "
                           "body has: names = [\"...\", \"...\"]",
                           body.called, in_quotes(body.name)));
  } else if (body.name != pin && names.is_announced(body.name)) {
    faults.add(body.where,
               fmt::format("{} is {}, which is a point and not the pin of this body; expected a "
                           "name that no point has",
                           body.called, in_quotes(body.name)));
  }
  names.add_body({body.name, slider});
}

bool fault_briefly(const Mention& mention, FaultList& faults) {
  const bool enough = faults.size() >= FaultList::kMost;
  if (enough) {
    faults.add(mention.where, fmt::format("{} has the unknown name {}; expected a known one",
                                          mention.called, in_quotes(mention.name)));
  }
  return enough;
}

std::optional<std::size_t> find_point(const PartNames& names, const Mention& mention,
                                      FaultList& faults) {
  if (const auto point = names.point(mention.name)) return point;
  if (fault_briefly(mention, faults)) return std::nullopt;
  const auto known = point_names(names.parts());
  if (names.is_announced(mention.name)) {
    if (names.incomplete) return std::nullopt;
    faults.add(mention.where,
               fmt::format("{} has {}, which is placed only later; so far there are {}",
                           mention.called, in_quotes(mention.name), listed(known)));
    return std::nullopt;
  }
  faults.add(
      mention.where,
      fmt::format("{} has {}{}, which is no point of this mechanism; there are {}", mention.called,
                  in_quotes(mention.name), suggestion(mention.name, known), point_list(names)));
  return std::nullopt;
}

std::optional<int> find_body(const PartNames& names, const Mention& mention, FaultList& faults) {
  if (const auto body = names.body(mention.name)) return body;
  if (names.incomplete || fault_briefly(mention, faults)) return std::nullopt;
  const auto known = body_names(names.parts());
  faults.add(
      mention.where,
      fmt::format("{} has {}{}, which is no body of this mechanism; there are {}", mention.called,
                  in_quotes(mention.name), suggestion(mention.name, known), listed(known)));
  return std::nullopt;
}

std::optional<Axes> find_axes(const PartNames& names, const std::vector<Mention>& mentions,
                              FaultList& faults) {
  if (mentions.size() == 2) return axes_of_two(names, mentions[0], mentions[1], faults);
  return axes_of_one(names, mentions[0], faults);
}

Attached<double> bearer(const NamedParts& parts, const PointOnLink& point) {
  for (const auto& place : point.on) {
    if (parts.bodies[place.body].slider && place.at == Vec2d{}) return place;
  }
  return point.on.back();
}

std::string point_list(const PartNames& names) {
  return listed(names.all_points());
}

std::string body_list(const NamedParts& parts, const std::vector<Attached<double>>& places) {
  std::vector<std::string_view> words;
  for (const auto& place : places) words.push_back(parts.bodies[place.body].name);
  return listed(std::move(words));
}

}  // namespace cognate::problems::reading
