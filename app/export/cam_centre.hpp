/// @file What a cam has at its centre.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "app/drawing/cam_drawing.hpp"
#include "app/drawing/plan.hpp"
#include "app/export/export_options.hpp"
#include "app/export/wheel_bore.hpp"

namespace cognate::app {

/// The bore and hub that are wanted, which lie within all cams of the drawing. The error says which
/// option is not possible and what is allowed.
tl::expected<WheelBore, std::string> cam_bore(const CamDrawing& drawing,
                                              const ExportOptions& wanted,
                                              std::optional<problems::LengthUnit> unit);

/// Adds bore, hub and mark to `plan`; the same errors.
tl::expected<void, std::string> add_cam_centre(const CamDrawing& drawing,
                                               const ExportOptions& wanted,
                                               std::optional<problems::LengthUnit> unit,
                                               Plan& plan);

}  // namespace cognate::app
