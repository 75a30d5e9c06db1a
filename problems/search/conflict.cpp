#include "problems/search/conflict.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/error_limit.hpp"

namespace cognate::problems {
namespace {

/// Seconds after which an explanation is given up.
constexpr double kMostSeconds = 30;

struct Limits {
  Constraints constraints;
  Bounds bounds;
};

/// A constraint that can give way: by a share of the way from its limits (0) to none (1), or not by
/// degrees, but altogether.
struct Relaxation {
  std::string key;
  std::function<void(Limits&, double share)> relax;
  std::function<std::string(const Limits&)>
      limits;  ///< as the file would say them; empty: given up
};

/// From `value` out to `away`, which may be infinite.
double moved(double value, double away, double share) {
  if (share >= 1) return away;
  if (std::isfinite(away)) return value + share * (away - value);
  const double reach = share / (1 - share);
  return value + std::copysign(std::max(std::abs(value), 1e-3) * reach, away);
}

Range widened(const Range& range, const Range& most, double share) {
  return {moved(range.min, most.min, share), moved(range.max, most.max, share)};
}

/// `value` rounded up to a thousandth or so of `width`, or down where `sense` is −1: what is told
/// is no tighter than what was tried.
double rounded(double value, double width, int sense) {
  if (!std::isfinite(value) || !std::isfinite(width) || !(width > 0)) return value;
  const double step = std::pow(10, std::floor(std::log10(width)) - 3);
  return sense * std::ceil(sense * value / step) * step;
}

std::string text(const Range& range) {
  const double width = range.max - range.min;
  return fmt::format("[{:.10g}, {:.10g}]", rounded(range.min, width, -1),
                     rounded(range.max, width, 1));
}

Relaxation switched(std::string key, bool Constraints::*flag) {
  return {std::move(key),
          [flag](Limits& limits, double share) {
            if (share > 0) limits.constraints.*flag = false;
          },
          nullptr};
}

Relaxation of_length(std::string key, std::optional<Range> Bounds::*bound) {
  constexpr Range kAnyLength{0, std::numeric_limits<double>::infinity()};
  return {std::move(key),
          [bound, kAnyLength](Limits& limits, double share) {
            auto& range = limits.bounds.*bound;
            range = widened(*range, kAnyLength, share);
          },
          [bound](const Limits& limits) { return text(*(limits.bounds.*bound)); }};
}

/// A length by which to move the sides of a range, of which one may be infinite.
double width_of(double low, double high) {
  constexpr double kLeast = 1e-3;
  if (std::isfinite(high - low)) return std::max(high - low, kLeast);
  return std::max(
      {std::isfinite(low) ? std::abs(low) : 0, std::isfinite(high) ? std::abs(high) : 0, kLeast});
}

/// A rectangle grows about its middle.
Box grown(const Box& box, double share) {
  const double reach = share < 1 ? share / (1 - share) : std::numeric_limits<double>::infinity();
  const auto grow = [&](double& low, double& high) {
    const double by = reach * width_of(low, high);
    low -= by;
    high += by;
  };
  Box all = box;
  grow(all.min.x, all.max.x);
  grow(all.min.y, all.max.y);
  return all;
}

std::string text(const Box& box) {
  const double width = box.max.x - box.min.x, height = box.max.y - box.min.y;
  return fmt::format("[[{:.10g}, {:.10g}], [{:.10g}, {:.10g}]]", rounded(box.min.x, width, -1),
                     rounded(box.min.y, height, -1), rounded(box.max.x, width, 1),
                     rounded(box.max.y, height, 1));
}

Relaxation of_box(std::string key, std::optional<Box> Bounds::*bound) {
  return {std::move(key),
          [bound](Limits& limits, double share) {
            auto& box = limits.bounds.*bound;
            box = grown(*box, share);
          },
          [bound](const Limits& limits) { return text(*(limits.bounds.*bound)); }};
}

/// A number that grows beyond all bounds.
Relaxation of_most(std::string key, std::optional<double> Constraints::*most) {
  return {std::move(key),
          [most](Limits& limits, double share) {
            auto& limit = limits.constraints.*most;
            if (share < 1) {
              limit = *limit / (1 - share);
            } else {
              limit.reset();
            }
          },
          [most](const Limits& limits) {
            const double limit = *(limits.constraints.*most);
            return fmt::format("{:.10g}", rounded(limit, limit, 1));
          }};
}

/// An obstacle shrinks to its middle; given up, it and an envelope are everywhere and nowhere.
Box shrunk(const Box& box, double share) {
  const auto shrink = [&](double& low, double& high) {
    const bool bounded = std::isfinite(high - low);
    const double by =
        bounded ? 0.5 * share * (high - low) : share / (1 - share) * width_of(low, high);
    low += by;
    high -= by;
  };
  Box all = box;
  shrink(all.min.x, all.max.x);
  shrink(all.min.y, all.max.y);
  return all;
}

Relaxation of_clearance(std::size_t index) {
  return {fmt::format("clearance[{}]", index + 1),
          [index](Limits& limits, double share) {
            Clearance& clearance = limits.constraints.clearances.at(index);
            const bool is_given_up = share >= 1 && !clearance.inside;
            clearance.inside = clearance.inside || is_given_up;
            clearance.box =
                clearance.inside ? grown(clearance.box, share) : shrunk(clearance.box, share);
          },
          [index](const Limits& limits) {
            const Clearance& clearance = limits.constraints.clearances.at(index);
            if (clearance.inside) return "inside " + text(clearance.box);
            // Rounded as others are it would grow: it is told in full.
            const auto& [min, max] = clearance.box;
            return fmt::format("outside [[{}, {}], [{}, {}]]", min.x, min.y, max.x, max.y);
          }};
}

/// What holds over the full turn, which only a turning crank can keep to: the class stays.
void add_turn_limits(const Constraints& constraints, std::vector<Relaxation>& all) {
  for (std::size_t i = 0; i < constraints.clearances.size(); ++i) all.push_back(of_clearance(i));
  constexpr std::pair<const char*, std::optional<double> Constraints::*> kMost[] = {
      {"peak_acceleration_max", &Constraints::peak_acceleration_max},
      {"torque_ripple_max", &Constraints::torque_ripple_max},
      {"speed_fluctuation_max", &Constraints::speed_fluctuation_max},
      {"flywheel_inertia_max", &Constraints::flywheel_inertia_max},
      {"motor_power_max", &Constraints::motor_power_max}};
  for (const auto& [key, most] : kMost) {
    if (is_limit(constraints.*most)) all.push_back(of_most(key, most));
  }
}

void add_constraints(const Constraints& constraints, std::vector<Relaxation>& all) {
  if (constraints.required_class && !limits_turn(constraints)) {
    all.push_back({"class",
                   [](Limits& limits, double share) {
                     if (share > 0) limits.constraints.required_class.reset();
                   },
                   nullptr});
  }
  if (constraints.transmission_angle) {
    all.push_back({"transmission_angle_deg",
                   [](Limits& limits, double share) {
                     auto& range = limits.constraints.transmission_angle;
                     range = widened(*range, {0, kPi}, share);
                   },
                   [](const Limits& limits) {
                     const Range& range = *limits.constraints.transmission_angle;
                     return text(Range{degrees(range.min), degrees(range.max)});
                   }});
  }
  if (constraints.link_ratio_max) {
    all.push_back(of_most("link_ratio_max", &Constraints::link_ratio_max));
  }
  if (constraints.time_ratio) {
    all.push_back({"time_ratio",
                   [](Limits& limits, double share) {
                     auto& range = limits.constraints.time_ratio;
                     range = widened(*range, {1, std::numeric_limits<double>::infinity()}, share);
                   },
                   [](const Limits& limits) { return text(*limits.constraints.time_ratio); }});
  }
  if (constraints.error) {
    all.push_back({std::string(to_string(constraints.error->of)),
                   [](Limits& limits, double share) {
                     auto& error = limits.constraints.error;
                     error->max = moved(error->max, std::numeric_limits<double>::infinity(), share);
                   },
                   [](const Limits& limits) {
                     const ErrorLimit& error = *limits.constraints.error;
                     const double most = shown_error(error.of, error.max);
                     return fmt::format("{:.10g}", rounded(most, most, 1));
                   }});
  }
  if (constraints.pivot_region) {
    all.push_back({"pivot_region",
                   [](Limits& limits, double share) {
                     auto& region = limits.constraints.pivot_region;
                     region = grown(*region, share);
                   },
                   [](const Limits& limits) { return text(*limits.constraints.pivot_region); }});
  }
  add_turn_limits(constraints, all);
  if (constraints.no_circuit_defect) {
    all.push_back(switched("no_circuit_defect", &Constraints::no_circuit_defect));
  }
  if (constraints.no_branch_defect) {
    all.push_back(switched("no_branch_defect", &Constraints::no_branch_defect));
  }
  if (constraints.no_extra_loop) {
    all.push_back(switched("no_extra_loop", &Constraints::no_extra_loop));
  }
  if (constraints.no_order_defect) {
    all.push_back(switched("no_order_defect", &Constraints::no_order_defect));
  }
}

void add_bounds(const Bounds& bounds, std::vector<Relaxation>& all) {
  const std::pair<const char*, std::optional<Range> Bounds::*> lengths[] = {
      {"bounds.crank", &Bounds::crank},
      {"bounds.coupler", &Bounds::coupler},
      {"bounds.rocker", &Bounds::rocker},
      {"bounds.frame", &Bounds::frame}};
  for (const auto& [key, bound] : lengths) {
    if (bounds.*bound) all.push_back(of_length(key, bound));
  }
  const std::pair<const char*, std::optional<Box> Bounds::*> boxes[] = {
      {"bounds.pivot_a", &Bounds::pivot_a},
      {"bounds.pivot_d", &Bounds::pivot_d},
      {"bounds.coupler_point", &Bounds::coupler_point}};
  for (const auto& [key, bound] : boxes) {
    if (bounds.*bound) all.push_back(of_box(key, bound));
  }
}

class Conflict {
 public:
  Conflict(const Limits& given, const Feasibility& feasible, const Deadline& deadline)
      : given_(given), feasible_(feasible), deadline_(deadline) {
    add_constraints(given.constraints, all_);
    add_bounds(given.bounds, all_);
  }

