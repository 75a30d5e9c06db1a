#include "app/export/result_document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

namespace cognate::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 256U << 20U;
constexpr const char* kLengthUnit = "length_unit";
constexpr int kDeepest = 64;  // no result nests its values further

tl::unexpected<std::string> refusal(const std::string& name, std::string_view what) {
  return tl::unexpected(fmt::format("{}: {}", name, what));
}

tl::expected<std::string, std::string> text_in(const fs::path& file) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (!fs::exists(status)) {
    return refusal(
        file.string(),
        "the file does not exist or cannot be reached; expected the path of a result file");
  }
  if (fs::is_directory(status)) {
    return refusal(file.string(), "this is a directory; expected the path of a result file");
  }
  if (fs::is_block_file(status) || fs::is_socket(status)) {
    return refusal(file.string(),
                   "this is a device or a socket; expected a regular file or a pipe");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    return refusal(file.string(), "the file cannot be opened; expected a file that can be read");
  }
  std::string text;
  std::array<char, 1 << 16> part{};
  while (stream.read(part.data(), part.size()) || stream.gcount() > 0) {
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > kMostBytes) {
      return refusal(file.string(), "the file is larger than 256 MiB; at most 256 MiB are allowed");
    }
  }
  if (stream.bad()) {
    return refusal(file.string(), "the file cannot be read to its end; expected a whole file");
  }
  return text;
}

/// What the parser says without its own prefix: "[json.exception.…] parse error at line …: ".
std::string reason(const std::string& message) {
  const auto column = message.find(": ");
  return column == std::string::npos ? message : message.substr(column + 2);
}

/// The line and the column of byte `byte`, counted from 1.
std::string place(std::string_view text, std::size_t byte) {
  const auto before = text.substr(0, std::min(text.size(), byte > 0 ? byte - 1 : 0));
  const auto line = std::ranges::count(before, '\n') + 1;
  const auto begin = before.rfind('\n');
  return fmt::format("{}:{}", line,
                     begin == std::string_view::npos ? before.size() + 1 : before.size() - begin);
}

tl::expected<ordered_json, std::string> parse_json(std::string_view text, const std::string& name) {
  bool too_deep = false;
  const auto keep = [&](int depth, ordered_json::parse_event_t, ordered_json&) {
    too_deep = too_deep || depth > kDeepest;
    return !too_deep;
  };
  try {
    ordered_json document = ordered_json::parse(text, keep);
    if (!too_deep) return document;
    return refusal(name, "its values are nested too deep; expected a cognate-result/1");
  } catch (const ordered_json::parse_error& error) {
    return refusal(
        fmt::format("{}:{}", name, place(text, error.byte)),
        fmt::format("not valid JSON: {}; expected a cognate-result/1", reason(error.what())));
  } catch (const ordered_json::exception& error) {
    return refusal(
        name, fmt::format("not valid JSON: {}; expected a cognate-result/1", reason(error.what())));
  }
}

tl::expected<ordered_json, std::string> parse_result(std::string_view text,
                                                     const std::string& name) {
  auto document = parse_json(text, name);
  if (!document || text_under(*document, "format") == "cognate-result/1") return document;
  return refusal(name,
                 "this is no result of Cognate; expected a document with \"format\": "
                 "\"cognate-result/1\"");
}

}  // namespace

std::string stem_of_result(const std::filesystem::path& file) {
  const std::filesystem::path stem = file.stem();
  return stem.extension() == ".result" ? stem.stem().string() : stem.string();
}

std::string text_under(const ordered_json& table, const char* key) {
  if (!table.is_object()) return {};
  const auto found = table.find(key);
  return found != table.end() && found->is_string() ? found->get<std::string>() : std::string();
}

tl::expected<ResultDesign, std::string> parse_result_design(std::string_view text, int design,
                                                            const std::string& name) {
  return parse_result(text, name).and_then([&](const ordered_json& document) {
    return result_design(document, design, name);
  });
}

tl::expected<ResultDesign, std::string> result_design(const ordered_json& document, int design,
                                                      const std::string& name) {
  auto designs = document.value("designs", ordered_json());
  if (!designs.is_array() || designs.empty()) {
    return refusal(name, "this result has no design; expected a result with a design");
  }
  const auto index = static_cast<std::size_t>(design - 1);
  if (index >= designs.size()) {
    return refusal(name, fmt::format("there is no design {}; allowed is --design from 1 to {}",
                                     design, designs.size()));
  }
  ordered_json& wanted = designs[index];
  if (!wanted.is_object() ||
      text_under(wanted.value("mechanism", ordered_json()), "type").empty()) {
    return refusal(name,
                   fmt::format("designs[{}] has no mechanism with a type; expected one", index));
  }
  return ResultDesign{document.value("problem", ordered_json()), std::move(wanted), design, name};
}

tl::expected<ordered_json, std::string> read_result(const fs::path& file) {
  return text_in(file).and_then(
      [&](const std::string& text) { return parse_result(text, file.string()); });
}

tl::expected<ResultDesign, std::string> read_result_design(const fs::path& file, int design) {
  const auto text = text_in(file);
  if (!text) return tl::unexpected(text.error());
  return parse_result_design(*text, design, file.string());
}

std::optional<problems::LengthUnit> length_unit_of(const ResultDesign& design) {
  return problems::from_string<problems::LengthUnit>(text_under(design.problem, kLengthUnit));
}

tl::expected<ResultDesign, std::string> in_length_unit(ResultDesign design,
                                                       std::optional<problems::LengthUnit> unit) {
  if (!unit) return design;
  const auto own = length_unit_of(design);
  if (own && *own != *unit) {
    return refusal(
        design.name,
        fmt::format("the lengths are in {}, but --length-unit says {}; remove the option",
                    to_string(*own), to_string(*unit)));
  }
  if (!design.problem.is_object()) design.problem = ordered_json::object();
  design.problem[kLengthUnit] = to_string(*unit);
  return design;
}

ordered_json head_of(const ResultDesign& design, std::string_view kind) {
  ordered_json head = {{"kind", kind}, {"title", text_under(design.problem, "title")}};
  if (const auto unit = length_unit_of(design)) head[kLengthUnit] = to_string(*unit);
  return head;
}

}  // namespace cognate::app
