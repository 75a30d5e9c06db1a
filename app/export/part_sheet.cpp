#include "app/export/part_sheet.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/hull_distance.hpp"
#include "app/export/link_parts.hpp"

namespace cognate::app {
namespace {

/// The lower left corner of a line of text and its height.
struct PartLabel {
  Vec2d at{};
  double height = 0;
};

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

/// The greatest height of a part's label, and that of one beside its part.
double label_height(const PartOrder& order) {
  return kHeight * order.width;
}

/// Where `text` can be written along the x axis within `part`, turned by `direction`, clear of its
/// rim, holes and slots: as high as possible, and as near to the middle. Empty where it cannot.
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

constexpr double kAspect = 1.4;  // of the sheet, about

/// The rectangle about a part, turned, with its rim.
struct Box {
  Vec2d low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};
  Vec2d size() const { return high - low; }
};

/// Turns a part's longest side into the x axis.
Vec2d lying(const std::vector<Vec2d>& hull) {
  Vec2d longest{1, 0};
  double most = 0;
  for (const Vec2d& a : hull) {
    for (const Vec2d& b : hull) {
      const double length = norm(b - a);
      if (!(length > most)) continue;
      most = length;
      longest = (1 / length) * (b - a);
    }
  }
  return conj(longest);
}

Box box_of(const LinkPart& part, const Vec2d& direction, double rim) {
  Box box;
  for (const Vec2d& corner : part.hull) {
    const Vec2d at = direction * corner;
    box.low = {std::min(box.low.x, at.x - rim), std::min(box.low.y, at.y - rim)};
    box.high = {std::max(box.high.x, at.x + rim), std::max(box.high.y, at.y + rim)};
  }
  return box;
}

/// Puts boxes into rows from the bottom, the highest first; the places of their lower left corners.
std::vector<Vec2d> rows_of(const std::vector<Box>& boxes, double gap) {
  double area = 0, widest = 0;
  for (const Box& box : boxes) {
    area += (box.size().x + gap) * (box.size().y + gap);
    widest = std::max(widest, box.size().x);
  }
  const double row_width = std::max(widest, kAspect * std::sqrt(area));
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return boxes[i].size().y; });
  std::vector<Vec2d> places(boxes.size());
  Vec2d next{};
  double height = 0;
  for (const std::size_t i : order) {
    const Vec2d size = boxes[i].size();
    if (next.x > 0 && next.x + size.x > row_width) {
      next = {0, next.y + height + gap};
      height = 0;
    }
    places[i] = next;
    next.x += size.x + gap;
    height = std::max(height, size.y);
  }
  return places;
}

class SheetMaker {
 public:
  SheetMaker(const LinkParts& made, const PartLayers& layers, const PartOrder& order)
      : made_(made), layers_(layers), order_(order) {}

  PartSheet make() {
    sheet_.plan.title = "Parts";
    sheet_.plan.layers = {{"OUTLINES"},
                          {"HOLES", PlanColour::red},
                          {"SLOTS", PlanColour::red},
                          {"LABELS", PlanColour::green}};
    lay_out();
    for (std::size_t i = 0; i < made_.parts.size(); ++i) draw(i);
    fit_to_shapes(sheet_.plan);
    return std::move(sheet_);
  }

 private:
  void lay_out() {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < made_.parts.size(); ++i) {
      const LinkPart& part = made_.parts[i];
      const Vec2d direction = lying(part.hull);
      sheet_.places.push_back({{}, direction});
      boxes.push_back(box_of(part, direction, 0.5 * order_.width));
      const std::string text = label_text(i);
      const auto within = label_within(part, direction, order_, text);
      labels_.push_back(within ? *within : label_below(boxes.back(), text));
    }
    const auto corners = rows_of(boxes, order_.gap.value_or(0.5 * order_.width));
    for (std::size_t i = 0; i < boxes.size(); ++i) sheet_.places[i].at = corners[i] - boxes[i].low;
  }

  void draw(std::size_t i) {
    const LinkPart& part = made_.parts[i];
    const PartPlace& place = sheet_.places[i];
    std::vector<Vec2d> hull;
    for (const Vec2d& corner : part.hull) hull.push_back(on_sheet(place, corner));
    add_rounded("OUTLINES", hull, 0.5 * order_.width);
    for (const PartSlot& slot : part.slots) {
      std::vector<Vec2d> way = {on_sheet(place, slot.from)};
      if (norm(slot.to - slot.from) > kOnePlace * norm(slot.from)) {
        way.push_back(on_sheet(place, slot.to));
      }
      add_rounded("SLOTS", way, 0.5 * (order_.hole + order_.clearance));
    }
    for (const PartHole& hole : part.holes) {
      sheet_.plan.circles.push_back({"HOLES", on_sheet(place, hole.at), 0.5 * order_.hole});
    }
    add_label(i);
  }

  void add_rounded(const char* layer, const std::vector<Vec2d>& hull, double distance) {
    if (hull.size() == 1) sheet_.plan.circles.push_back({layer, hull.front(), distance});
    if (hull.size() > 1) sheet_.plan.outlines.push_back(rounded_outline(layer, hull, distance));
  }

  std::string label_text(std::size_t i) const {
    return fmt::format("{} (layer {})", made_.parts[i].name, layers_.layers[i]);
  }

  /// Room for a label below the part of `box`, which becomes greater by it.
  PartLabel label_below(Box& box, const std::string& text) const {
    if (!(box.low.x <= box.high.x)) return {};
    constexpr double kLine = 1.6;  // of the height of a label, with what hangs below it
    const double height = label_height(order_);
    box.low.y -= kLine * height;
    box.high.x = std::max(box.high.x, box.low.x + text_width(text, height));
    return {box.low + Vec2d{0, 0.35 * height}, height};
  }

  void add_label(std::size_t i) {
    const PartLabel& label = labels_[i];
    if (!(label.height > 0)) return;
    sheet_.plan.labels.push_back(
        {"LABELS", sheet_.places[i].at + label.at, label.height, label_text(i)});
  }

  const LinkParts& made_;
  const PartLayers& layers_;
  const PartOrder& order_;
  PartSheet sheet_;
  std::vector<PartLabel> labels_;  ///< of each part, in its turned axes
};

}  // namespace

PartSheet part_sheet(const LinkParts& made, const PartLayers& layers, const PartOrder& order) {
  return SheetMaker(made, layers, order).make();
}

Vec2d on_sheet(const PartPlace& place, const Vec2d& at) {
  return place.at + place.direction * at;
}

}  // namespace cognate::app
