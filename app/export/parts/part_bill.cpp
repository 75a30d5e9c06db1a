#include "app/export/parts/part_bill.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/layers/collisions.hpp"
#include "app/documents/csv.hpp"
#include "app/export/parts/part_sheet.hpp"
#include "app/export/parts/screw_room.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

/// Outside diameters of spacers that are tried, as shares of the way from the pin to the width.
constexpr std::array kSpacerShares = {1.0, 0.75, 0.5, 0.25};

class SpacerFinder {
 public:
  SpacerFinder(const PartMotion& moving, const LinkParts& made, const PartLayers& layers,
               const PartOrder& order)
      : moving_(moving), made_(made), layers_(layers), order_(order) {
    for (const PartPin& pin : made.pins) stacks_.push_back(pin_stack(pin, layers));
    for (const LinkPart& part : made.parts) {
      plates_.push_back({part.link, part.hull, part.rim, part.on_rod});
    }
  }

  /// The greatest outside diameter that fits about all pins; empty where none does, or none is
  /// needed.
  std::optional<double> outside() const {
    for (const double share : kSpacerShares) {
      const double diameter = order_.hole + share * (order_.width - order_.hole);
      if (fits(diameter)) return diameter;
    }
    return std::nullopt;
  }

  bool fits(double diameter) const {
    std::vector<Plate> rings;
    for (const PartPin& pin : made_.pins) {
      rings.push_back({pin.at.body, {pin.at.at}, 0.5 * diameter});
    }
    return pass(rings);
  }

 private:
  static bool shares_layer(const std::vector<int>& a, const std::vector<int>& b) {
    return std::ranges::any_of(a,
                               [&](int layer) { return std::ranges::find(b, layer) != b.end(); });
  }

  bool pass(const std::vector<Plate>& rings) const {
    std::vector<PlatePair> pairs;
    for (std::size_t p = 0; p < rings.size(); ++p) {
      for (std::size_t i = 0; i < plates_.size(); ++i) {
        if (!plates_[i].corners.empty() && shares_layer(stacks_[p].crossed, {layers_.layers[i]})) {
          pairs.push_back({&rings[p], &plates_[i]});
        }
      }
      for (std::size_t q = 0; q < p; ++q) {
        if (shares_layer(stacks_[p].crossed, stacks_[q].crossed)) {
          pairs.push_back({&rings[p], &rings[q]});
        }
      }
    }
    const Collisions found =
        find_collisions(moving_.mechanism, moving_.motion, pairs, order_.apart, moving_.stop);
    return found.complete && std::ranges::all_of(found.pairs, [](const PairPassage& pair) {
             return pair.passage == Passage::free;
           });
  }

  const PartMotion& moving_;
  const LinkParts& made_;
  const PartLayers& layers_;
  const PartOrder& order_;
  std::vector<PinStack> stacks_;
  std::vector<Plate> plates_;
};

class BillMaker {
 public:
  BillMaker(const LinkParts& made, const PartLayers& layers, const PartOrder& order)
      : made_(made), layers_(layers), order_(order) {}

  PartBill make(const SpacerFinder& spacers) {
    for (std::size_t i = 0; i < made_.parts.size(); ++i) add_plate(i);
    for (const SlidingBlock& block : made_.blocks) add_block(block);
    for (const PartPin& pin : made_.pins) add_pin(pin);
    if (!order_.boss) add_spacers(spacers);
    if (order_.washer > 0) add_washers();
    if (order_.bearing) add_bearings();
    return std::move(bill_);
  }

 private:
  void add_plate(std::size_t i) {
    const int layer = layers_.layers[i];
    if (const auto& cylinder = made_.parts[i].cylinder) {
      bill_.rows.push_back({.item = "cylinder",
                            .name = made_.parts[i].name,
                            .layers = {layer},
                            .length = cylinder->least,
                            .stroke = cylinder->greatest - cylinder->least});
      return;
    }
    const Vec2d size = part_size(made_.parts[i]);
    bill_.rows.push_back({.item = "plate",
                          .name = made_.parts[i].name,
                          .layers = {layer},
                          .length = size.x,
                          .width = size.y,
                          .thickness = order_.thickness});
  }

  void add_block(const SlidingBlock& block) {
    bill_.rows.push_back({.item = "block",
                          .name = block.part.name,
                          .layers = {layers_.layers[block.bearer]},
                          .length = order_.block->x,
                          .width = order_.block->y,
                          .thickness = order_.thickness,
                          .bore = order_.hole});
  }

  void add_pin(const PartPin& pin) {
    const PinStack stack = pin_stack(pin, layers_);
    if (order_.screw) {
      add_screw(pin, stack);
      return;
    }
    bill_.rows.push_back({.item = "pin",
                          .name = pin.name,
                          .layers = {stack.low, stack.high},
                          .length = stack_height(stack.high - stack.low + 1, order_),
                          .outside = order_.hole});
  }

