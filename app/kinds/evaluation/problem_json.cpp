#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"
#include "app/kinds/evaluation/kind.hpp"
#include "problems/basics/names.hpp"
#include "problems/mechanism/mechanism_types.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::AnalysisProblem;
using problems::NamedMechanism;
using problems::to_string;

double degrees_of(const Vec2d& direction) {
  return degrees(std::atan2(direction.y, direction.x));
}

ordered_json names_json(const std::vector<std::string>& names) {
  return names.size() == 1 ? ordered_json(names.front()) : ordered_json(names);
}

ordered_json slide_json(const problems::SlideDescription& slide) {
  ordered_json table = ordered_json::object();
  if (const auto* point = std::get_if<std::string>(&slide.through)) {
    table["through"] = *point;
  } else {
    table["through"] = to_json(std::get<Vec2d>(slide.through));
  }
  table["direction_deg"] = degrees(slide.direction);
  table["offset"] = slide.offset;
  table["on"] = slide.on;
  return table;
}

ordered_json drive_json(const problems::CrankDescription& crank) {
  return {{"at", crank.at}, {"pin", crank.pin}, {"length", crank.length}, {"name", crank.name}};
}

ordered_json drive_json(const problems::SliderDescription& slider) {
  return {{"slide", slide_json(slider.slide)}, {"pin", slider.pin}, {"name", slider.name}};
}

ordered_json dyad_json(const problems::DyadDescription& dyad) {
  using problems::DyadType;
  ordered_json table = {{"type", to_string(dyad.type)}};
  if (!dyad.joins.empty()) table["joins"] = dyad.joins;
  if (!dyad.lengths.empty()) table["lengths"] = dyad.lengths;
  if (dyad.type == DyadType::prp) {
    table["slides"] = ordered_json::array();
    for (const auto& slide : dyad.slides) table["slides"].push_back(slide_json(slide));
  } else if (!dyad.slides.empty()) {
    table["slide"] = slide_json(dyad.slides.front());
  }
  if (dyad.type == DyadType::rpr) table["offset"] = dyad.offset;
  if (dyad.type == DyadType::rpp) table["slot_deg"] = degrees(dyad.slot);
  if (dyad.type != DyadType::prp && dyad.type != DyadType::rpp) {
    table["assembly"] = to_string(dyad.assembly);
  }
  if (!dyad.new_point.empty()) table["new"] = dyad.new_point;
  table["names"] = dyad.names;
  return table;
}

ordered_json point_json(const problems::PointDescription& point) {
  return {{"name", point.name}, {"on", names_json(point.on)}, {"at", to_json(point.at)}};
}

/// The value of one key of a type; null where it has none.
template <class Type>
struct KeyJson {
  const Type& mechanism;

  ordered_json operator()(const problems::PivotsKey<Type>& pivots) const {
    return ordered_json::array(
        {to_json(mechanism.*pivots.first), to_json(mechanism.*pivots.second)});
  }
  ordered_json operator()(const problems::PlaceKey<Type>& place) const {
    return to_json(mechanism.*place.of);
  }
  ordered_json operator()(const problems::DirectionKey<Type>& direction) const {
    return degrees_of(mechanism.*direction.of);
  }
  ordered_json operator()(const problems::InclinationKey<Type>& line) const {
    return degrees_of(mechanism.*line.of);
  }
  ordered_json operator()(const problems::AssemblyKey<Type>& assembly) const {
    return to_string(mechanism.*assembly.of);
  }
  ordered_json operator()(const problems::PointKey<Type>& point) const {
    const auto& at = mechanism.*point.of;
    return at ? to_json(*at) : ordered_json(nullptr);
  }
  /// A length or an offset.
  template <class Number>
  ordered_json operator()(const Number& number) const {
    return mechanism.*number.of;
  }
};

/// What `[mechanism]` says besides its type.
template <class Type>
ordered_json tables_of(const Type& mechanism) {
  ordered_json table = ordered_json::object();
  for (const auto& key : problems::TypeTraits<Type>::kKeys) {
    auto value = std::visit(KeyJson<Type>{mechanism}, key.holds);
    if (!value.is_null()) table[std::string(key.name)] = std::move(value);
  }
  return table;
}

