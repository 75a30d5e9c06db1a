#include "problems/linkage/cycle/read_operation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "problems/basics/names.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::size_t kMostLoads = 20;
constexpr std::string_view kBetween = "between", kOn = "on", kAt = "at", kRod = "mass_per_length";

constexpr NumberRule kSpeed{[](double x) { return x != 0 && is_quantity(x); },
                            "a speed in rad/s, not 0,"};
constexpr NumberRule kDensity{is_positive_quantity, "a number from 1e-30 to 1e30"};

/// Where the axes of a link begin, given two of its joints; their share of its length is 1 where
/// they begin at its far end.
std::optional<LinkPlace> axes_between(TableReader& table, std::string_view key) {
  const auto names = table.texts(key, {2, 2, "names"});
  if (!names) return std::nullopt;
  constexpr std::array<std::pair<const char*, const char*>, 3> kEnds{
      {{"A", "B"}, {"B", "C"}, {"D", "C"}}};
  for (std::size_t i = 0; i < kEnds.size(); ++i) {
    const auto& [near, far] = kEnds.at(i);
    const auto link = static_cast<MovingLink>(i);
    if ((*names)[0] == near && (*names)[1] == far) return LinkPlace{.link = link};
    if ((*names)[0] == far && (*names)[1] == near) return LinkPlace{.link = link, .share = 1};
  }
  table.fault(
      key, fmt::format("are {} and {}, which are not the joints of one moving link; expected A and "
                       "B, B and C, or C and D",
                       in_quotes((*names)[0]), in_quotes((*names)[1])));
  return std::nullopt;
}

std::optional<LinkPlace> read_axes(TableReader& link) {
  if (link.has("name") == link.has(kBetween)) {
    link.fault(kBetween,
               link.has(kBetween)
                   ? "is given beside name; give one of them"
                   : "is missing; expected two joints of the link, between = [\"B\", \"C\"], or "
                     "its name");
    return std::nullopt;
  }
  if (link.has(kBetween)) return axes_between(link, kBetween);
  const auto named = link.choice<MovingLink>("name");
  return named ? std::optional(LinkPlace{.link = *named}) : std::nullopt;
}

/// `offset` is given in axes that begin at the far end where `axes.share` is 1.
LinkPlace placed(LinkPlace axes, const Vec2d& offset) {
  axes.offset = axes.share > 0 ? -offset : offset;
  return axes;
}

LinkMass read_mass(TableReader& link, const LinkPlace& axes) {
  LinkMass mass;
  const auto centre = link.two("centre", kQuantity, "[u, v]");
  mass.mass = link.number("mass", kMass).value_or(0);
  mass.moment = link.number("inertia", kMass).value_or(0);
  mass.centre = placed(axes, centre ? Vec2d{(*centre)[0], (*centre)[1]} : Vec2d{});
  if (!link.has(kRod)) {
    if (!link.has("mass") && !link.has("inertia")) {
      link.fault(
          "mass",
          "is missing; expected the link's mass, its inertia about the centre of mass, or both, or "
          "mass_per_length of a slender rod");
    }
    if (mass.mass > 0 && !link.has("centre")) {
      link.fault("centre",
                 "is missing; expected the centre of mass [u, v] (the origin at the first point "
                 "named, the first axis towards the second)");
    }
    return mass;
  }
  mass.mass_per_length = link.number(kRod, kDensity).value_or(0);
  for (const std::string_view key : {"mass", "centre", "inertia"}) {
    if (!link.has(key)) continue;
    link.fault(key,
               "is given beside mass_per_length, from which mass, centre and inertia follow; "
               "leave one of them out");
  }
  mass.centre = {.link = axes.link, .share = 0.5};
  return mass;
}

void read_links(TableReader& document, Operation& operation) {
  std::array<bool, 3> given{};
  for (TableReader& link : document.tables("link", {0, given.size(), "links"})) {
    const auto axes = read_axes(link);
    const LinkMass mass = read_mass(link, axes.value_or(LinkPlace{}));
    link.finish();
    if (!axes) continue;
    const auto index = static_cast<std::size_t>(axes->link);
    if (given.at(index)) {
      link.faults().add(link.where(),
                        fmt::format("[[link]] gives {} a second time; expected one table for "
                                    "each link",
                                    in_quotes(to_string(axes->link))));
    }
    given.at(index) = true;
    operation.links.at(index) = mass;
  }
}

