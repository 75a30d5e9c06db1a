/// @file The report pages before they have data; their text is assembled by the build.
#pragma once

#include <string>

namespace cognate::app {

/// The page of a design problem's result, with `@DATA@` once where the data belong.
std::string design_page();

/// The page of an analysis, likewise.
std::string analysis_page();

/// The page of a cam, likewise.
std::string cam_page();

/// The page of a machine, likewise.
std::string machine_page();

/// The page of a gear or a gear pair, likewise.
std::string gear_page();

/// The page of a gear train, likewise.
std::string train_page();

/// The page of a study, likewise.
std::string study_page();

/// The page on which a curve is drawn, likewise; its data are empty.
std::string sketch_page();

/// The page on which a mechanism is built, likewise.
std::string build_page();

/// The page of `cognate studio`, likewise.
std::string studio_page();

}  // namespace cognate::app
