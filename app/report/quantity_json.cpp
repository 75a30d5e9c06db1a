#include "app/report/quantity_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace cognate::app {

using nlohmann::ordered_json;

ordered_json quantities_json(const std::vector<problems::Quantity>& quantities) {
  ordered_json list = ordered_json::array();
  for (const problems::Quantity& quantity : quantities) {
    const auto* number = std::get_if<double>(&quantity.value);
    const bool known = !number || std::isfinite(*number);
    list.push_back(
        {{"name", quantity.name},
         {"value", known ? std::visit([](const auto& v) { return ordered_json(v); }, quantity.value)
                         : ordered_json(nullptr)}});
  }
  return list;
}

}  // namespace cognate::app
