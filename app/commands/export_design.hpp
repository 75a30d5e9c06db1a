/// @file The files that are made of a design, apart from the command that writes them.
#pragma once

#include <string>

#include "app/console/options.hpp"
#include "app/export/exported.hpp"

namespace cognate::app {

/// By the kind that has mechanisms of this type alone, or as a linkage. `stem`: of the names of the
/// files.
ExportOutcome export_design(const ResultDesign& design, const ExportOptions& exporting,
                            const std::string& stem, const Options& options);

}  // namespace cognate::app