/// A joint, the coupler point or a link by name; or, in brackets, two joints of a link.
std::optional<LinkPlace> read_place(TableReader& load, bool has_coupler_point) {
  if (!load.has(kOn)) {
    load.fault(kOn, "is missing; expected \"coupler-point\", \"B\", \"C\" or a link");
    return std::nullopt;
  }
  if (!load.has_text(kOn)) return axes_between(load, kOn);
  std::vector<std::string_view> allowed;
  for (const auto& point : names<MovingPoint>()) allowed.push_back(point.name);
  const std::size_t points = allowed.size();
  for (const auto& link : names<MovingLink>()) allowed.push_back(link.name);
  const auto chosen = load.choice_of(kOn, allowed);
  if (!chosen) return std::nullopt;
  if (*chosen >= points) return LinkPlace{.link = names<MovingLink>()[*chosen - points].value};
  if (load.has(kAt)) {
    load.fault(kAt, fmt::format("is given for the point {}; expected it for a link only",
                                in_quotes(allowed[*chosen])));
  }
  switch (names<MovingPoint>()[*chosen].value) {
    case MovingPoint::b:
      return LinkPlace{.link = MovingLink::crank, .share = 1};
    case MovingPoint::c:
      return LinkPlace{.link = MovingLink::rocker, .share = 1};
    case MovingPoint::coupler_point:
      break;
  }
  if (!has_coupler_point) {
    load.fault(
        kOn,
        "is \"coupler-point\", which this problem does not have; expected \"B\", \"C\" or a link");
  }
  return LinkPlace{.link = MovingLink::coupler, .at_coupler_point = true};
}

/// Of a load on `place`.
LoadSense read_sense(TableReader& load, const std::optional<LinkPlace>& place, bool has_strokes) {
  constexpr std::string_view kWhen = "when";
  if (!load.has(kWhen)) return LoadSense::always;
  if (!load.has_text(kWhen)) {
    load.fault(kWhen,
               "is no word, but loads of a design problem act all the time or in strokes of the "
               "rocker; expected \"always\", \"advance\" or \"return\"");
    return LoadSense::always;
  }
  const LoadSense sense = load.choice<LoadSense>(kWhen).value_or(LoadSense::always);
  if (sense == LoadSense::always) return sense;
  if (place && place->link != MovingLink::rocker) {
    load.fault(kWhen,
               "names a stroke of the rocker, on which the load is not; expected \"always\", or "
               "a load on \"rocker\" or \"C\"");
  } else if (!has_strokes) {
    load.fault(kWhen,
               "names a stroke of the rocker, which needs constraints.class = \"crank-rocker\"; "
               "expected \"always\", or that class");
  }
  return sense;
}

void read_loads(TableReader& document, const OperationUse& use, Operation& operation) {
  for (TableReader& load : document.tables("load", {0, kMostLoads, "loads"})) {
    const auto place = read_place(load, use.has_coupler_point);
    const auto at = load.two(kAt, kQuantity, "[u, v]");
    const Two force = load.two("force", kQuantity, "[fx, fy]").value_or(Two{});
    WorkingLoad rule{.force = {force[0], force[1]}};
    rule.torque = load.number("torque", kQuantity).value_or(0);
    if (!load.has("force") && !load.has("torque")) {
      load.fault("force", "is missing; expected a force [fx, fy], a torque, or both");
    }
    rule.sense = read_sense(load, place, use.has_strokes);
    load.finish();
    if (!place) continue;
    rule.at = at ? placed(*place, {(*at)[0], (*at)[1]}) : *place;
    operation.loads.push_back(rule);
  }
}

bool weighs(const Operation& operation) {
  return std::ranges::any_of(operation.links, [](const LinkMass& link) {
    return link.mass > 0 || link.moment > 0 || link.mass_per_length > 0;
  });
}

