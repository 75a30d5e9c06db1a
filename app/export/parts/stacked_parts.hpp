/// @file Parts, their layers and what has to be made or bought of them.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "app/drawing/link_shapes.hpp"
#include "app/export/parts/part_bosses.hpp"

namespace cognate::app {

struct BilledParts {
  LinkParts made;
  PartLayers layers;
  PartBill bill;
  PartBosses bosses;
};

/// The parts of a linkage over the drive of `shown`; the error says which size is not possible, or
/// that `stop` ended the work.
tl::expected<BilledParts, std::string> stacked_parts(const Mechanism<double>& mechanism,
                                                     const LinkShapes& shown,
                                                     const PartOrder& order,
                                                     const std::function<bool()>& stop);

/// What is made to sizes of `[layers]`: holes as wide as pins, nothing that a file does not say.
PartOrder part_order(const problems::LayerSizes& sizes);

/// The bill of the linkage's parts to the sizes of its `layers` for a page: `rows` as those of an
/// export without options of sizes, `notes`, and `layers`, the frame among them. Null where there
/// are no sizes, where no parts can be made to them, or where it takes longer than a few seconds.
nlohmann::ordered_json bill_for_page(const LinkageScene& linkage);

}  // namespace cognate::app
