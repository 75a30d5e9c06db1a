#include "problems/linkage/warnings.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "analysis/mechanism/joints.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/unit_notes.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warning_keys.hpp"
#include "problems/mechanism/dimensions.hpp"

namespace cognate::problems {
namespace {

constexpr double kNearDeadPoint = 5 * kDegree;
constexpr double kUnlikeLinks = 100, kNearChangePoint = 1e-3;

constexpr std::size_t kMostNumbers = 10;  ///< of designs in one warning

/// A warning of one design, and what it says of all designs that deserve it.
struct Warning {
  std::string of_design, in_general;
};

/// The target of a design, where it came.
TargetExtent placed_at(const TargetExtent& target, const Design& design) {
  if (!design.placement) return target;
  return {design.placement->point(target.centre), design.placement->scale * target.size};
}

/// How far a design reaches: the longest of its lengths and offsets, points on its links included.
double longest_dimension(const Design& design) {
  double longest = 0;
  for (const Dimension& dimension : main_dimensions(design.mechanism)) {
    longest = std::max(longest, std::abs(dimension.value));
  }
  const FourBar* linkage = design.mechanism.four_bar();
  if (linkage && linkage->coupler_point) longest = std::max(longest, norm(*linkage->coupler_point));
  return longest;
}

double longest_link(const Lengths<double>& links) {
  return std::max({links.crank, links.coupler, links.rocker, links.frame});
}

double shortest_link(const Lengths<double>& links) {
  return std::min({links.crank, links.coupler, links.rocker, links.frame});
}

/// The length of the crank over that of the shortest other link; 0 where there is no crank. How far
/// offsets and the points of a chain are out is no length of a link.
double crank_over_shortest(const NamedMechanism& mechanism) {
  auto dimensions = main_dimensions(mechanism);
  if (mechanism.type() == MechanismType::chain) {
    dimensions.resize(dimensions.size() - mechanism.extra_points.size());
  }
  double crank = 0, shortest = std::numeric_limits<double>::infinity();
  for (const Dimension& dimension : dimensions) {
    const double length = std::abs(dimension.value);
    if (dimension.name == "crank") {
      crank = length;
    } else if (dimension.name.find("offset") == std::string::npos && length > 0) {
      shortest = std::min(shortest, length);
    }
  }
  return crank / shortest;
}

/// How far the farthest pin of the frame is from a place.
double farthest_pivot(const Mechanism<double>& mechanism, const Vec2d& place) {
  double farthest = 0;
  for (const Joint& joint : joints(mechanism).joints) {
    if (joint.type != JointType::revolute || joint.at.body != 0) continue;
    farthest = std::max(farthest, norm(joint.at.at - place));
  }
  return farthest;
}

bool has_forces(const Operation& operation) {
  return !operation.loads.empty() || norm(operation.gravity) > 0 ||
         std::ranges::any_of(operation.links, [](const LinkMass& link) {
           return link.mass > 0 || link.moment > 0 || link.mass_per_length > 0;
         });
}

/// Of an angle, what a design that lies on a limit may be beyond it.
constexpr double kRounding = 1e-9;

/// Collects the warnings of one design.
class Judgement {
 public:
  Judgement(const Design& design, const std::optional<TargetExtent>& target,
            const WarningLimits& limits)
      : design_(design), limits_(limits), four_bar_(design.mechanism.four_bar()) {
    if (target) target_ = placed_at(*target, design);
  }

  std::vector<Warning> judge() {
    judge_transmission();
    judge_sizes();
    judge_links();
    judge_condition();
    return std::move(all_);
  }

 private:
  void judge_transmission() {
    const Metrics& metrics = design_.metrics;
    // A design of a type without transmission angles has zeros.
    if (!(metrics.transmission_max > 0)) return;
    const double acute = metrics.transmission_acute_min;
    // A design on the limit is not below it by rounding.
    if (acute >= (1 - kRounding) * limits_.transmission_angle) return;
    if (acute < kNearDeadPoint) {
      constexpr const char* kMeaning =
          "near a dead point: joints carry more than ten times the force transmitted there, and "
          "the output hardly follows; constraints.transmission_angle_deg limits it.";
      add(fmt::format("The transmission angle comes within {:.2g} degrees of 0 or 180, {}",
                      degrees(std::abs(acute)), kMeaning),
          fmt::format("the transmission angle comes within 5 degrees of 0 or 180, {}", kMeaning));
      return;
    }
    const double least = degrees(limits_.transmission_angle);
    constexpr const char* kMeaning =
        "where forces in the joints are large and friction may stop the output; "
        "constraints.transmission_angle_deg limits it.";
    add(fmt::format("The transmission angle falls to {:.3g} degrees, below {:.6g}, {}",
                    degrees(acute), least, kMeaning),
        fmt::format("the transmission angle falls below {:.6g} degrees, {}", least, kMeaning));
  }

  void judge_sizes() {
    if (!target_) return;
    const double times = longest_dimension(design_) / target_->size;
    is_long_ = times > limits_.link_over_target;
    if (is_long_) {
      constexpr const char* kHelp =
          "times as long as the target is large; bounds.length keeps links shorter.";
      add(fmt::format("A link is {:.3g} {}", times, kHelp),
          fmt::format("a link is more than {:.6g} {}", limits_.link_over_target, kHelp));
      return;
    }
    const double away =
        farthest_pivot(design_.mechanism.mechanism, target_->centre) / target_->size;
    if (!(away > limits_.pivot_over_target)) return;
    const bool chain = design_.mechanism.type() == MechanismType::chain;
    const auto help = fmt::format("times the target's size away from it; {} keeps it nearer.",
                                  chain ? "bounds.pivots" : "constraints.pivot_region");
    add(fmt::format("A fixed pivot lies {:.3g} {}", away, help),
        fmt::format("a fixed pivot lies more than {:.6g} {}", limits_.pivot_over_target, help));
  }