  std::vector<std::string> explain() {
    if (all_.empty()) return {};
    if (is_enough({}, 0)) {
      return {
          "Another search from as many starts did find a design that meets every constraint: "
          "more of solve.starts find it."};
    }
    std::vector<std::string> ways;
    for (const Relaxation& one : all_) {
      if (!is_enough({&one}, 1)) continue;
      ways.push_back(way({&one}));
    }
    if (time_is_up()) return {};
    if (!ways.empty()) {
      return {
          fmt::format("No design was found that meets all constraints at once. Any one of these "
                      "changes makes a design possible, by as little as was found: {}.",
                      fmt::join(ways, "; "))};
    }
    const auto together = fewest();
    if (time_is_up() || together.empty()) return {};
    return {
        fmt::format("No design was found that meets all constraints at once, and none alone stands "
                    "in the way. These changes together make a design possible, by as little as "
                    "was found: {}.",
                    way(together))};
  }

 private:
  using Some = std::vector<const Relaxation*>;

  bool time_is_up() const {
    return deadline_.reached() || deadline_.spent() > begin_ + kMostSeconds;
  }

  Limits relaxed(const Some& some, double share) const {
    Limits limits = given_;
    for (const Relaxation* one : some) one->relax(limits, share);
    return limits;
  }

  bool is_enough(const Some& some, double share) const {
    if (time_is_up()) return false;
    const Limits limits = relaxed(some, share);
    return feasible_(limits.constraints, limits.bounds);
  }

