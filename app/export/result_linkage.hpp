/// @file Linkages as result files tell of them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <tl/expected.hpp>

#include "app/drawing/linkage_scene.hpp"
#include "app/export/result_document.hpp"

namespace cognate::app {

/// The linkage of a design whose mechanism is none of type "cam", made anew of its table
/// `mechanism`. The drive is that of an analysis, else the range in which the linkage can be
/// assembled and that holds most of its stations, in 360 steps. The error is a message that begins
/// with the document's name: what is wrong; what is allowed.
tl::expected<LinkageScene, std::string> result_linkage(const ResultDesign& given);

/// The tables of a file that asks for the analysis of the design's mechanism: of an analysis those
/// that it was made of, of a synthesis the mechanism over the drive of `result_linkage`. The same
/// errors.
tl::expected<nlohmann::ordered_json, std::string> analysis_of_design(const ResultDesign& given);

/// "walk.design2": what files made of design 2 of walk.result.json are called.
std::string design_stem(const std::string& stem, int design);

}  // namespace cognate::app
