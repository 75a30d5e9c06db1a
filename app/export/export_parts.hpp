/// @file The parts of a linkage as files.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "analysis/mechanism/motion_state.hpp"
#include "app/drawing/link_shapes.hpp"
#include "app/drawing/plan.hpp"
#include "app/export/exported.hpp"

namespace cognate::app {

/// A linkage in one position.
struct PosedLinkage {
  const LinkageScene& scene;
  const LinkShapes& shown;
  std::span<const BodyMotion<double, 0>> bodies;
};

/// NAME.parts in the format wanted or the solids of the parts, and the bill of material where it is
/// wanted. The error says which option is not possible and what is allowed.
tl::expected<Exported, std::string> export_parts(const PosedLinkage& linkage,
                                                 const ExportOptions& wanted,
                                                 const std::string& stem, const Options& options);

/// The text of a drawing in `unit`; an error where numbers beyond all measure are in it.
tl::expected<std::string, std::string> drawn_text(Plan plan,
                                                  std::optional<problems::LengthUnit> unit,
                                                  const ExportOptions& wanted);

/// The text of a document; the same error.
tl::expected<std::string, std::string> document_text(const nlohmann::ordered_json& document);

}  // namespace cognate::app
