#include "app/python/written_dimensions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analysis/mechanism/convert.hpp"
#include "analysis/numbers/angle.hpp"
#include "problems/mechanism/read_whole_mechanism.hpp"
#include "problems/mechanism/write_mechanism.hpp"

namespace cognate::python {
namespace {

using problems::NamedMechanism;
using problems::reading::Array;
using problems::reading::Node;
using problems::reading::Table;

/// Steps as shares of what a number is measured by, so short that lengths stay positive.
constexpr double kShare = 0.015;

/// Of the values at ±1, ±2, ±3 and ±4 steps, the first derivative.
constexpr std::array kWeights = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};

/// A number of the tables, and where it stands.
struct Leaf {
  std::string name;
  Node* node = nullptr;
};

void collect(Node& node, const std::string& name, std::vector<Leaf>& leaves) {
  if (std::holds_alternative<double>(node.value)) leaves.push_back({name, &node});
  if (auto* array = std::get_if<Array>(&node.value)) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      collect((*array)[i], fmt::format("{}[{}]", name, i), leaves);
    }
  }
  if (auto* table = std::get_if<Table>(&node.value)) {
    for (auto& entry : *table) {
      collect(entry.node, name.empty() ? entry.key : name + "." + entry.key, leaves);
    }
  }
}

NamedMechanism read_again(const Table& document) {
  problems::reading::FaultList faults;
  problems::reading::TableReader reader(document, faults);
  problems::reading::TableReader mechanism = reader.table("mechanism");
  auto read = problems::reading::read_whole_mechanism(reader, mechanism);
  if (!read || !faults.empty()) throw std::runtime_error("a fault of Cognate's own: a dimension");
  return std::move(read->mechanism);
}

/// What is differentiated: the mechanism's numbers, then the points' coordinates.
std::vector<double> outputs(const NamedMechanism& mechanism) {
  std::vector<double> all = numbers_of(mechanism.mechanism);
  for (const auto& point : mechanism.points) {
    all.push_back(point.at.at.x);
    all.push_back(point.at.at.y);
  }
  return all;
}

double size_of(const NamedMechanism& mechanism) {
  double size = 0;
  for (const auto& point : mechanism.points) size = std::max(size, norm(point.at.at));
  return size > 0 ? size : 1;
}

/// Whether the number is a link's length, which is above 0.
bool is_length(const std::string& name) {
  std::string key = name.substr(name.rfind('.') + 1);
  key = key.substr(0, key.find('['));
  constexpr std::array kLengths = {"crank", "coupler", "rocker", "length", "lengths"};
  return std::ranges::find(kLengths, key) != kLengths.end();
}

/// How far a number is moved at a time.
double step_of(const Leaf& leaf, double size) {
  if (leaf.name.ends_with("_deg")) return kShare * 180 / kPi;
  return kShare * (is_length(leaf.name) ? std::get<double>(leaf.node->value) : size);
}

Dimension differentiated(const Leaf& leaf, double step, const Table& document, std::size_t points) {
  const double before = std::get<double>(leaf.node->value);
  std::vector<double> rates;
  for (std::size_t k = 0; k < kWeights.size(); ++k) {
    const double away = static_cast<double>(k + 1) * step;
    leaf.node->value = before + away;
    const std::vector<double> above = outputs(read_again(document));
    leaf.node->value = before - away;
    const std::vector<double> below = outputs(read_again(document));
    const double width = (before + away) - (before - away);
    rates.resize(above.size());
    for (std::size_t i = 0; i < rates.size(); ++i) {
      // Of a straight line each difference has the same slope, and the weights sum up to one.
      rates[i] += kWeights[k] * 2 * static_cast<double>(k + 1) * ((above[i] - below[i]) / width);
    }
  }
  leaf.node->value = before;
  Dimension made{leaf.name, {}, {}};
  const auto numbers = static_cast<std::ptrdiff_t>(rates.size() - 2 * points);
  made.numbers.assign(rates.begin(), rates.begin() + numbers);
  for (std::size_t i = static_cast<std::size_t>(numbers); i < rates.size(); i += 2) {
    made.points.push_back({rates[i], rates[i + 1]});
  }
  return made;
}

}  // namespace

std::vector<double> numbers_of(const Mechanism<double>& mechanism) {
  std::vector<double> all;
  convert<double>(mechanism, [&](double x) {
    all.push_back(x);
    return x;
  });
  return all;
}

std::vector<Dimension> written_dimensions(const NamedMechanism& mechanism) {
  problems::reading::TableWriter whole;
  whole.add("mechanism", node(problems::reading::mechanism_writer(mechanism)));
  Table document = whole.take();
  std::vector<Leaf> leaves;
  collect(document.front().node, "", leaves);
  const double size = size_of(mechanism);
  std::vector<Dimension> all;
  for (const Leaf& leaf : leaves) {
    all.push_back(differentiated(leaf, step_of(leaf, size), document, mechanism.points.size()));
  }
  return all;
}

}  // namespace cognate::python