/// Of what is given though only the quantities with `has` depend on it.
std::string unused(bool CycleDeclaration::*has) {
  return fmt::format("is given, but no limit depends on it; add {}, or remove it", limit_keys(has));
}

void read_drive(TableReader& document, const OperationUse& use, Operation& operation) {
  constexpr std::string_view kDrive = "drive", kKey = "speed";
  TableReader drive = document.table(kDrive);
  operation.speed = drive.turning_speed(kKey, kSpeed).value_or(operation.speed);
  if (!drive.has_speed(kKey) && use.asked.any(&CycleDeclaration::needs_speed)) {
    const auto words = [](const CycleDeclaration& of) { return std::string(of.words); };
    drive.fault(kKey, fmt::format("is missing; expected the crank's mean speed in rad/s, on which "
                                  "{} depend",
                                  list_of(words, " and ", &CycleDeclaration::needs_speed)));
  }
  drive.finish();
  if (document.has(kDrive) && !use.asked.any()) document.fault(kDrive, unused(nullptr));
}

void read_flywheel(TableReader& document, const OperationUse& use, Operation& operation) {
  constexpr std::string_view kInertia = "inertia", kFluctuation = "fluctuation";
  TableReader flywheel = document.table("flywheel");
  operation.flywheel = flywheel.number(kInertia, kDensity).value_or(0);
  operation.fluctuation = flywheel.number(kFluctuation, kSpeedFluctuation).value_or(0);
  constexpr auto kByInertia = &CycleDeclaration::by_flywheel;
  constexpr auto kByFluctuation = &CycleDeclaration::by_fluctuation;
  const bool asks_inertia = use.asked.any(kByInertia),
             asks_fluctuation = use.asked.any(kByFluctuation);
  if (flywheel.has(kInertia) && !asks_inertia) flywheel.fault(kInertia, unused(kByInertia));
  if (flywheel.has(kFluctuation) && !asks_fluctuation) {
    flywheel.fault(kFluctuation, unused(kByFluctuation));
  }
  if (!flywheel.has(kFluctuation) && asks_fluctuation) {
    flywheel.fault(
        kFluctuation,
        "is missing; expected the fluctuation that the flywheel is to leave, above 0 and below "
        "2");
  }
  flywheel.finish();
}

/// What does without masses and loads that are needed.
void check_bodies(TableReader& document, const OperationUse& use, const Operation& operation) {
  if (!weighs(operation) && operation.loads.empty()) {
    document.fault("link",
                   "is missing, and so is load, without which no torque drives the linkage; "
                   "expected [[link]] with masses or [[load]] with what the constraints or "
                   "objectives say of torque, speed, flywheel or power");
  } else if (use.asked.any(&CycleDeclaration::by_flywheel) && !weighs(operation) &&
             operation.flywheel == 0) {
    document.fault("link",
                   "is missing, and so is flywheel.inertia, without which nothing keeps up the "
                   "speed; expected [[link]] with masses or a flywheel with " +
                       limit_keys(&CycleDeclaration::by_flywheel));
  }
}

}  // namespace

Operation read_operation(TableReader& document, const OperationUse& use) {
  constexpr std::string_view kGravity = "gravity";
  Operation operation;
  read_drive(document, use, operation);
  const std::size_t before = document.faults().size();
  read_flywheel(document, use, operation);
  read_links(document, operation);
  read_loads(document, use, operation);
  const Two gravity = document.two(kGravity, kQuantity, "[x, y]").value_or(Two{});
  operation.gravity = {gravity[0], gravity[1]};

  const bool by_forces = use.asked.any(&CycleDeclaration::by_forces);
  for (const std::string_view key :
       {std::string_view("link"), std::string_view("load"), kGravity}) {
    if (by_forces || !document.has(key)) continue;
    document.fault(key, unused(&CycleDeclaration::by_forces));
  }
  const bool sound = document.faults().size() == before;
  if (by_forces && sound) check_bodies(document, use, operation);
  return operation;
}

}  // namespace cognate::problems::reading
