#include "app/kinds/evaluation/problem_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::AnalysisProblem;
using problems::NamedMechanism;
using problems::to_string;

double degrees_of(const Vec2d& direction) {
  return degrees(std::atan2(direction.y, direction.x));
}

ordered_json pivots(const Vec2d& first, const Vec2d& second) {
  return ordered_json::array({to_json(first), to_json(second)});
}

template <class SliderCrankLike>
ordered_json slider_crank_tables(const SliderCrankLike& mechanism) {
  return {{"pivot", to_json(mechanism.pivot)},
          {"crank", mechanism.crank},
          {"coupler", mechanism.coupler},
          {"offset", mechanism.offset},
          {"direction_deg", degrees_of(mechanism.direction)},
          {"assembly", to_string(mechanism.assembly)}};
}

template <class GuideBarLike>
ordered_json guide_bar_tables(const GuideBarLike& mechanism) {
  return {{"fixed_pivots", pivots(mechanism.pivot_a, mechanism.pivot_c)},
          {"crank", mechanism.crank},
          {"offset", mechanism.offset},
          {"assembly", to_string(mechanism.assembly)}};
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

/// What `[mechanism]` says besides its type.
struct Tables {
  ordered_json operator()(const FourBar& linkage) const {
    auto table = to_json(linkage);
    table.erase("type");
    return table;
  }
  ordered_json operator()(const SliderCrank& mechanism) const {
    return slider_crank_tables(mechanism);
  }
  ordered_json operator()(const FixedBlock& mechanism) const {
    return slider_crank_tables(mechanism);
  }
  ordered_json operator()(const GuideBar& mechanism) const { return guide_bar_tables(mechanism); }
  ordered_json operator()(const OscillatingBlock& mechanism) const {
    return guide_bar_tables(mechanism);
  }
  ordered_json operator()(const ScotchYoke& mechanism) const {
    return {{"pivot", to_json(mechanism.pivot)},
            {"crank", mechanism.crank},
            {"offset", mechanism.offset},
            {"direction_deg", degrees_of(mechanism.direction)},
            {"slot_deg", degrees_of(mechanism.slot)}};
  }
  ordered_json operator()(const TangentGenerator& mechanism) const {
    return {{"pivot", to_json(mechanism.pivot)},
            {"offset", mechanism.offset},
            {"direction_deg", degrees_of(mechanism.direction)}};
  }
  ordered_json operator()(const EllipticTrammel& mechanism) const {
    return {{"centre", to_json(mechanism.centre)},
            {"length", mechanism.length},
            {"direction_deg", degrees_of(mechanism.direction)},
            {"second_line_deg", degrees_of(mechanism.second_line)}};
  }
  ordered_json operator()(const OldhamCoupling& mechanism) const {
    return {{"fixed_pivots", pivots(mechanism.pivot_a, mechanism.pivot_d)},
            {"slot_deg", degrees_of(mechanism.slot)}};
  }
  ordered_json operator()(const problems::ChainDescription& chain) const {
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
};

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
  ordered_json table = {{"type", to_string(mechanism.type)}};
  table.update(std::visit(Tables{}, mechanism.description));
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

ordered_json to_json(const AnalysisProblem& problem) {
  ordered_json tables = {{"kind", "analysis"}};
  if (!problem.title.empty()) tables["title"] = problem.title;
  tables["mechanism"] = mechanism_json(problem.mechanism);
  tables["drive"] = drive_table(problem);
  tables["output"] = output_table(problem);
  tables["link"] = links_json(problem);
  tables["load"] = ordered_json::array();
  for (const auto& load : problem.loads) tables["load"].push_back(load_json(problem, load));
  tables["gravity"] = to_json(problem.gravity);
  return tables;
}

}  // namespace cognate::app
