#include "problems/straight_line/read_raster.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "problems/linkage/linkage_keys.hpp"
#include "problems/linkage/read_raster.hpp"
#include "problems/raster/keys.hpp"
#include "problems/raster/read.hpp"
#include "problems/straight_line/model.hpp"
#include "problems/straight_line/placing.hpp"
#include "problems/straight_line/raster.hpp"

namespace cognate::problems::reading {
namespace {

/// Boxes that are examined where the file does not say: each takes a tenth of a second.
constexpr int kSegmentBoxes = 500;

constexpr std::string_view kFourBarKeys[] = {"length", "crank", "coupler",
                                             "rocker", "frame", "coupler_point"};
constexpr std::string_view kSliderKeys[] = {"length", "crank", "coupler", "offset",
                                            "coupler_point"};

std::string_view refusal_of(const StraightLineProblem& problem) {
  if (wants_front(problem)) {
    return "is given with neither target.length nor a deviation, for which a front is searched; "
           "add one of them";
  }
  if (limits_place(problem)) {
    return "is given with target.ends and limits of where the linkage stands beside them, which "
           "dimensions on a raster do not meet; remove these limits or the ends";
  }
  const Given& given = problem.given;
  if (problem.goal->direction && (given.frame_angle || (given.pivot_a && given.pivot_d))) {
    return "is given with the directions of line and frame, which dimensions on a raster do not "
           "meet; remove target.direction_deg or the frame's direction";
  }
  return search_raster_refusal(problem.solve);
}

bool is_slider_crank(const StraightLineProblem& problem) {
  return problem.type == MechanismType::slider_crank;
}

/// Of a link its length, where the file leaves it open; with the bounds of its values.
class OpenDimensions {
 public:
  OpenDimensions(TableReader& document, const StraightLineProblem& problem)
      : document_(document), problem_(problem), bounds_(raster_bounds(problem)) {}

  /// Faults what the raster has no value for; false where it has no dimension to choose.
  bool check() {
    for (const LinkKey& link : kLinkKeys) {
      if (is_open(link)) check_link(link);
    }
    const double farthest = farthest_value();
    if (!problem_.given.coupler_point) {
      const Box& box = *bounds_.coupler_point;
      check("coupler_point", {box.min.x, box.max.x}, problem_.bounds.coupler_point.has_value());
      check("coupler_point", {box.min.y, box.max.y}, problem_.bounds.coupler_point.has_value());
    }
    if (is_slider_crank(problem_) && !problem_.slider_offset) {
      check("offset", {-farthest, farthest}, false);
    }
    return has_any_;
  }

  /// The first dimension on the raster that nothing bounds; empty where all are.
  std::optional<std::string> unbounded() const {
    if (problem_.goal->length) return std::nullopt;
    for (const LinkKey& link : kLinkKeys) {
      if (is_open(link) && problem_.raster->rule(link.key) != nullptr &&
          !(problem_.bounds.*link.bounds)) {
        return std::string(link.key);
      }
    }
    return std::nullopt;
  }

 private:
  bool is_open(const LinkKey& link) const {
    const Given& given = problem_.given;
    if (given.*link.given) return false;
    const bool has_links = link.key == "rocker" || link.key == "frame";
    if (has_links && is_slider_crank(problem_)) return false;
    return link.key != "frame" || !(given.pivot_a && given.pivot_d);
  }

  double farthest_value() const {
    const double reach = bounds_.crank ? bounds_.crank->max : 0;
    return std::max(reach, bounds_.coupler ? bounds_.coupler->max : 0);
  }

  void check_link(const LinkKey& link) {
    const RasterRule* rule = problem_.raster->rule(link.key);
    if (rule == nullptr) return;
    Range range = *(bounds_.*link.bounds);
    // A link of no length is none.
    range.min = std::max(range.min, rule->step ? 0.5 * *rule->step : rule->values.front());
    check(link.key, range, (problem_.bounds.*link.bounds).has_value());
  }

  void check(std::string_view key, const Range& range, bool by_file) {
    if (problem_.raster->rule(key) == nullptr) return;
    has_any_ = true;
    if (by_file) {
      check_raster_values(document_, *problem_.raster, key, {}, range,
                          fmt::format("bounds.{}", key));
    } else if (values_within(*problem_.raster->rule(key), range, range).count() == 0) {
      document_.fault("raster",
                      fmt::format("has no value of {} up to {}, which is as far as the segment's "
                                  "length and constraints.size_over_length_max leave; expected at "
                                  "least one: refine the raster or allow a larger size",
                                  key, range.max));
    }
  }

  TableReader& document_;
  const StraightLineProblem& problem_;
  Bounds bounds_;
  bool has_any_ = false;
};

}  // namespace

void read_straight_line_raster(TableReader& document, StraightLineProblem& problem) {
  const std::span<const std::string_view> keys =
      is_slider_crank(problem) ? std::span<const std::string_view>(kSliderKeys)
                               : std::span<const std::string_view>(kFourBarKeys);
  const std::string_view refusal = refusal_of(problem);
  const bool says_boxes =
      document.contains("raster") && document.table("raster").contains(kRasterBoxesKey);
  problem.raster = read_raster(document, keys, refusal);
  if (!problem.raster || !refusal.empty()) return;
  if (!says_boxes) problem.raster->boxes = kSegmentBoxes;
  OpenDimensions open(document, problem);
  if (const auto key = open.unbounded()) {
    document.fault("raster", fmt::format("has values of {} without end; expected target.length, or "
                                         "bounds.{}, by which the linkage has a size",
                                         *key, *key));
    return;
  }
  if (!open.check()) {
    document.fault("raster", "puts no dimension on a raster that [mechanism] leaves open");
  }
}

void refuse_raster_of_contact(TableReader& document) {
  constexpr std::string_view kRefusal =
      "is given with method = \"exact\", whose conditions dimensions on a raster do not meet; "
      "remove it, or remove method for a search";
  read_raster(document, kFourBarKeys, kRefusal);
}

}  // namespace cognate::problems::reading
