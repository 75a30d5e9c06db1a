#include "app/export/parts/part_sheet.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "app/export/parts/link_parts.hpp"
#include "app/export/parts/nesting.hpp"
#include "app/export/parts/offset_outline.hpp"
#include "app/export/parts/part_labels.hpp"

namespace cognate::app {
namespace {

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

/// `beyond` its outline.
Box box_of(const LinkPart& part, const Vec2d& direction, double beyond) {
  const double rim = part.rim + beyond;
  if (part.hull.empty()) return {{}, {}};
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

/// Turns the least rectangle about a part so that its longer side lies along x.
Vec2d tight(const LinkPart& part) {
  Vec2d best = lying(part.hull);
  double least = kInfinity;
  for (std::size_t i = 0; i < part.hull.size(); ++i) {
    const Vec2d side = part.hull[(i + 1) % part.hull.size()] - part.hull[i];
    if (!(norm(side) > 0)) continue;
    Vec2d direction = conj((1 / norm(side)) * side);
    const Vec2d size = box_of(part, direction, 0).size();
    if (!(size.x * size.y < least * (1 - kEpsilon))) continue;
    least = size.x * size.y;
    best = size.x < size.y ? -perp(direction) : direction;
  }
  return best;
}

/// The area that the outline of a finished part encloses.
double area_of(const LinkPart& part) {
  double twice = 0, around = 0;
  for (std::size_t i = 0; i < part.hull.size(); ++i) {
    const Vec2d &a = part.hull[i], &b = part.hull[(i + 1) % part.hull.size()];
    twice += cross(a, b);
    around += norm(b - a);
  }
  return 0.5 * twice + around * part.rim + kPi * part.rim * part.rim;
}

/// A part as it may lie on a sheet.
struct LaidPart {
  Vec2d direction{1, 0};
  Box box;  ///< with its label
  PartLabel label;
};

/// The same turned by a right angle, an engraved name with it.
LaidPart upright(const LaidPart& lying) {
  LaidPart turned = lying;
  turned.direction = perp(lying.direction);
  turned.box = {{-lying.box.high.y, lying.box.low.x}, {-lying.box.low.y, lying.box.high.x}};
  turned.label.at = perp(lying.label.at);
  turned.label.direction = perp(lying.label.direction);
  return turned;
}

class SheetMaker {
 public:
  SheetMaker(const LinkParts& made, const PartLayers& layers, const PartOrder& order)
      : made_(made),
        layers_(layers),
        order_(order),
        beam_(0.5 * order.kerf),
        gap_(order.gap.value_or(0.5 * order.width)) {
    for (std::size_t i = 0; i < made.parts.size(); ++i) {
      if (!made.parts[i].cylinder) cut_.push_back(i);
    }
    sheet_.places.resize(made.parts.size());
    labels_.resize(made.parts.size());
  }

  tl::expected<PartSheet, std::string> make() {
    sheet_.plan.title = "Parts";
    sheet_.plan.layers = {{"OUTLINES"}, {"HOLES", PlanColour::red}, {"SLOTS", PlanColour::red}};
    if (order_.labels == PartLabels::text) {
      sheet_.plan.layers.push_back({"LABELS", PlanColour::green});
    } else if (order_.labels == PartLabels::stroke) {
      sheet_.plan.layers.push_back({"ENGRAVE", PlanColour::green});
    }
    if (const auto why = order_.sheet ? nest_parts() : lay_in_rows()) return tl::unexpected(*why);
    for (const std::size_t i : cut_) draw(i);
    fit_to_shapes(sheet_.plan);
    return std::move(sheet_);
  }

 private:
  using Refusal = std::optional<std::string>;

  /// The part turned by `direction`, with room for its label.
  LaidPart laid(std::size_t i, const Vec2d& direction) const {
    const LinkPart& part = made_.parts[i];
    LaidPart made{direction, box_of(part, direction, beam_), {}};
    if (order_.labels == PartLabels::none) return made;
    const std::string text = label_text(i);
    const auto within = label_within(part, direction, order_, text);
    made.label = within ? *within : label_below(made.box, text);
    return made;
  }

  void put(std::size_t i, const LaidPart& part, const Vec2d& corner, int sheet) {
    const Vec2d at = corner - part.box.low;
    sheet_.places[i] = {at, part.direction, sheet};
    labels_[i] = part.label;
  }

  Refusal lay_in_rows() {
    std::vector<LaidPart> parts;
    std::vector<Box> boxes;
    for (const std::size_t i : cut_) {
      const LinkPart& part = made_.parts[i];
      parts.push_back(laid(i, part.rim > 0 ? lying(part.hull) : tight(part)));
      boxes.push_back(parts.back().box);
    }
    const auto corners = rows_of(boxes, gap_);
    for (std::size_t k = 0; k < cut_.size(); ++k) put(cut_[k], parts[k], corners[k], 1);
    return std::nullopt;
  }

  /// Why a part is on no sheet; empty where all are.
  Refusal nest_parts() {
    std::vector<std::array<LaidPart, 2>> parts;
    std::vector<NestItem> items;
    double area = 0;
    for (const std::size_t i : cut_) {
      const Vec2d direction = tight(made_.parts[i]);
      const LaidPart flat = laid(i, direction);
      const bool is_text = order_.labels == PartLabels::text;  // which is never turned
      parts.push_back({flat, is_text ? laid(i, perp(direction)) : upright(flat)});
      const Vec2d lying = flat.box.size(), turned = parts.back()[1].box.size();
      items.push_back({{lying, turned}});
      if (!fits_sheet(lying, *order_.sheet) && !fits_sheet(turned, *order_.sheet)) {
        return fmt::format(
            "--sheet: {:.6g}x{:.6g} is too small for the part {}, which takes {:.6g}x{:.6g}{}; "
            "allowed is a larger sheet",
            order_.sheet->x, order_.sheet->y, made_.parts[i].name, lying.x, lying.y,
            order_.labels == PartLabels::none ? "" : " with its label");
      }
      area += area_of(made_.parts[i]);
    }
    const auto nesting = nest(items, *order_.sheet, gap_);
    for (std::size_t k = 0; k < cut_.size(); ++k) {
      const NestPlace& place = nesting->places[k];
      put(cut_[k], parts[k].at(place.choice), place.corner + sheet_corner(place.sheet),
          place.sheet + 1);
    }
    sheet_.sheets = nesting->sheets;
    sheet_.utilisation = area / (nesting->sheets * order_.sheet->x * order_.sheet->y);
    draw_sheets();
    return std::nullopt;
  }

  /// Sheets lie side by side.
  Vec2d sheet_corner(int sheet) const {
    constexpr double kApart = 1.1;
    return {sheet * kApart * order_.sheet->x, 0};
  }

  void draw_sheets() {
    sheet_.plan.layers.push_back({"SHEETS", PlanColour::grey});
    const Vec2d size = *order_.sheet;
    for (int k = 0; k < sheet_.sheets; ++k) {
      const Vec2d low = sheet_corner(k);
      sheet_.plan.outlines.push_back(
          {"SHEETS",
           {{low}, {low + Vec2d{size.x, 0}}, {low + size}, {low + Vec2d{0, size.y}}},
           true});
    }
  }

  void draw(std::size_t i) {
    const LinkPart& part = made_.parts[i];
    const PartPlace& place = sheet_.places[i];
    std::vector<Vec2d> hull;
    for (const Vec2d& corner : part.hull) hull.push_back(on_sheet(place, corner));
    add_rounded("OUTLINES", hull, part.rim + beam_);
    for (const PartSlot& slot : part.slots) {
      std::vector<Vec2d> way = {on_sheet(place, slot.from)};
      if (norm(slot.to - slot.from) > kOnePlace * norm(slot.from)) {
        way.push_back(on_sheet(place, slot.to));
      }
      add_rounded("SLOTS", way, 0.5 * (slot.width - order_.kerf));
    }
    for (const PartHole& hole : part.holes) {
      sheet_.plan.circles.push_back(
          {"HOLES", on_sheet(place, hole.at), 0.5 * (hole.diameter - order_.kerf)});
    }
    if (order_.labels == PartLabels::none) return;
    PartLabel label = labels_[i];
    label.at = place.at + label.at;
    add_label(order_, label, label_text(i), sheet_.plan);
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
    constexpr double kLine = 1.6;  // of the height of a label, with what hangs below it
    const double height = label_height(order_);
    box.low.y -= kLine * height;
    box.high.x = std::max(box.high.x, box.low.x + label_width(order_, text, height));
    return {box.low + Vec2d{0, 0.35 * height}, height};
  }

  const LinkParts& made_;
  const PartLayers& layers_;
  const PartOrder& order_;
  double beam_, gap_;
  std::vector<std::size_t> cut_;  ///< the parts that are not bought
  PartSheet sheet_;
  std::vector<PartLabel> labels_;  ///< of each part, in its turned axes
};

}  // namespace

tl::expected<PartSheet, std::string> part_sheet(const LinkParts& made, const PartLayers& layers,
                                                const PartOrder& order) {
  return SheetMaker(made, layers, order).make();
}

Vec2d part_size(const LinkPart& part) {
  return box_of(part, tight(part), 0).size();
}

Vec2d on_sheet(const PartPlace& place, const Vec2d& at) {
  return place.at + place.direction * at;
}

}  // namespace cognate::app
