#include "problems/function/family_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "problems/basics/degrees.hpp"
#include "problems/function/slider_generator.hpp"

namespace cognate::problems {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The lengths that distinguish mechanisms of one type.
struct Dimensions {
  Assembly assembly = Assembly::open;
  std::vector<double> lengths;
};

Dimensions dimensions_of(const Design& design) {
  if (design.mechanism.four_bar()) {
    const FourBar& linkage = *design.mechanism.four_bar();
    const auto links = lengths(linkage);
    return {linkage.assembly, {links.crank, links.coupler, links.rocker, links.frame}};
  }
  if (const auto* m = std::get_if<SliderCrank>(&design.mechanism.description)) {
    return {m->assembly, {m->crank, m->coupler, m->offset}};
  }
  return {};
}

/// How far two rows are apart; lengths count by their logarithms, so that none outweighs others.
double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(std::asinh(a[i]) - std::asinh(b[i]));
  return sum;
}

}  // namespace

bool same_lengths(const Design& a, const Design& b, double tolerance) {
  const Dimensions first = dimensions_of(a), second = dimensions_of(b);
  if (first.assembly != second.assembly) return false;
  double size = 0, off = 0;
  for (std::size_t i = 0; i < first.lengths.size(); ++i) {
    size = std::max({size, std::abs(first.lengths[i]), std::abs(second.lengths[i])});
    off = std::max(off, std::abs(first.lengths[i] - second.lengths[i]));
  }
  return off <= tolerance * size;
}

FamilyTable::FamilyTable(const FunctionProblem& problem, bool input, bool angle)
    : slider_(problem.type == MechanismType::slider_crank), angle_(angle) {
  // The first column is the start that is varied as it was chosen; the mechanism's own may be
  // turned by half a turn against it.
  const std::string varied = angle ? (input ? "chosen_input_start_deg" : "chosen_output_start_deg")
                                   : "chosen_output_start";
  names_ = {varied, "input_start_deg"};
  if (slider_) {
    names_.insert(names_.end(), {"output_start", "crank", "coupler", "offset"});
  } else {
    names_.insert(names_.end(), {"output_start_deg", "crank", "coupler", "rocker", "frame"});
  }
  names_.insert(names_.end(),
                {"transmission_angle_deg_acute_min", slider_ ? "max_error" : "max_error_deg"});
}

FamilyTable::Row FamilyTable::row_of(const Design& design) const {
  Row row{degrees(design.metrics.input_start.value_or(0))};
  if (slider_) {
    row.push_back(find_quantity(design.metrics.quantities, kSliderStartKey).value_or(0));
  } else {
    row.push_back(degrees(design.metrics.output_start.value_or(0)));
  }
  for (const double length : dimensions_of(design).lengths) row.push_back(length);
  row.push_back(degrees(design.metrics.transmission_acute_min));
  row.push_back(slider_ ? design.error.max : degrees(design.error.max));
  return row;
}

std::size_t FamilyTable::nearest_table(const Row& row, const std::vector<bool>& taken) const {
  std::size_t nearest = families_.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < families_.size(); ++i) {
    const double apart = distance(row, last_[i]);
    if (taken[i] || !(apart < least)) continue;
    least = apart;
    nearest = i;
  }
  return nearest;
}

void FamilyTable::append(Family& family, double start, const Row& row) const {
  family.columns[0].values.push_back(angle_ ? degrees(start) : start);
  for (std::size_t i = 1; i < family.columns.size(); ++i) {
    family.columns[i].values.push_back(row.empty() ? kNone : row[i - 1]);
  }
}

void FamilyTable::add(double start, const std::vector<const Design*>& designs) {
  std::vector<bool> taken(families_.size(), false);
  for (const Design* design : designs) {
    const Row row = row_of(*design);
    std::size_t i = nearest_table(row, taken);
    if (i == families_.size()) {
      Family family{fmt::format("exact-solution-{}", i + 1), {}};
      for (const std::string& name : names_) family.columns.push_back({name, {}});
      for (const double before : starts_) append(family, before, {});
      families_.push_back(std::move(family));
      last_.push_back(row);
      taken.push_back(false);
    }
    append(families_[i], start, row);
    last_[i] = row;
    taken[i] = true;
  }
  for (std::size_t i = 0; i < families_.size(); ++i) {
    if (!taken[i]) append(families_[i], start, {});
  }
  starts_.push_back(start);
}

}  // namespace cognate::problems