ordered_json tables_of(const problems::ChainDescription& chain) {
  ordered_json table = ordered_json::object();
  table["pivot"] = ordered_json::array();
  for (const auto& pivot : chain.pivots) {
    table["pivot"].push_back({{"name", pivot.name}, {"at", to_json(pivot.at)}});
  }
  const bool turns = std::holds_alternative<problems::CrankDescription>(chain.drive);
  table[turns ? "crank" : "slider"] =
      std::visit([](const auto& drive) { return drive_json(drive); }, chain.drive);
  table["dyad"] = ordered_json::array();
  for (const auto& dyad : chain.dyads) table["dyad"].push_back(dyad_json(dyad));
  return table;
}

ordered_json drive_table(const AnalysisProblem& problem) {
  const auto& drive = problem.drive;
  ordered_json table = {{"speed", drive.rate.speed}, {"acceleration", drive.rate.acceleration}};
  if (std::holds_alternative<DrivingSlider<double>>(problem.mechanism.mechanism.drive)) {
    table["start"] = drive.start;
    table["end"] = drive.end;
  } else {
    table["start_deg"] = degrees(drive.start);
    table["end_deg"] = degrees(drive.end);
  }
  table["steps"] = drive.steps;
  return table;
}

ordered_json output_table(const AnalysisProblem& problem) {
  const auto& wanted = problem.output;
  ordered_json table = {{"position", wanted.position},
                        {"velocity", wanted.velocity},
                        {"acceleration", wanted.acceleration},
                        {"transmission", wanted.transmission},
                        {"curvature", wanted.curvature},
                        {"reactions", wanted.reactions},
                        {"torque", wanted.torque}};
  for (const int index : wanted.points) {
    table["points"].push_back(problem.mechanism.points[static_cast<std::size_t>(index)].name);
  }
  for (const int body : wanted.instant_geometry) {
    table["instant_geometry"].push_back(problem.mechanism.bodies[static_cast<std::size_t>(body)]);
  }
  if (wanted.curve) table["curve"] = true;
  if (wanted.cognates) table["cognates"] = true;
  return table;
}

}  // namespace

ordered_json mechanism_json(const NamedMechanism& mechanism) {
  ordered_json table = {{"type", to_string(mechanism.type())}};
  table.update(std::visit([](const auto& described) { return tables_of(described); },
                          mechanism.description));
  if (mechanism.extra_points.empty()) return table;
  table["point"] = ordered_json::array();
  for (const auto& point : mechanism.extra_points) table["point"].push_back(point_json(point));
  return table;
}

ordered_json links_json(const AnalysisProblem& problem) {
  ordered_json list = ordered_json::array();
  for (std::size_t body = 0; body < problem.inertias.size(); ++body) {
    const auto& inertia = problem.inertias[body];
    if (inertia.mass == 0 && inertia.moment == 0) continue;
    list.push_back({{"name", problem.mechanism.bodies[body]},
                    {"mass", inertia.mass},
                    {"centre", to_json(inertia.centre)},
                    {"inertia", inertia.moment}});
  }
  return list;
}

ordered_json load_json(const AnalysisProblem& problem, const problems::LoadRule& load) {
  const bool slides =
      std::holds_alternative<DrivingSlider<double>>(problem.mechanism.mechanism.drive);
  ordered_json table = {{"on", problem.mechanism.bodies[static_cast<std::size_t>(load.at.body)]},
                        {"at", to_json(load.at.at)},
                        {"force", to_json(load.force)},
                        {"torque", load.torque},
                        {"when", to_string(load.sense)}};
  if (load.between) {
    const auto& [from, to] = *load.between;
    table["when"] = slides ? ordered_json::array({from, to})
                           : ordered_json::array({degrees(from), degrees(to)});
  }
  if (load.within_stroke) {
    table["stroke"] = ordered_json::array({load.within_stroke->first, load.within_stroke->second});
  }
  return table;
}

ordered_json Kind<AnalysisProblem>::to_json(const AnalysisProblem& problem) {
  ordered_json tables = {{"kind", "analysis"}};
  if (!problem.title.empty()) tables["title"] = problem.title;
  tables["mechanism"] = mechanism_json(problem.mechanism);
  tables["drive"] = drive_table(problem);
  tables["output"] = output_table(problem);
  tables["link"] = links_json(problem);
  tables["load"] = ordered_json::array();
  for (const auto& load : problem.loads) tables["load"].push_back(load_json(problem, load));
  tables["gravity"] = app::to_json(problem.gravity);
  return tables;
}

}  // namespace cognate::app
