#include "app/report/study_linkage.hpp"

#include <nlohmann/json.hpp>

#include "problems/read.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

ordered_json place(const Vec2d& point) {
  return {point.x, point.y};
}

ordered_json dimensions(const FourBar& linkage) {
  ordered_json mechanism = {{"fixed_pivots", {place(linkage.pivot_a), place(linkage.pivot_d)}},
                            {"crank", linkage.crank},
                            {"coupler", linkage.coupler},
                            {"rocker", linkage.rocker},
                            {"assembly", linkage.assembly == Assembly::open ? "open" : "crossed"}};
  if (linkage.coupler_point) mechanism["coupler_point"] = place(*linkage.coupler_point);
  return mechanism;
}

/// The number of `file` at `path`, or null.
ordered_json* number_at(ordered_json& file, const problems::KeyPath& path) {
  ordered_json* at = &file;
  for (const auto& step : path) {
    const auto* key = std::get_if<std::string>(&step);
    const auto* index = std::get_if<std::size_t>(&step);
    if (key && at->is_object() && at->contains(*key)) {
      at = &(*at)[*key];
    } else if (index && at->is_array() && *index < at->size()) {
      at = &(*at)[*index];
    } else {
      return nullptr;
    }
  }
  return at->is_number() ? at : nullptr;
}

}  // namespace

std::optional<ordered_json> study_linkage(const problems::Study& study) {
  const auto base = problems::parse_task<problems::AnalysisProblem>(study.base_text);
  if (!base || !base->mechanism.four_bar()) return std::nullopt;
  ordered_json file = {{"mechanism", dimensions(*base->mechanism.four_bar())}};
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    if (ordered_json* number = number_at(file, study.variables[i].path)) {
      *number = {{"variable", i}};
    }
  }
  ordered_json& linkage = file["mechanism"];
  linkage["start"] = base->drive.start;
  return linkage;
}

}  // namespace cognate::app
