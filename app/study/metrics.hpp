/// @file The metrics that a study may ask for.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/documents/catalogue.hpp"
#include "problems/study/read.hpp"

namespace cognate::app {

/// The unit of the metric or column `name`, "deg", as `cognate list --metrics` has it or as the
/// name itself says ("..._deg", "..._N"); empty where it has none or it is not known.
std::string metric_unit(std::string_view name);

/// The names that a study of `base` may use: those of `cognate list --metrics`, and every number
/// and word of the best design in the result document by its place there ("error.rms",
/// "mechanism.coupler").
problems::MetricNames study_metrics(const problems::Task& base);

/// The study in `file` with these metrics, or every fault found in it.
tl::expected<problems::Study, std::vector<problems::Fault>> read_study(
    const std::filesystem::path& file);

/// Appends the keys of `listed`, each behind `within`.
void add_metrics(problems::MetricNames& names, std::span<const Metric> listed,
                 std::string_view within = "");

/// Values of a design that a study may take in addition to the metrics, for `cognate list`.
std::span<const Metric> study_extras();

/// The single keys that a catalogue lists in one entry: "a_at_1, _at_2" is a_at_1 and a_at_2,
/// "slide_1, slide_2, ..." slide_1 to slide_20.
std::vector<std::string> single_keys(std::string_view listed);

}  // namespace cognate::app
