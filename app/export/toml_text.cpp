#include "app/export/toml_text.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

/// JSON's escapes are TOML's too; but JSON leaves DEL as it is.
std::string quoted(const std::string& text) {
  std::string json =
      ordered_json(text).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  for (auto at = json.find('\x7f'); at != std::string::npos; at = json.find('\x7f', at)) {
    json.replace(at, 1, "\\u007f");
  }
  return json;
}

/// A key without quotes where TOML allows it.
std::string key_text(const std::string& key) {
  const auto is_bare = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  return !key.empty() && std::ranges::all_of(key, is_bare) ? key : quoted(key);
}

void append(std::string& text, const ordered_json& value) {
  if (value.is_string()) {
    text += quoted(value.get<std::string>());
  } else if (!value.is_structured()) {
    text += value.dump();
  } else {
    text += value.is_object() ? '{' : '[';
    bool first = true;
    for (const auto& [key, member] : value.items()) {
      if (member.is_null()) continue;
      if (!first) text += ", ";
      first = false;
      if (value.is_object()) text += key_text(key) + " = ";
      append(text, member);
    }
    text += value.is_object() ? '}' : ']';
  }
}

void append_keys(std::string& text, const ordered_json& table) {
  for (const auto& [key, value] : table.items()) {
    if (value.is_null()) continue;
    text += key_text(key) + " = ";
    append(text, value);
    text += '\n';
  }
}

bool is_array_of_tables(const ordered_json& value) {
  return value.is_array() && !value.empty() &&
         std::ranges::all_of(value, [](const ordered_json& entry) { return entry.is_object(); });
}

}  // namespace

std::string toml_text(const ordered_json& tables) {
  ordered_json plain = ordered_json::object();
  std::string sections;
  for (const auto& [key, value] : tables.items()) {
    if (value.is_object()) {
      sections += "\n[" + key_text(key) + "]\n";
      append_keys(sections, value);
    } else if (is_array_of_tables(value)) {
      for (const auto& entry : value) {
        sections += "\n[[" + key_text(key) + "]]\n";
        append_keys(sections, entry);
      }
    } else {
      plain[key] = value;
    }
  }
  std::string text;
  append_keys(text, plain);
  return text + sections;
}

}  // namespace cognate::app
