#include "app/export/toml_text.hpp"

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
      if (value.is_object()) text += quoted(key) + " = ";
      append(text, member);
    }
    text += value.is_object() ? '}' : ']';
  }
}

}  // namespace

std::string toml_text(const ordered_json& tables) {
  std::string text;
  for (const auto& [key, value] : tables.items()) {
    if (value.is_null()) continue;
    text += quoted(key) + " = ";
    append(text, value);
    text += '\n';
  }
  return text;
}

}  // namespace cognate::app