  void add_screw(const PartPin& pin, const PinStack& stack) {
    const Screw& screw = *order_.screw;
    const auto [length, beyond, too_long] = screw_of(stack, order_);
    const double own = screw_called(screw.designation)->diameter;
    bill_.rows.push_back({.item = "screw",
                          .name = pin.name,
                          .layers = {stack.low, stack.high},
                          .length = length,
                          .outside = screw.diameter,
                          .standard = fmt::format("ISO 4762 {}x{:.6g}", screw.designation,
                                                  length * own / screw.diameter)});
    bill_.rows.push_back({.item = "nut",
                          .name = pin.name,
                          .layers = {stack.high},
                          .width = screw.nut_width,
                          .thickness = screw.nut_height,
                          .standard = fmt::format("ISO 7040 {}", screw.designation)});
    if (!too_long) return;
    bill_.rows[bill_.rows.size() - 2].standard.clear();
    bill_.notes.push_back(
        fmt::format("no screw {} of ISO 4762 is so long as the stack of {} needs: {:.6g}",
                    screw.designation, pin.name, length));
  }

  void add_spacers(const SpacerFinder& finder) {
    std::vector<std::pair<const PartPin*, PinStack>> crossing;
    for (const PartPin& pin : made_.pins) {
      PinStack stack = pin_stack(pin, layers_);
      if (!stack.crossed.empty()) crossing.emplace_back(&pin, std::move(stack));
    }
    if (crossing.empty()) return;
    const auto outside = finder.outside();
    if (!outside) {
      bill_.notes.push_back(fmt::format(
          "no spacer fits about the pins in the layers that they cross (the pin {} crosses layer "
          "{}): they need shoulders",
          crossing.front().first->name, crossing.front().second.crossed.front()));
      return;
    }
    for (const auto& [pin, stack] : crossing) {
      bill_.rows.push_back({.item = "spacer",
                            .name = pin->name,
                            .quantity = static_cast<int>(stack.crossed.size()),
                            .layers = stack.crossed,
                            .thickness = order_.thickness,
                            .outside = outside,
                            .bore = order_.hole});
    }
  }

  void add_washers() {
    for (const PartPin& pin : made_.pins) {
      const PinStack stack = pin_stack(pin, layers_);
      const auto& screw = order_.screw;
      const int between = static_cast<int>(washer_gaps(pin, made_, layers_, order_).size());
      const int quantity = between + (screw ? 2 : 0);
      if (quantity == 0) continue;
      BillRow row{.item = "washer",
                  .name = pin.name,
                  .quantity = quantity,
                  .layers = {stack.low, stack.high},
                  .thickness = order_.washer,
                  .bore = screw ? screw->hole : order_.hole};
      if (order_.washer_outside > 0) row.outside = order_.washer_outside;
      if (screw) row.standard = "ISO 7089 " + std::string(screw->designation);
      bill_.rows.push_back(std::move(row));
    }
  }

  void add_bearings() {
    const Bearing& bearing = *order_.bearing;
    int count = 0;
    for (const PartPin& pin : made_.pins) count += pin.bearings;
    bill_.rows.push_back({.item = "bearing",
                          .name = std::string(bearing.designation),
                          .quantity = count,
                          .thickness = bearing.width,
                          .outside = bearing.outside,
                          .bore = bearing.bore,
                          .standard = "ISO 15"});
    const double room = order_.thickness.value_or(bearing.width) + order_.washer;
    if (bearing.width > room * (1 + 1e-9)) {
      bill_.notes.push_back(fmt::format(
          "the bearing {} is {:.6g} wide, more than a layer with its washer: it would stand in the "
          "next layer",
          bearing.designation, bearing.width));
    }
  }

  const LinkParts& made_;
  const PartLayers& layers_;
  const PartOrder& order_;
  PartBill bill_;
};

/// "2", of several the range: "1-3".
std::string layers_text(const BillRow& row) {
  if (row.layers.empty()) return "";
  const int low = row.layers.front(), high = row.layers.back();
  return low == high ? fmt::format("{}", low) : fmt::format("{}-{}", low, high);
}

using Length = std::pair<const char*, std::optional<double> BillRow::*>;
constexpr std::array<Length, 6> kLengths = {{{"length", &BillRow::length},
                                             {"width", &BillRow::width},
                                             {"thickness", &BillRow::thickness},
                                             {"outside", &BillRow::outside},
                                             {"bore", &BillRow::bore},
                                             {"stroke", &BillRow::stroke}}};

}  // namespace

