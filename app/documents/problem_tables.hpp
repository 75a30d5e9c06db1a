/// @file The tables that problem files of several kinds share, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/documents/json_values.hpp"
#include "problems/linkage/linkage_limits.hpp"

namespace cognate::app {

/// Sets `key` where there is a value.
void set(nlohmann::ordered_json& table, std::string_view key, const std::optional<double>& value);

/// The same for angles, in degrees.
void set_deg(nlohmann::ordered_json& table, std::string_view key,
             const std::optional<double>& value);
void set_deg(nlohmann::ordered_json& table, std::string_view key,
             const std::optional<problems::Range>& value);

/// The same for anything that `to_json` takes.
template <class Value>
void set_json(nlohmann::ordered_json& table, std::string_view key,
              const std::optional<Value>& value) {
  if (value) table[std::string(key)] = to_json(*value);
}

/// `kind` and `title`, to which the tables of the file are added.
nlohmann::ordered_json document(const char* kind, const std::string& title);

nlohmann::ordered_json mechanism_table(const problems::Given& given);
nlohmann::ordered_json bounds_table(const problems::Bounds& given);
nlohmann::ordered_json constraints_table(const problems::Constraints& given);
nlohmann::ordered_json solve_table(const problems::Solve& given);

}  // namespace cognate::app