  void judge_links() {
    const double times = crank_over_shortest(design_.mechanism);
    const bool has_stump = times > limits_.link_ratio;
    if (has_stump) {
      constexpr const char* kHelp =
          "times as long as the shortest other link, whose joints then hardly have room; "
          "bounds.length keeps links longer.";
      add(fmt::format("The crank is {:.3g} {}", times, kHelp),
          fmt::format("the crank is more than {:.6g} {}", limits_.link_ratio, kHelp));
    }
    if (!four_bar_) return;
    const Lengths<double> links = lengths(*four_bar_);
    const double ratio = longest_link(links) / shortest_link(links);
    const double most = target_ ? kUnlikeLinks : limits_.link_ratio;
    if (!is_long_ && !has_stump && ratio > most) {
      constexpr const char* kHelp =
          "times as long as the shortest; constraints.link_ratio_max limits the ratio.";
      add(fmt::format("The longest link is {:.3g} {}", ratio, kHelp),
          fmt::format("the longest link is more than {:.6g} {}", most, kHelp));
    }
    if (design_.metrics.change_point || !(std::abs(grashof_excess(links)) <= kNearChangePoint)) {
      return;
    }
    constexpr const char* kMeaning =
        "lengths are within a thousandth of a change point, where all links lie on one line: "
        "clearances and tolerances decide there which way the linkage goes on.";
    add(fmt::format("The {}", kMeaning), fmt::format("the {}", kMeaning));
  }

  void judge_condition() {
    const auto& condition = design_.metrics.condition;
    if (!condition || !(*condition > limits_.condition)) return;
    constexpr const char* kMeaning =
        "a small change of what is given changes the dimensions greatly.";
    const std::string number =
        std::isfinite(*condition) ? fmt::format("{:.2g}", *condition) : "unbounded";
    add(fmt::format("The condition number of its equations is {}: {}", number, kMeaning),
        fmt::format("the condition number of the equations is above {:.6g}: {}", limits_.condition,
                    kMeaning));
  }

  void add(std::string of_design, std::string in_general) {
    all_.push_back({std::move(of_design), std::move(in_general)});
  }

  const Design& design_;
  const WarningLimits& limits_;
  const FourBar* four_bar_;
  std::optional<TargetExtent> target_;
  bool is_long_ = false;
  std::vector<Warning> all_;
};

/// The designs of which something is said.
struct WarnedDesigns {
  std::string warning;
  std::vector<std::size_t> numbers;
};

/// "Design 1, 3: the transmission angle …"
std::string sentence_of(WarnedDesigns warned) {
  auto& numbers = warned.numbers;
  const std::string more = numbers.size() > kMostNumbers ? ", …" : "";
  if (numbers.size() > kMostNumbers) numbers.resize(kMostNumbers);
  return fmt::format("Design {}{}: {}", fmt::join(numbers, ", "), more, warned.warning);
}

}  // namespace

std::optional<TargetExtent> extent_of(std::span<const Vec2d> points) {
  TargetExtent extent;
  const double share = 1.0 / static_cast<double>(points.size());
  for (const Vec2d& point : points) extent.centre = extent.centre + share * point;
  for (const Vec2d& point : points) {
    extent.size = std::max(extent.size, 2 * norm(point - extent.centre));
  }
  return extent.size > 0 ? std::optional(extent) : std::nullopt;
}

void add_warnings(const std::optional<TargetExtent>& target, const WarningLimits& limits,
                  Result& result) {
  std::vector<WarnedDesigns> all;
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    Design& design = result.designs[i];
    if (!all_satisfied(design.constraints)) continue;
    for (Warning& warning : Judgement(design, target, limits).judge()) {
      design.warnings.push_back(std::move(warning.of_design));
      auto known = std::ranges::find(all, warning.in_general, &WarnedDesigns::warning);
      if (known == all.end()) known = all.insert(known, {std::move(warning.in_general), {}});
      known->numbers.push_back(i + 1);
    }
  }
  for (WarnedDesigns& warned : all) result.warnings.push_back(sentence_of(std::move(warned)));
}

void note_units(const Operation& operation, std::optional<LengthUnit> unit, Result& result) {
  if (!has_forces(operation)) return;
  const FourBar* best =
      result.designs.empty() ? nullptr : result.designs.front().mechanism.four_bar();
  const double longest = best ? longest_link(lengths(*best)) : 0;
  for (auto& note : unit_notes({unit, operation.gravity, longest})) {
    result.notes.push_back(std::move(note));
  }
}

namespace reading {

WarningLimits read_warnings(TableReader& document) {
  WarningLimits limits;
  TableReader table = document.table("warnings");
  read_keys(table, kWarningKeys, limits);
  table.finish();
  return limits;
}

TableWriter warnings_writer(const WarningLimits& limits) {
  TableWriter table;
  return write_keys(limits, kWarningKeys, table);
}

}  // namespace reading

}  // namespace cognate::problems
