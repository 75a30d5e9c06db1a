#include "app/export/part_labels.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "app/export/hull_distance.hpp"

namespace cognate::app {
namespace {

// As shares of the width of the bars.
constexpr double kHeight = 0.25, kClear = 0.1;

/// Heights that are tried, as shares of the greatest.
constexpr std::array kShares = {1.0, 0.85, 0.7};

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
    for (const PartHole& hole : part.holes) holes_.push_back(direction * hole.at);
    for (const PartSlot& slot : part.slots) {
      slots_.push_back({direction * slot.from, direction * slot.to});
    }
    low_ = high_ = hull_.front();
    for (const Vec2d& corner : hull_) {
      low_ = {std::min(low_.x, corner.x), std::min(low_.y, corner.y)};
      high_ = {std::max(high_.x, corner.x), std::max(high_.y, corner.y)};
    }
    const double rim = 0.5 * order.width;
    low_ = low_ - Vec2d{rim, rim};
    high_ = high_ + Vec2d{rim, rim};
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
    const double rim = 0.5 * order_.width - clear_;
    const double hole = 0.5 * order_.hole + clear_;
    const double slot = hole + 0.5 * order_.clearance;
    return std::ranges::all_of(corners,
                               [&](const Vec2d& p) {
                                 return hull_distance({&p, 1}, hull_) <= rim;
                               }) &&
           std::ranges::all_of(holes_,
                               [&](const Vec2d& p) {
                                 return hull_distance({&p, 1}, corners) >= hole;
                               }) &&
           std::ranges::all_of(
               slots_, [&](const auto& way) { return hull_distance(way, corners) >= slot; });
  }

  const PartOrder& order_;
  double clear_;
  std::vector<Vec2d> hull_, holes_;
  std::vector<std::array<Vec2d, 2>> slots_;
  Vec2d middle_{};        ///< of the corners
  Vec2d low_{}, high_{};  ///< of the part with its rim
};

}  // namespace

double label_height(const PartOrder& order) {
  return kHeight * order.width;
}

std::optional<PartLabel> label_within(const LinkPart& part, const Vec2d& direction,
                                      const PartOrder& order, const std::string& text) {
  if (part.hull.empty()) return std::nullopt;
  const Space space(part, direction, order);
  for (const double share : kShares) {
    const double height = share * label_height(order);
    if (const auto at = space.place_for({text_width(text, height), height})) {
      return PartLabel{*at, height};
    }
  }
  return std::nullopt;
}

}  // namespace cognate::app