PinStack pin_stack(const PartPin& pin, const PartLayers& layers) {
  std::vector<int> held;
  for (const int part : pin.parts) held.push_back(layers.layers[static_cast<std::size_t>(part)]);
  if (held.empty()) return {};
  PinStack stack{*std::ranges::min_element(held), *std::ranges::max_element(held), {}};
  for (int layer = stack.low + 1; layer < stack.high; ++layer) {
    if (std::ranges::find(held, layer) == held.end()) stack.crossed.push_back(layer);
  }
  return stack;
}

std::vector<int> washer_gaps(const PartPin& pin, const LinkParts& made, const PartLayers& layers,
                             const PartOrder& order) {
  std::vector<int> parts = pin.parts, gaps;
  const auto layer_of = [&](int part) { return layers.layers[static_cast<std::size_t>(part)]; };
  const auto has_hole = [&](int part) {
    const auto& holes = made.parts[static_cast<std::size_t>(part)].holes;
    return std::ranges::find(holes, pin.name, &PartHole::name) != holes.end();
  };
  std::ranges::sort(parts, {}, layer_of);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    int low = layer_of(parts[i]), high = layer_of(parts[i + 1]);
    if (order.boss && has_hole(parts[i])) {
      low = high - 1;
    } else if (order.boss && has_hole(parts[i + 1])) {
      high = low + 1;
    }
    for (int gap = low; gap < high; ++gap) gaps.push_back(gap);
  }
  return gaps;
}

ScrewChoice screw_of(const PinStack& stack, const PartOrder& order) {
  const Screw& screw = *order.screw;
  const double clamped =
      *stack_height(stack.high - stack.low + 1, order) + 2 * screw.washer_thickness;
  const double least = clamped + screw.nut_height + screw.pitch;
  const auto length = screw_length(screw, least);
  return {length.value_or(least), length.value_or(least) - clamped, !length};
}

std::optional<double> stack_height(int layers, const PartOrder& order) {
  if (!order.thickness) return std::nullopt;
  return layers * *order.thickness + (layers - 1) * order.washer;
}

PartBill part_bill(const PartMotion& moving, const LinkParts& made, const PartLayers& layers,
                   const PartOrder& order) {
  PartBill bill = BillMaker(made, layers, order).make(SpacerFinder(moving, made, layers, order));
  for (std::string& note : screw_room_notes(moving, made, layers, order)) {
    bill.notes.push_back(std::move(note));
  }
  return bill;
}

bool rings_fit(const PartMotion& moving, const LinkParts& made, const PartLayers& layers,
               const PartOrder& order, double diameter) {
  return SpacerFinder(moving, made, layers, order).fits(diameter);
}

std::string spacer_name(const BillRow& row, std::size_t number) {
  if (row.layers.size() == 1) return "spacer " + row.name;
  return fmt::format("spacer {} {}", row.name, number + 1);
}

void add_spacer_parts(const PartBill& bill, const PartOrder& order, LinkParts& made,
                      PartLayers& layers) {
  for (const BillRow& row : bill.rows) {
    if (row.item != "spacer") continue;
    for (std::size_t i = 0; i < row.layers.size(); ++i) {
      LinkPart ring{-1, spacer_name(row, i), {}, {}, {{}}, 0.5 * *row.outside};
      ring.holes.push_back({row.name, {}, true, order.hole});
      made.parts.push_back(std::move(ring));
      layers.layers.push_back(row.layers[i]);
    }
  }
}

std::string bill_csv(const PartBill& bill, std::optional<problems::LengthUnit> unit) {
  const std::string suffix = unit ? "_" + std::string(problems::length_word(unit)) : "";
  std::string text = "item,name,quantity,layers";
  for (const auto& [name, member] : kLengths) text += fmt::format(",{}{}", name, suffix);
  text += ",standard\r\n";
  const auto out = std::back_inserter(text);
  for (const BillRow& row : bill.rows) {
    fmt::format_to(out, "{},{},{},{}", row.item, csv_cell(row.name), row.quantity,
                   layers_text(row));
    for (const auto& [name, member] : kLengths) {
      if (row.*member) {
        fmt::format_to(out, ",{:.12g}", *(row.*member));
      } else {
        text += ',';
      }
    }
    text += ',' + row.standard + "\r\n";
  }
  return text;
}

ordered_json bill_json(const PartBill& bill) {
  ordered_json rows = ordered_json::array();
  for (const BillRow& row : bill.rows) {
    ordered_json entry = {{"item", row.item}, {"name", row.name}, {"quantity", row.quantity}};
    if (!row.layers.empty()) entry["layers"] = row.layers;
    for (const auto& [name, member] : kLengths) {
      if (row.*member) entry[name] = *(row.*member);
    }
    if (!row.standard.empty()) entry["standard"] = row.standard;
    rows.push_back(std::move(entry));
  }
  return rows;
}

}  // namespace cognate::app
