#include "app/documents/tolerance_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::PositionFigures;
using problems::ToleranceFigures;
using problems::ToleranceResult;

ordered_json known(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

/// The drive at position `index`.
ordered_json at(const ToleranceResult& result, std::size_t index) {
  return index < result.drive.size() ? ordered_json(result.drive[index]) : ordered_json(nullptr);
}

ordered_json column(const ToleranceFigures& figures, double PositionFigures::*of) {
  ordered_json values = ordered_json::array();
  for (const PositionFigures& position : figures.positions) values.push_back(known(position.*of));
  return values;
}

ordered_json positions_json(const ToleranceResult& result, const ToleranceFigures& figures) {
  ordered_json table = {{"nominal", column(figures, &PositionFigures::nominal)},
                        {"linear", column(figures, &PositionFigures::linear)},
                        {"rss", column(figures, &PositionFigures::rss)}};
  if (figures.exact_everywhere) {
    table["low"] = column(figures, &PositionFigures::low);
    table["high"] = column(figures, &PositionFigures::high);
  }
  if (result.assembled > 0) {
    table["mean"] = column(figures, &PositionFigures::mean);
    table["sigma"] = column(figures, &PositionFigures::sigma);
  }
  return table;
}

ordered_json contributions_json(const ToleranceResult& result, const ToleranceFigures& figures) {
  ordered_json rows = ordered_json::array();
  for (const auto& one : figures.contributions) {
    rows.push_back({{"dimension", one.dimension},
                    {"sensitivity", known(one.sensitivity)},
                    {"amount", known(one.amount)},
                    {"share", known(one.share)},
                    {"largest", known(one.largest)},
                    {"largest_at", at(result, one.largest_at)}});
  }
  return rows;
}

ordered_json figures_json(const ToleranceResult& result, const ToleranceFigures& figures) {
  const PositionFigures& worst = figures.positions[figures.worst];
  ordered_json table = {{"name", figures.name},
                        {"unit", figures.angle ? "deg" : "length"},
                        {"judged", figures.judged},
                        {"linear", known(worst.linear)},
                        {"linear_at", at(result, figures.worst)},
                        {"rss", known(worst.rss)}};
  if (figures.exact) {
    const PositionFigures& exact = figures.positions[figures.worst_exact];
    table["exact"] = {known(exact.low), known(exact.high)};
    table["exact_at"] = at(result, figures.worst_exact);
  }
  table["contributions"] = contributions_json(result, figures);
  if (!figures.quantiles.empty()) {
    table["mean_extreme"] = known(figures.mean_extreme);
    ordered_json& quantiles = table["quantiles"] = ordered_json::array();
    for (const auto& [share, error] : figures.quantiles) {
      quantiles.push_back({{"share", share}, {"error", known(error)}});
    }
  }
  if (!figures.histogram.empty()) {
    table["histogram"] = {{"edges", figures.histogram_edges}, {"counts", figures.histogram}};
  }
  table["positions"] = positions_json(result, figures);
  if (figures.is_point) table["distance"] = true;
  for (const Vec2d& direction : figures.along) table["along"].push_back(to_json(direction));
  return table;
}

ordered_json clearances_json(const ToleranceResult& result) {
  ordered_json rows = ordered_json::array();
  for (const auto& pin : result.clearances) {
    ordered_json row = {{"joint", pin.joint},
                        {"radial", pin.radial},
                        {"massless", known(pin.massless)},
                        {"massless_at", at(result, pin.massless_at)}};
    if (pin.loaded) {
      row["loaded"] = known(*pin.loaded);
      row["loaded_at"] = at(result, pin.loaded_at);
    }
    rows.push_back(row);
  }
  return rows;
}

ordered_json allocation_json(const ToleranceResult& result) {
  ordered_json rows = ordered_json::array();
  for (const auto& [dimension, tolerance, cost] : result.allocation) {
    rows.push_back({{"dimension", dimension}, {"tolerance", known(tolerance)}, {"cost", cost}});
  }
  return {
      {"cost", *result.allocation_cost}, {"error", *result.allocation_error}, {"tolerances", rows}};
}

}  // namespace

ordered_json tolerance_json(const ToleranceResult& result) {
  ordered_json table = ordered_json::object();
  if (result.refused) table["refused"] = *result.refused;
  ordered_json& dimensions = table["dimensions"] = ordered_json::array();
  for (const auto& [name, nominal, plus, minus] : result.dimensions) {
    dimensions.push_back({{"name", name}, {"nominal", nominal}, {"plus", plus}, {"minus", minus}});
  }
  table[result.drive_slides ? "slide" : "crank_deg"] = result.drive;
  ordered_json& quantities = table["quantities"] = ordered_json::array();
  for (const ToleranceFigures& figures : result.quantities) {
    if (!figures.positions.empty()) quantities.push_back(figures_json(result, figures));
  }
  table["samples"] = result.samples;
  table["assembled"] = result.assembled;
  if (result.yield) {
    table["yield"] = *result.yield;
    table["yield_standard_error"] = *result.yield_standard_error;
  }
  if (!result.clearances.empty()) table["clearance"] = clearances_json(result);
  if (result.clearance_linear) table["clearance_linear"] = known(*result.clearance_linear);
  if (result.allocation_cost) table["allocation"] = allocation_json(result);
  table["notes"] = result.notes;
  return table;
}

}  // namespace cognate::app
