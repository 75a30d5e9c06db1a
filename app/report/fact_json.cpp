#include "app/report/fact_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace cognate::app {

using nlohmann::ordered_json;

ordered_json facts_json(const std::vector<problems::Fact>& facts) {
  ordered_json list = ordered_json::array();
  for (const problems::Fact& fact : facts) {
    const auto* number = std::get_if<double>(&fact.value);
    const bool known = !number || std::isfinite(*number);
    list.push_back(
        {{"name", fact.name},
         {"value", known ? std::visit([](const auto& v) { return ordered_json(v); }, fact.value)
                         : ordered_json(nullptr)}});
  }
  return list;
}

}  // namespace cognate::app
