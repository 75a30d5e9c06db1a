#include "problems/search/infeasibility.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/linkage_keys.hpp"
#include "synthesis/search/infeasibility.hpp"

namespace cognate::problems {
namespace {

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

/// `value` rounded up to a thousandth or so of `width`, or down where `sense` is −1: what is
/// reported is no tighter than what was tried.
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

/// A number that grows beyond all bounds; `most` is where it stands.
Relaxation of_most(std::string_view key,
                   const std::function<std::optional<double>&(Constraints&)>& most) {
  return {std::string(key),
          [most](Limits& limits, double share) {
            auto& limit = most(limits.constraints);
            if (share < 1) {
              limit = *limit / (1 - share);
            } else {
              limit.reset();
            }
          },
          [most](Limits limits) {
            const double limit = *most(limits.constraints);
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
            // Rounded as others are it would grow: it is given in full.
            const auto& [min, max] = clearance.box;
            return fmt::format("outside [[{}, {}], [{}, {}]]", min.x, min.y, max.x, max.y);
          }};
}

/// What holds over the full turn, which only a turning crank can meet: the class stays.
void add_cycle_limits(const Constraints& constraints, std::vector<Relaxation>& all) {
  for (std::size_t i = 0; i < constraints.clearances.size(); ++i) all.push_back(of_clearance(i));
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    if (!is_limit(constraints.cycle_max[quantity.id])) continue;
    all.push_back(of_most(
        quantity.limit_key, [id = quantity.id](Constraints & of) -> auto& {
          return of.cycle_max[id];
        }));
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
  add_cycle_limits(constraints, all);
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
  const auto key_of = [](std::string_view key) { return "bounds." + std::string(key); };
  for (const LinkKey& link : kLinkKeys) {
    if (bounds.*link.bounds) all.push_back(of_length(key_of(link.key), link.bounds));
  }
  for (const BoundedPlaceKey& place : kPlaceKeys) {
    if (bounds.*place.bounds) all.push_back(of_box(key_of(place.key), place.bounds));
  }
}

class Sentences {
 public:
  explicit Sentences(const Limits& given) : given_(given) {
    add_constraints(given.constraints, all_);
    add_bounds(given.bounds, all_);
  }

  std::vector<std::string> explain(const Feasibility& feasible,
                                   const std::function<bool()>& is_over) const {
    std::vector<char> by_degrees;
    for (const Relaxation& one : all_) by_degrees.push_back(one.limits != nullptr);
    const auto found = synthesis::explain_infeasibility(
        by_degrees,
        [&](std::span<const double> shares) {
          const Limits limits = relaxed(shares);
          return feasible(limits.constraints, limits.bounds);
        },
        is_over);
    return sentences(found);
  }

 private:
  std::vector<std::string> sentences(const synthesis::Infeasibility& found) const {
    using enum synthesis::Infeasibility::Finding;
    std::vector<std::string> ways;
    for (const synthesis::Concession& one : found.ways) ways.push_back(way(one));
    switch (found.finding) {
      case unknown:
        return {};
      case feasible:
        return {
            "Another search from as many starts did find a design that meets every constraint: "
            "more of solve.starts find it."};
      case any_of:
        return {
            fmt::format("No design was found that meets all constraints at once. Any one of these "
                        "changes makes a design possible, by as little as was found: {}.",
                        fmt::join(ways, "; "))};
      case together:
        return {fmt::format(
            "No design was found that meets all constraints at once, and none alone stands "
            "in the way. These changes together make a design possible, by as little as "
            "was found: {}.",
            ways.front())};
    }
    return {};
  }

  Limits relaxed(std::span<const double> shares) const {
    Limits limits = given_;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (shares[i] > 0) all_[i].relax(limits, shares[i]);
    }
    return limits;
  }

  /// What the constraints say once they have given way.
  std::string way(const synthesis::Concession& one) const {
    std::vector<double> shares(all_.size());
    for (const std::size_t i : one.constraints) shares[i] = one.share;
    const Limits limits = relaxed(shares);
    std::vector<std::string> changes;
    for (const std::size_t i : one.constraints) {
      const Relaxation& relaxation = all_[i];
      const bool limited = relaxation.limits && one.share < 1;
      changes.push_back(limited ? fmt::format("{} = {}", relaxation.key, relaxation.limits(limits))
                                : fmt::format("{} given up", relaxation.key));
    }
    return fmt::format("{}", fmt::join(changes, " and "));
  }

  const Limits& given_;
  std::vector<Relaxation> all_;
};

}  // namespace

std::vector<std::string> explain_infeasibility(const Constraints& constraints, const Bounds& bounds,
                                               const Feasibility& feasible,
                                               const std::function<bool()>& is_over) {
  const Limits given{constraints, bounds};
  return Sentences(given).explain(feasible, is_over);
}

double cost_in_positions(const Work& work, const Constraints& constraints) {
  constexpr double kGradient = 2, kIteration = 20, kCycle = 2000;
  const double per_iteration = limits_turn(constraints) ? kCycle : kIteration;
  return static_cast<double>(work.positions) + kGradient * static_cast<double>(work.gradients) +
         per_iteration * static_cast<double>(work.solver_iterations);
}

}  // namespace cognate::problems
