#include "app/export/part_sheet.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cognate::app {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kText = 0.25;   // of the width of the bars
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
  SheetMaker(const LinkParts& made, const PartPlanes& planes, const PartOrder& order)
      : made_(made), planes_(planes), order_(order) {}

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
    for (const LinkPart& part : made_.parts) {
      sheet_.places.push_back({{}, lying(part.hull)});
      boxes.push_back(box_of(part, sheet_.places.back().direction, 0.5 * order_.width));
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
    add_label(i, hull);
  }

  void add_rounded(const char* layer, const std::vector<Vec2d>& hull, double distance) {
    if (hull.size() == 1) sheet_.plan.circles.push_back({layer, hull.front(), distance});
    if (hull.size() > 1) sheet_.plan.outlines.push_back(rounded_outline(layer, hull, distance));
  }

  /// In the upper half of the bar between the first two corners, beside its holes.
  void add_label(std::size_t i, const std::vector<Vec2d>& hull) {
    if (hull.empty()) return;
    const std::string text = fmt::format("{} (plane {})", made_.parts[i].name, planes_.planes[i]);
    const double height = kText * order_.width;
    const Vec2d middle = 0.5 * (hull.front() + hull[hull.size() > 1 ? 1 : 0]);
    const double half = 0.3 * height * static_cast<double>(text.size());
    sheet_.plan.labels.push_back({"LABELS", middle - Vec2d{half, 0.5 * height}, height, text});
  }

  const LinkParts& made_;
  const PartPlanes& planes_;
  const PartOrder& order_;
  PartSheet sheet_;
};

}  // namespace

PartSheet part_sheet(const LinkParts& made, const PartPlanes& planes, const PartOrder& order) {
  return SheetMaker(made, planes, order).make();
}

Vec2d on_sheet(const PartPlace& place, const Vec2d& at) {
  return place.at + place.direction * at;
}

}  // namespace cognate::app
