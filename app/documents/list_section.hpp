/// @file A part of what `cognate list` says, as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "app/documents/catalogue.hpp"
#include "app/documents/mechanism_catalogue.hpp"

namespace cognate::app {

struct ListSection {
  std::string_view key;  ///< in the document
  std::string text;      ///< with its heading
  nlohmann::ordered_json json;
};

ListSection list_section(std::string_view key, std::string_view heading,
                         std::span<const Entry> entries);
ListSection list_section(std::string_view key, std::string_view heading,
                         std::span<const KeyedEntry> entries);

/// Metrics, or columns of a table, of one kind.
struct MetricList {
  std::string_view key;
  std::string_view heading;
  std::span<const Metric> metrics;
  bool of_design = true;  ///< metrics of a design, which reports and studies name
};

ListSection list_section(const MetricList& list);

}  // namespace cognate::app
