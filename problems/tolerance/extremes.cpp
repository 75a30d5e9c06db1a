#include "problems/tolerance/extremes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "synthesis/tolerance/worst_case.hpp"

namespace cognate::problems {
namespace {

/// A distance that is not exceeded at a station: the farthest corner with the rates in their
/// middles, and what they may be off. Infinite where the box comes to a dead point.
double distance_bound(const AffineMechanism& mechanism, const Response& response,
                      const Station& station, const Vec2d& base,
                      std::span<const synthesis::Interval> box) {
  const auto rates = synthesis::enclosed_rates(mechanism, response, station, box);
  if (!rates) return std::numeric_limits<double>::infinity();
  std::vector<Vec2d> arms;
  Vec2d middle = base;
  double doubt = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const auto& [x, y] = (*rates)[i];
    const Vec2d rate{x.middle(), y.middle()};
    arms.push_back(0.5 * (box[i].high - box[i].low) * rate);
    middle = middle + box[i].middle() * rate;
    const double reach = std::max(-box[i].low, box[i].high);
    doubt += reach * std::hypot(x.radius(), y.radius());
  }
  arms.push_back(middle);
  return synthesis::farthest_corner(std::move(arms)) + doubt;
}

void set_scalars(const AffineMechanism& mechanism, const ToleranceQuestion& question, std::size_t q,
                 std::span<const synthesis::Interval> box, ToleranceFigures& figures) {
  figures.exact = figures.exact_everywhere = false;
  double most = -1;
  for (std::size_t s = 0; s < question.stations.size(); ++s) {
    const auto worst = synthesis::worst_case(mechanism, question.quantities[q].scalar(s),
                                             question.stations[s], box);
    if (!worst || !worst->complete) return;
    PositionFigures& at = figures.positions[s];
    at.low = worst->low;
    at.high = worst->high;
    const double size = std::max(worst->high, -worst->low);
    if (size > most) {
      most = size;
      figures.worst_exact = s;
    }
  }
  figures.exact = figures.exact_everywhere = most >= 0;
}

void set_distances(const AffineMechanism& mechanism, const ToleranceQuestion& question,
                   std::size_t q, std::span<const synthesis::Interval> box,
                   const SensitivityTable& table, ToleranceFigures& figures) {
  const ToleranceQuantity& quantity = question.quantities[q];
  std::vector<std::pair<double, std::size_t>> bounds;
  for (std::size_t s = 0; s < question.stations.size(); ++s) {
    const Vec2d at = table.value(s, q);
    const Vec2d target = quantity.target.empty() ? at : quantity.target[s];
    bounds.emplace_back(
        distance_bound(mechanism, quantity.response, question.stations[s], at - target, box), s);
  }
  std::ranges::stable_sort(bounds, std::greater{}, &std::pair<double, std::size_t>::first);
  double most = -1;
  figures.exact = true;
  for (const auto& [bound, s] : bounds) {
    if (bound <= most) break;
    const Vec2d target = quantity.target.empty() ? table.value(s, q) : quantity.target[s];
    const auto worst =
        synthesis::worst_distance(mechanism, quantity.response, question.stations[s], target, box);
    if (!worst || !worst->complete) {
      figures.exact = false;
      return;
    }
    figures.positions[s].low = 0;
    figures.positions[s].high = worst->high;
    if (worst->high > most) {
      most = worst->high;
      figures.worst_exact = s;
    }
  }
}

}  // namespace

void set_extremes(const AffineMechanism& mechanism, const ToleranceQuestion& question,
                  std::size_t q, std::span<const synthesis::Interval> box,
                  const SensitivityTable& table, ToleranceFigures& figures) {
  if (figures.is_point) {
    set_distances(mechanism, question, q, box, table, figures);
  } else {
    set_scalars(mechanism, question, q, box, figures);
  }
}

}  // namespace cognate::problems
