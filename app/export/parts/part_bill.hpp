/// @file The bill of material of parts.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/export/parts/link_parts.hpp"
#include "app/export/parts/part_layers.hpp"
#include "problems/basics/length_unit.hpp"

namespace cognate::app {

/// What has to be made or bought, in finished sizes; lengths that are not known are empty.
struct BillRow {
  std::string item;  ///< plate, cylinder, pin, screw, nut, spacer, washer, bearing
  std::string name;  ///< of the part, the pin, or the bearing's designation
  int quantity = 1;
  std::vector<int> layers;              ///< from 1, ascending; of a pin the first and the last
  std::optional<double> length, width;  ///< of the rectangle about a plate; of a pin its length
  std::optional<double> thickness;      ///< of bearings their width
  std::optional<double> outside, bore;  ///< diameters
  std::optional<double> stroke{};       ///< of a cylinder, whose length is the least, pivot to pin
  std::string standard{};               ///< with its size: "ISO 4762 M5x30"
};

struct PartBill {
  std::vector<BillRow> rows;
  std::vector<std::string> notes;
};

/// The layers from the lowest to the highest that a pin holds, and those between that hold no part
/// of it.
struct PinStack {
  int low = 0, high = 0;
  std::vector<int> crossed;
};
PinStack pin_stack(const PartPin& pin, const PartLayers& layers);

/// The gaps between layers in which a pin has a washer, each by the layer below it: all from its
/// lowest to its highest part, but where a boss joins two parts only the one that it leaves.
std::vector<int> washer_gaps(const PartPin& pin, const LinkParts& made, const PartLayers& layers,
                             const PartOrder& order);

/// The screw in the place of a pin.
struct ScrewChoice {
  double length = 0;  ///< nominal; with `too_long` what it would have to be
  double beyond = 0;  ///< its end above the washer that is under the nut
  bool too_long = false;
};

/// The shortest screw of the order that passes the stack, two washers and the nut, with a pitch to
/// spare.
ScrewChoice screw_of(const PinStack& stack, const PartOrder& order);

/// How high so many layers are, with the washers between them; empty without a thickness.
std::optional<double> stack_height(int layers, const PartOrder& order);

/// Plates, a driving cylinder, pins as long as the stack that they pass or screws with their nuts,
/// spacers in the layers that pins cross, washers between layers and under heads and nuts, and
/// bearings. All spacers are as wide as the links, or less where one would collide with a part or
/// another spacer anywhere on the motion; a note says where none fits.
PartBill part_bill(const PartMotion& moving, const LinkParts& made, const PartLayers& layers,
                   const PartOrder& order);

/// Whether rings of this outside diameter about all pins, in the layers that they cross, meet
/// nothing there anywhere on the motion.
bool rings_fit(const PartMotion& moving, const LinkParts& made, const PartLayers& layers,
               const PartOrder& order, double diameter);

/// What one of the spacers of a row is called: the number is added where the row has several.
std::string spacer_name(const BillRow& row, std::size_t number);

/// The spacers of the bill as parts after the others, each in its layer.
void add_spacer_parts(const PartBill& bill, const PartOrder& order, LinkParts& made,
                      PartLayers& layers);

/// `item`, `name`, `quantity`, `layers`, `length`, `width`, `thickness`, `outside`, `bore`,
/// `stroke`, `standard`: units in the header.
std::string bill_csv(const PartBill& bill, std::optional<problems::LengthUnit> unit);

/// The rows as objects of what is known.
nlohmann::ordered_json bill_json(const PartBill& bill);

}  // namespace cognate::app
