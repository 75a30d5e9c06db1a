/// @file Values of an expression that a hand types.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "app/report/kernel/sketched.hpp"
#include "problems/toml/expression.hpp"

namespace cognate::page {

nlohmann::ordered_json function_values(const SketchQuestion& question) {
  using namespace problems::reading;
  FaultList faults;
  TableReader reader(question.document, faults);
  reader.know({"kind"});
  const auto text = reader.text("function");
  const auto domain = reader.range("domain", kNumber);
  const auto samples = reader.integer("samples", 2, static_cast<int>(kMostTargets));
  reader.finish();
  constexpr std::string_view kVariables[] = {"x"};
  const auto y = parse_expression(text.value_or(""), kVariables);
  if (!y) faults.add({}, "function " + y.error().message);
  if (!domain || domain->min == domain->max) faults.add({}, "domain is no interval");
  if (!samples) faults.add({}, "samples is no number of values");
  if (!faults.empty()) return faults_json(std::move(faults));
  auto values = nlohmann::ordered_json::array();
  for (int i = 0; i < *samples; ++i) {
    const double share = i / (*samples - 1.0);
    const double x = domain->min + share * (domain->max - domain->min);
    const double value = y->value({&x, 1});
    if (std::isfinite(value)) values.push_back(value);
  }
  if (values.size() == static_cast<std::size_t>(*samples)) return {{"values", std::move(values)}};
  faults.add({}, "function has no value somewhere in its domain");
  return faults_json(std::move(faults));
}

}  // namespace cognate::page
