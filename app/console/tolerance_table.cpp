#include "app/console/tolerance_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "problems/basics/length_unit.hpp"

namespace cognate::app {
namespace {

using problems::PositionFigures;
using problems::ToleranceFigures;
using problems::ToleranceResult;

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value + 0.0) : "–";
}

std::string drive(const ToleranceResult& result, std::size_t index) {
  return index < result.drive.size() ? fmt::format("{:.6g}", result.drive[index]) : "–";
}

std::string exact(const ToleranceFigures& figures) {
  if (!figures.exact) return "–";
  const PositionFigures& at = figures.positions[figures.worst_exact];
  if (figures.is_point) return number(at.high);
  return fmt::format("{:+.5g} / {:+.5g}", at.low, at.high);
}

/// Of an error what so many samples do not exceed; of a transmission angle, whose own value counts
/// and whose quantiles descend, what they do not fall below.
std::string quantile(const ToleranceFigures& figures, double share) {
  for (const auto& one : figures.quantiles) {
    if (one.share != share || !std::isfinite(one.error)) continue;
    const bool descends = figures.quantiles.front().error > one.error;
    return (descends ? "≥ " : "") + number(one.error);
  }
  return "–";
}

std::string quantities_text(const ToleranceResult& result, const Screen& screen) {
  Column names{"tolerance of", Align::left, {}}, units{"unit", Align::left, {}};
  Column linear{"worst, linear", Align::right, {}}, exacts{"worst, exact", Align::right, {}};
  Column places{result.drive_slides ? "at slide" : "at crank [deg]", Align::right, {}};
  Column rss{"rss", Align::right, {}}, sigma{"sigma", Align::right, {}};
  Column q99{"q99 of all", Align::right, {}};
  for (const ToleranceFigures& figures : result.quantities) {
    if (figures.positions.empty()) continue;
    const PositionFigures& worst = figures.positions[figures.worst];
    names.cells.push_back(printable(figures.name) + (figures.judged ? " *" : ""));
    units.cells.push_back(figures.angle ? "deg"
                                        : problems::in_length_unit("length", screen.length));
    linear.cells.push_back(number(worst.linear));
    exacts.cells.push_back(exact(figures));
    places.cells.push_back(drive(result, figures.worst));
    rss.cells.push_back(number(worst.rss));
    sigma.cells.push_back(result.assembled > 0 ? number(worst.sigma) : "–");
    q99.cells.push_back(quantile(figures, 0.99));
  }
  if (names.cells.empty()) return {};
  return table_text({names, units, linear, exacts, places, rss, sigma, q99}, screen);
}

std::string contributions_text(const ToleranceResult& result, const Screen& screen) {
  const auto judged = std::ranges::find_if(
      result.quantities, [](const ToleranceFigures& figures) { return figures.judged; });
  if (judged == result.quantities.end()) return {};
  Column names{"dimension", Align::left, {}}, nominal{"nominal", Align::right, {}};
  Column tolerance{"tolerance", Align::right, {}}, rate{"sensitivity", Align::right, {}};
  Column amount{"amount", Align::right, {}}, share{"share [%]", Align::right, {}};
  Column most{"greatest sensitivity", Align::right, {}}, place{"at", Align::right, {}};
  for (const auto& one : judged->contributions) {
    const auto found =
        std::ranges::find(result.dimensions, one.dimension, &ToleranceResult::Dimension::name);
    names.cells.push_back(printable(one.dimension));
    nominal.cells.push_back(number(found->nominal));
    tolerance.cells.push_back(found->plus == found->minus
                                  ? "±" + number(found->plus)
                                  : fmt::format("+{:.5g}/-{:.5g}", found->plus, found->minus));
    rate.cells.push_back(number(one.sensitivity));
    amount.cells.push_back(number(one.amount));
    share.cells.push_back(fmt::format("{:.1f}", 100 * one.share));
    most.cells.push_back(number(one.largest));
    place.cells.push_back(drive(result, one.largest_at));
  }
  if (names.cells.empty()) return {};
  return table_text({names, nominal, tolerance, rate, amount, share, most, place}, screen);
}

std::string clearances_text(const ToleranceResult& result, const Screen& screen) {
  if (result.clearances.empty()) return {};
  Column names{"pin", Align::left, {}}, radial{"radial clearance", Align::right, {}};
  Column massless{"massless", Align::right, {}}, loaded{"loaded", Align::right, {}};
  for (const auto& pin : result.clearances) {
    names.cells.push_back(printable(pin.joint));
    radial.cells.push_back(number(pin.radial));
    massless.cells.push_back(number(pin.massless));
    loaded.cells.push_back(pin.loaded ? number(*pin.loaded) : "–");
  }
  return table_text({names, radial, massless, loaded}, screen);
}

std::string allocation_text(const ToleranceResult& result, const Screen& screen) {
  if (result.allocation.empty()) return {};
  Column names{"allocated to", Align::left, {}}, tolerance{"tolerance", Align::right, {}};
  Column cost{"cost", Align::right, {}};
  for (const auto& one : result.allocation) {
    names.cells.push_back(printable(one.dimension));
    tolerance.cells.push_back(std::isinf(one.tolerance) ? "any" : "±" + number(one.tolerance));
    cost.cells.push_back(number(one.cost));
  }
  return table_text({names, tolerance, cost}, screen);
}

}  // namespace

std::string tolerance_table(const ToleranceResult& result, const Screen& screen) {
  std::string text = quantities_text(result, screen) + contributions_text(result, screen) +
                     clearances_text(result, screen) + allocation_text(result, screen);
  if (!text.empty()) text += '\n';
  if (result.refused) text += "no figures of tolerances: " + *result.refused + '\n';
  if (result.samples > 0) {
    text +=
        fmt::format("{} samples, {} of them can be assembled", result.samples, result.assembled);
    if (result.yield) {
      text += fmt::format("; yield {:.5g} ± {:.2g}", *result.yield, *result.yield_standard_error);
    }
    text += '\n';
  }
  return text + notes_text(result.notes);
}

}  // namespace cognate::app
