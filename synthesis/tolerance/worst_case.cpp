#include "synthesis/tolerance/worst_case.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/tolerance/partials.hpp"
#include "synthesis/tolerance/box_extremes.hpp"

namespace cognate::synthesis {
namespace {

constexpr std::size_t kTogether = 4;
/// Tolerances as large as links would take minutes otherwise; usual ones take a dozen.
constexpr BoxOptions kOptions{.boxes = 4000};
using Enclosed = Partials<Interval, kTogether>;

bool is_bounded(const Interval& a) {
  return std::isfinite(a.low) && std::isfinite(a.high) && a.low <= a.high;
}

/// A mechanism at a station as a function of the changes of its dimensions.
class AtStation {
 public:
  AtStation(const AffineMechanism& mechanism, const Response& response, const Station& station)
      : mechanism_(mechanism), response_(response), station_(station) {}

  Vec2d value(std::span<const double> changes) const {
    ChangedMechanism<double> changed(mechanism_.at<double>(changes));
    changed.move_to(station_);
    return changed.value(response_);
  }

  bool rates(std::span<const Interval> box, std::vector<Vec2<Interval>>& rates) const {
    rates.resize(box.size());
    for (std::size_t first = 0; first < box.size(); first += kTogether) {
      if (!some_rates(box, first, rates)) return false;
    }
    return true;
  }

  ResponseType type() const { return response_.type; }

 private:
  bool some_rates(std::span<const Interval> box, std::size_t first,
                  std::vector<Vec2<Interval>>& rates) const {
    std::vector<Enclosed> changes(box.size(), Enclosed(0));
    for (std::size_t i = 0; i < box.size(); ++i) changes[i].value = box[i];
    const std::size_t count = std::min(kTogether, box.size() - first);
    for (std::size_t k = 0; k < count; ++k) changes[first + k].by[k] = Interval(1);
    ChangedMechanism<Enclosed> changed(mechanism_.at<Enclosed>(changes));
    changed.move_to(station_);
    // At 0 a dyad is at a dead point; not a number where one before it is.
    const bool of_closure = response_.type == ResponseType::closure;
    const std::size_t closed = of_closure ? response_.index : changed.closures().size();
    for (std::size_t i = 0; i < closed; ++i) {
      if (!(changed.closures()[i].discriminant.value.low > 0)) return false;
    }
    const Vec2<Enclosed> at = changed.value(response_);
    for (std::size_t k = 0; k < count; ++k) {
      const Vec2<Interval> rate = deviation_rate<Interval>(response_.type, {at.x.value, at.y.value},
                                                           {at.x.by[k], at.y.by[k]});
      if (!is_bounded(rate.x) || !is_bounded(rate.y)) return false;
      rates[first + k] = rate;
    }
    return true;
  }

  const AffineMechanism& mechanism_;
  const Response& response_;
  const Station& station_;
};

/// The deviation of a scalar response.
class ScalarDeviation {
 public:
  ScalarDeviation(const AtStation& at, std::size_t dimensions)
      : at_(at), reference_(at.value(std::vector<double>(dimensions, 0.0))) {}

  double value(std::span<const double> changes) {
    return deviation(at_.type(), at_.value(changes), reference_).x;
  }
  bool slopes(std::span<const Interval> box, std::span<Interval> out) {
    if (!at_.rates(box, rates_)) return false;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = rates_[i].x;
    return true;
  }

 private:
  const AtStation& at_;
  Vec2d reference_;
  std::vector<Vec2<Interval>> rates_;
};

/// The squared distance of a point from a target. Its place over a box is bounded by the mean value
/// form.
class SquaredDistance {
 public:
  SquaredDistance(const AtStation& at, const Vec2d& target) : at_(at), target_(target) {}

  double value(std::span<const double> changes) {
    return squared_norm(at_.value(changes) - target_);
  }
  bool slopes(std::span<const Interval> box, std::span<Interval> out) {
    if (!at_.rates(box, rates_)) return false;
    std::vector<double> middle(box.size());
    for (std::size_t i = 0; i < box.size(); ++i) middle[i] = box[i].middle();
    const Vec2d centre = at_.value(middle);
    Interval x = Interval(centre.x) - Interval(target_.x);
    Interval y = Interval(centre.y) - Interval(target_.y);
    for (std::size_t i = 0; i < box.size(); ++i) {
      const double radius = box[i].radius();
      const Interval change(-radius, radius);
      x = x + rates_[i].x * change;
      y = y + rates_[i].y * change;
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = Interval(2) * (x * rates_[i].x + y * rates_[i].y);
    }
    return true;
  }

 private:
  const AtStation& at_;
  Vec2d target_;
  std::vector<Vec2<Interval>> rates_;
};

}  // namespace

std::optional<WorstCase> worst_case(const AffineMechanism& mechanism, const Response& response,
                                    const Station& station, std::span<const Interval> box) {
  const AtStation at(mechanism, response, station);
  ScalarDeviation deviation(at, box.size());
  const BoxMaximum high = box_maximum(deviation, box, kOptions);
  if (!high.determined) return std::nullopt;
  Negative<ScalarDeviation> negative{deviation};
  const BoxMaximum low = box_maximum(negative, box, kOptions);
  if (!low.determined) return std::nullopt;
  return WorstCase{-low.bound, high.bound, low.complete && high.complete, low.boxes + high.boxes};
}

std::optional<WorstCase> worst_distance(const AffineMechanism& mechanism, const Response& point,
                                        const Station& station, const Vec2d& target,
                                        std::span<const Interval> box) {
  const AtStation at(mechanism, point, station);
  SquaredDistance squared(at, target);
  const BoxMaximum high = box_maximum(squared, box, kOptions);
  if (!high.determined) return std::nullopt;
  return WorstCase{0, std::sqrt(std::max(high.bound, 0.0)), high.complete, high.boxes};
}

std::optional<std::vector<Vec2<Interval>>> enclosed_rates(const AffineMechanism& mechanism,
                                                          const Response& response,
                                                          const Station& station,
                                                          std::span<const Interval> box) {
  std::vector<Vec2<Interval>> rates;
  if (!AtStation(mechanism, response, station).rates(box, rates)) return std::nullopt;
  return rates;
}

Vec2d farthest_corner_place(std::vector<Vec2d> vectors) {
  // On a half plane: the corners are met one after the other as its edge turns.
  for (Vec2d& v : vectors) {
    if (v.y < 0 || (v.y == 0 && v.x < 0)) v = -v;
  }
  std::erase_if(vectors, [](const Vec2d& v) { return !(squared_norm(v) > 0); });
  std::ranges::sort(vectors, [](const Vec2d& a, const Vec2d& b) { return cross(a, b) > 0; });
  Vec2d corner{};
  for (const Vec2d& v : vectors) corner = corner + v;
  Vec2d farthest = corner;
  for (const Vec2d& v : vectors) {
    corner = corner - 2.0 * v;
    if (squared_norm(corner) > squared_norm(farthest)) farthest = corner;
  }
  return farthest;
}

double farthest_corner(std::vector<Vec2d> vectors) {
  return norm(farthest_corner_place(std::move(vectors)));
}

}  // namespace cognate::synthesis
