#include "app/export/parts/part_labels.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "analysis/numbers/hull_distance.hpp"
#include "app/export/parts/stroke_font.hpp"

namespace cognate::app {
namespace {

// As shares of the width of the bars.
constexpr double kHeight = 0.25, kClear = 0.1;

/// Heights that are tried, as shares of the greatest; an engraver writes smaller than CAD shows.
constexpr std::array kShares = {1.0, 0.85, 0.7, 0.55, 0.4};
constexpr std::size_t kTextShares = 3;

constexpr int kPlacesAcross = 48, kPlacesUp = 24;  // that are tried over the box of a part

/// A part as it lies on the sheet, and where its label may be.
class Space {
 public:
  Space(const LinkPart& part, const Vec2d& direction, const PartOrder& order)
      : order_(order), clear_(kClear * order.width) {
    for (const Vec2d& corner : part.hull) {
      hull_.push_back(direction * corner);
      middle_ = middle_ + (1.0 / static_cast<double>(part.hull.size())) * hull_.back();
    }
    for (const PartHole& hole : part.holes) {
      holes_.push_back({"", direction * hole.at, hole.pin, hole.diameter});
    }
    for (const PartSlot& slot : part.slots) {
      slots_.push_back({direction * slot.from, direction * slot.to});
    }
    rim_ = part.rim;
    low_ = high_ = hull_.front();
    for (const Vec2d& corner : hull_) {
      low_ = {std::min(low_.x, corner.x), std::min(low_.y, corner.y)};
      high_ = {std::max(high_.x, corner.x), std::max(high_.y, corner.y)};
    }
    low_ = low_ - Vec2d{rim_, rim_};
    high_ = high_ + Vec2d{rim_, rim_};
  }

  /// The lower left corner of a free rectangle of this size, nearest to the middle.
  std::optional<Vec2d> place_for(const Vec2d& size) const {
    const Vec2d room = high_ - low_ - size;
    if (room.x < 0 || room.y < 0) return std::nullopt;
    std::optional<Vec2d> best;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kPlacesAcross; ++i) {
      for (int k = 0; k <= kPlacesUp; ++k) {
        const Vec2d at = low_ + Vec2d{room.x * i / kPlacesAcross, room.y * k / kPlacesUp};
        const double distance = norm(at + 0.5 * size - middle_);
        if (distance >= least || !is_free(at, size)) continue;
        least = distance;
        best = at;
      }
    }
    return best;
  }

 private:
  bool is_free(const Vec2d& at, const Vec2d& size) const {
    const std::array<Vec2d, 4> corners = {at, at + Vec2d{size.x, 0}, at + size,
                                          at + Vec2d{0, size.y}};
    const double rim = rim_ - clear_;
    const double slot = 0.5 * (order_.hole + order_.clearance) + clear_;
    return std::ranges::all_of(corners,
                               [&](const Vec2d& p) {
                                 return hull_distance({&p, 1}, hull_) <= rim;
                               }) &&
           std::ranges::all_of(
               holes_,
               [&](const PartHole& hole) {
                 return hull_distance({&hole.at, 1}, corners) >= 0.5 * hole.diameter + clear_;
               }) &&
           std::ranges::all_of(
               slots_, [&](const auto& way) { return hull_distance(way, corners) >= slot; });
  }

  const PartOrder& order_;
  double clear_, rim_ = 0;
  std::vector<Vec2d> hull_;
  std::vector<PartHole> holes_;
  std::vector<std::array<Vec2d, 2>> slots_;
  Vec2d middle_{};        ///< of the corners
  Vec2d low_{}, high_{};  ///< of the part with its rim
};

}  // namespace

double label_height(const PartOrder& order) {
  return kHeight * order.width;
}

double label_width(const PartOrder& order, const std::string& text, double height) {
  return order.labels == PartLabels::stroke ? stroke_width(text, height) : text_width(text, height);
}

std::optional<PartLabel> label_within(const LinkPart& part, const Vec2d& direction,
                                      const PartOrder& order, const std::string& text) {
  if (part.hull.empty()) return std::nullopt;
  const Space space(part, direction, order);
  const bool engraved = order.labels == PartLabels::stroke;
  // What an engraver draws below the line is to be on the part as well.
  const double below = engraved ? kStrokeDescent : 0;
  for (std::size_t i = 0; i < (engraved ? kShares.size() : kTextShares); ++i) {
    const double height = kShares.at(i) * label_height(order);
    const Vec2d size{label_width(order, text, height), (1 + below) * height};
    if (const auto at = space.place_for(size)) {
      return PartLabel{*at + Vec2d{0, below * height}, height};
    }
  }
  return std::nullopt;
}

void add_label(const PartOrder& order, const PartLabel& label, const std::string& text,
               Plan& plan) {
  if (!(label.height > 0)) return;
  if (order.labels == PartLabels::text) {
    plan.labels.push_back({"LABELS", label.at, label.height, text});
    return;
  }
  for (const auto& stroke : strokes_of(text, label.height)) {
    PlanOutline outline{"ENGRAVE", {}, false};
    for (const Vec2d& at : stroke) outline.corners.push_back({label.at + label.direction * at});
    plan.outlines.push_back(std::move(outline));
  }
}

}  // namespace cognate::app
