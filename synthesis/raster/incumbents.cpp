#include "synthesis/raster/incumbents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "analysis/numbers/parallel.hpp"

namespace cognate::synthesis {

RasterIncumbents::RasterIncumbents(const RasterTask& task, const RasterOptions& options)
    : task_(task), options_(options) {}

double RasterIncumbents::objective() const {
  return best_.empty() ? std::numeric_limits<double>::infinity() : best_.front().point.objective;
}

bool RasterIncumbents::meets_all(const RasterPoint& point) const {
  return point.violation <= options_.feasibility && std::isfinite(point.objective) &&
         task_.accepts(point);
}

void RasterIncumbents::consider(const std::vector<RasterNumbers>& all,
                                std::span<const RasterPoint> from) {
  std::vector<RasterNumbers> fresh;
  for (const RasterNumbers& at : all) {
    if (looked_at_.insert(at).second) fresh.push_back(at);
  }
  std::vector<std::vector<RasterPoint>> found(fresh.size());
  parallel_for(static_cast<int>(fresh.size()), options_.threads, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    found[i] = task_.evaluate(fresh[i], from);
  });
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    insert(std::move(fresh[i]), std::move(found[i]));
  }
}

void RasterIncumbents::add(const RasterNumbers& at, std::vector<RasterPoint> points) {
  const auto known = std::ranges::find(best_, at, &Kept::at);
  if (known != best_.end()) {
    points.push_back(std::move(known->point));
    best_.erase(known);
  }
  insert(at, std::move(points));
}

std::optional<RasterPoint> RasterIncumbents::best_of(std::vector<RasterPoint> points) const {
  std::ranges::stable_sort(points, {}, &RasterPoint::objective);
  auto chosen = std::ranges::find_if(points, [&](const auto& point) { return meets_all(point); });
  if (chosen == points.end()) {
    chosen = std::ranges::min_element(points, {}, [&](const RasterPoint& point) {
      return std::max(point.violation, options_.feasibility);
    });
  }
  return chosen == points.end() ? std::nullopt : std::optional(std::move(*chosen));
}

/// Those that are searched in the end, and the designs wanted.
std::size_t RasterIncumbents::capacity() const {
  return std::max(options_.designs, options_.search ? options_.searched : 0);
}

/// Acceptance may cost more than all else: it is asked only of what would be kept.
void RasterIncumbents::insert(RasterNumbers at, std::vector<RasterPoint> points) {
  std::ranges::stable_sort(points, {}, &RasterPoint::objective);
  const bool is_full = best_.size() >= capacity();
  for (RasterPoint& point : points) {
    if (is_full && !(point.objective < best_.back().point.objective)) return;
    if (!meets_all(point)) continue;
    if (is_full) best_.pop_back();
    const auto place = std::ranges::upper_bound(
        best_, point.objective, {}, [](const Kept& kept) { return kept.point.objective; });
    best_.insert(place, {std::move(at), std::move(point)});
    return;
  }
  if (options_.search && !is_full) remember(std::move(at), points);
}

/// Those that violate least, by their objectives.
void RasterIncumbents::remember(RasterNumbers at, const std::vector<RasterPoint>& points) {
  Rejected one{std::move(at), std::numeric_limits<double>::infinity(),
               std::numeric_limits<double>::infinity()};
  const auto rank = [](const Rejected& of) { return std::pair(of.violation, of.objective); };
  for (const RasterPoint& point : points) {
    const double violation = std::max(point.violation, options_.feasibility);
    if (std::pair(violation, point.objective) >= rank(one)) continue;
    one.violation = violation;
    one.objective = point.objective;
  }
  rejected_.insert(std::ranges::upper_bound(rejected_, rank(one), {}, rank), std::move(one));
  if (rejected_.size() > options_.searched) rejected_.pop_back();
}

std::vector<RasterNumbers> RasterIncumbents::neighbours(const RasterNumbers& at) const {
  const auto axes = task_.axes();
  std::vector<RasterNumbers> all;
  const auto moved = [&](const RasterNumbers& from, std::size_t axis, std::int64_t by) {
    RasterNumbers to = from;
    to[axis] += by;
    if (to[axis] < 0 || to[axis] >= axes[axis].values.count()) to.clear();
    return to;
  };
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (const int by : {-1, 1}) {
      const RasterNumbers one = moved(at, i, by);
      if (one.empty()) continue;
      all.push_back(one);
      for (std::size_t k = i + 1; k < axes.size(); ++k) {
        for (const int other : {-1, 1}) {
          RasterNumbers two = moved(one, k, other);
          if (!two.empty()) all.push_back(std::move(two));
        }
      }
    }
  }
  return all;
}

void RasterIncumbents::improve(const std::function<bool()>& is_over) {
  while (!best_.empty() && !is_over()) {
    const double before = objective();
    const std::vector<RasterPoint> from{best_.front().point};
    consider(neighbours(best_.front().at), from);
    if (!(objective() < before)) return;
  }
}

std::vector<RasterNumbers> RasterIncumbents::promising() const {
  std::vector<RasterNumbers> all;
  for (const Kept& kept : best_) all.push_back(kept.at);
  for (const Rejected& rejected : rejected_) all.push_back(rejected.at);
  if (all.size() > options_.searched) all.resize(options_.searched);
  return all;
}

std::vector<RasterPoint> RasterIncumbents::take() {
  std::vector<RasterPoint> all;
  for (Kept& kept : best_) {
    if (all.size() == options_.designs) break;
    all.push_back(std::move(kept.point));
  }
  return all;
}

}  // namespace cognate::synthesis
