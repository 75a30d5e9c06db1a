#include "app/report/quantity_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/drawn_number.hpp"
#include "problems/linkage/constraint_words.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

/// A bound as the page writes it: null on a side where there is none.
struct BoundJson {
  ordered_json operator()(double value) const { return drawn(value); }
  ordered_json operator()(const std::string& text) const { return text; }
  ordered_json operator()(const problems::Range& range) const {
    if (!std::isfinite(range.max)) return {{"min", drawn(range.min)}};
    if (!std::isfinite(range.min)) return {{"max", drawn(range.max)}};
    return {drawn(range.min), drawn(range.max)};
  }
};

}  // namespace

ordered_json constraints_json(const std::vector<problems::ConstraintCheck>& checks) {
  ordered_json list = ordered_json::array();
  for (const auto& check : checks) {
    const problems::ConstraintWords words = problems::words_of(check);
    list.push_back({{"name", check.name},
                    {"label", words.label},
                    {"relation", words.relation},
                    {"unit", words.unit},
                    {"value", std::visit(BoundJson{}, check.value)},
                    {"bound", std::visit(BoundJson{}, check.bound)},
                    {"satisfied", check.satisfied}});
  }
  return list;
}

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