  /// What is left of all relaxations when those that are not needed are taken back, one by one.
  Some fewest() const {
    Some needed;
    for (const Relaxation& one : all_) needed.push_back(&one);
    if (all_.empty() || !is_enough(needed, 1)) return {};
    for (const Relaxation& one : all_) {
      Some without = needed;
      std::erase(without, &one);
      if (is_enough(without, 1)) needed = without;
    }
    return needed;
  }

  /// The least share that is enough, and what the constraints say then.
  std::string way(const Some& some) const {
    const bool by_degrees = std::ranges::any_of(some, [](auto* one) { return bool(one->limits); });
    double low = 0, high = 1;
    for (int i = 0; by_degrees && i < 7; ++i) {
      const double middle = 0.5 * (low + high);
      (is_enough(some, middle) ? high : low) = middle;
    }
    const Limits limits = relaxed(some, high);
    std::vector<std::string> changes;
    for (const Relaxation* one : some) {
      const bool limited = one->limits && high < 1;
      changes.push_back(limited ? fmt::format("{} = {}", one->key, one->limits(limits))
                                : fmt::format("{} given up", one->key));
    }
    return fmt::format("{}", fmt::join(changes, " and "));
  }

  const Limits& given_;
  const Feasibility& feasible_;
  const Deadline& deadline_;
  const double begin_ = deadline_.spent();
  std::vector<Relaxation> all_;
};

}  // namespace

std::vector<std::string> explain_conflict(const Constraints& constraints, const Bounds& bounds,
                                          const Feasibility& feasible, const Deadline& deadline) {
  const Limits given{constraints, bounds};
  return Conflict(given, feasible, deadline).explain();
}

}  // namespace cognate::problems
